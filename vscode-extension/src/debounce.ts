/** Calls what it was last given after so many quiet milliseconds. */
export class Debounce {
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly milliseconds: number) {}

  run(action: () => void): void {
    this.cancel();
    this.timer = setTimeout(action, this.milliseconds);
  }

  cancel(): void {
    if (this.timer !== undefined) clearTimeout(this.timer);
    this.timer = undefined;
  }
}
