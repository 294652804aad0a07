// Messages on their way to the server. One post at a time keeps them in order; what comes in the meantime goes with the next.

const retryAfter = 100; // ms
const mostTogether = 50;

export type Post = (address: string, body: string) => Promise<boolean>;

export class Outgoing {
  private waiting: string[] = [];
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

  add(message: object): void {
    if (this.address === undefined) return;
    this.waiting.push(JSON.stringify(message));
    void this.flush();
  }

  private async flush(): Promise<void> {
    if (this.posting) return;
    this.posting = true;
    while (this.address !== undefined && this.waiting.length > 0) await this.postSome(this.address);
    this.posting = false;
  }

  /** The server refuses more while it is busy: the same is tried once more, later. */
  private async postSome(address: string): Promise<void> {
    const together = this.waiting.slice(0, mostTogether);
    const taken = await this.post(address, together.join('\n')).catch(() => false);
    if (this.address !== address) return;
    if (taken) this.waiting.splice(0, together.length);
    else await new Promise((resolve) => { setTimeout(resolve, retryAfter); });
  }
}
