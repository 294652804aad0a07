// Messages on their way to the server. One post at a time keeps them in order; what comes in the meantime goes with the next.

const retryAfter = 100; // ms
const mostTogether = 50;

/** The status of HTTP; rejects where there is no answer. */
export type Post = (address: string, body: string) => Promise<number>;

const busy = 503;

export class Outgoing {
  private waiting: { text: string; refused: () => void }[] = [];
  private address: string | undefined;
  private posting = false;

  constructor(private readonly post: Post) {}

  open(address: string): void {
    this.address = address;
    void this.flush();
  }

  /** What waits is forgotten: it was meant for a server that is gone. */
  close(): void {
    this.address = undefined;
    this.waiting = [];
  }

  /** `refused` is called where the server does not take it. */
  add(message: object, refused: () => void = () => undefined): void {
    if (this.address === undefined) return;
    this.waiting.push({ text: JSON.stringify(message), refused });
    void this.flush();
  }

  private async flush(): Promise<void> {
    if (this.posting) return;
    this.posting = true;
    while (this.address !== undefined && this.waiting.length > 0) await this.postSome(this.address);
    this.posting = false;
  }

  /** While the server is busy, or not reached, the same is tried once more, later. What it refuses otherwise it would refuse again. */
  private async postSome(address: string): Promise<void> {
    const together = this.waiting.slice(0, mostTogether);
    const status = await this.post(address, together.map(({ text }) => text).join('\n')).catch(() => busy);
    if (this.address !== address) return;
    if (status !== busy) {
      this.waiting.splice(0, together.length);
      if (status >= 400) together.forEach(({ refused }) => { refused(); });
    } else {
      await new Promise((resolve) => { setTimeout(resolve, retryAfter); });
    }
  }
}
