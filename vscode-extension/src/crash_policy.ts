// When a server that crashed is started again: at once, then after longer and longer pauses, and not after five crashes within a few minutes.

const pauses = [0, 500, 1000, 2000]; // ms
export const mostCrashes = pauses.length + 1;
export const withinMilliseconds = 3 * 60 * 1000;

export class CrashPolicy {
  private crashes: number[] = [];

  /** The pause before the next start in milliseconds, or undefined: give up. */
  crashed(now: number): number | undefined {
    this.crashes = this.crashes.filter((time) => now - time < withinMilliseconds);
    this.crashes.push(now);
    return pauses[this.crashes.length - 1];
  }

  /** Somebody started it on purpose. */
  forget(): void {
    this.crashes = [];
  }
}
