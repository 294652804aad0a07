// When a server that crashed is started again: at once, then after longer and longer pauses, and not after five crashes within a few minutes.

export const mostCrashes = 5;
export const withinMilliseconds = 3 * 60 * 1000;
const firstPause = 250;
const longestPause = 10_000;

export class CrashPolicy {
  private crashes: number[] = [];

  /** The pause before the next start in milliseconds, or undefined: give up. */
  crashed(now: number): number | undefined {
    this.crashes = this.crashes.filter((time) => now - time < withinMilliseconds);
    this.crashes.push(now);
    if (this.crashes.length >= mostCrashes) return undefined;
    const earlier = this.crashes.length - 1;
    return earlier === 0 ? 0 : Math.min(firstPause * 2 ** earlier, longestPause);
  }

  /** Somebody started it on purpose. */
  forget(): void {
    this.crashes = [];
  }
}
