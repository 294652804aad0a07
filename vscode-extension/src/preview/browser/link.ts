// The server of a page in a browser: messages are posted, answers and events come over one stream.
import { eventsAddress, messagesAddress } from '../../browser_protocol';
import type { BrowserEvents, BrowserRequests } from '../../browser_protocol';
import type { Connection, Notifications, Requests } from '../../protocol';
import { Outgoing } from './outgoing';

type AllRequests = Requests & BrowserRequests;
type Listeners = { [E in keyof BrowserEvents]?: (params: BrowserEvents[E]) => void };

interface Incoming {
  id?: number;
  method?: string;
  params?: unknown;
  result?: unknown;
  error?: { message: string };
}

interface Waiting {
  resolve: (result: never) => void;
  reject: (error: Error) => void;
}

export class Link implements Connection {
  private readonly waiting = new Map<number, Waiting>();
  private readonly listeners: Listeners = {};
  private readonly outgoing = new Outgoing(post);
  private lastId = 0;

  /** `onLost` is called when the server is gone; the browser tries to find it again. */
  constructor(onLost: () => void) {
    this.on('texbrdf/welcome', ({ client }) => { this.outgoing.open(messagesAddress(client)); });
    const source = new EventSource(eventsAddress);
    source.onmessage = (event: MessageEvent<string>) => { this.receive(JSON.parse(event.data) as Incoming); };
    source.onerror = () => {
      this.outgoing.close();
      for (const { reject } of this.waiting.values()) reject(new Error('texbrdf is gone'));
      this.waiting.clear();
      onLost();
    };
  }

  /** Adds to what listens to the event already. */
  on<E extends keyof BrowserEvents>(event: E, listener: (params: BrowserEvents[E]) => void): void {
    const before = this.listeners[event] as ((params: BrowserEvents[E]) => void) | undefined;
    const both = (params: BrowserEvents[E]) => {
      before?.(params);
      listener(params);
    };
    Object.assign(this.listeners, { [event]: both });
  }

  request<M extends keyof AllRequests>(method: M, params: AllRequests[M][0]): Promise<AllRequests[M][1]> {
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.outgoing.add({ jsonrpc: '2.0', id, method, params }, () => {
        this.waiting.delete(id);
        reject(new Error('texbrdf refused the request'));
      });
    });
  }

  notify<M extends keyof Notifications>(method: M, params: Notifications[M]): void {
    this.outgoing.add({ jsonrpc: '2.0', method, params });
  }

  private receive({ id, method, params, result, error }: Incoming): void {
    if (method !== undefined) {
      const listener = this.listeners[method as keyof BrowserEvents] as ((params: unknown) => void) | undefined;
      listener?.(params);
      return;
    }
    const waiting = this.waiting.get(id ?? 0);
    if (waiting === undefined) return;
    this.waiting.delete(id ?? 0);
    if (error === undefined) waiting.resolve(result as never);
    else waiting.reject(new Error(error.message));
  }
}

async function post(address: string, body: string): Promise<number> {
  const { status } = await fetch(address, { method: 'POST', headers: { 'Content-Type': 'application/json' }, body });
  return status;
}
