// The way out of the page.
import type { FromPage } from '../messages';

/** A plain browser that shows the page remembers nothing. */
interface Host {
  postMessage(message: FromPage): void;
  getState?(): unknown;
  setState?(state: unknown): void;
}

declare function acquireVsCodeApi(): Host;

const api = acquireVsCodeApi();

export function tell(message: FromPage): void {
  api.postMessage(message);
}

/** Keeps this beside what is kept already: the page is made anew when its tab was hidden, or its window loaded again. */
export function keep(part: object): void {
  api.setState?.({ ...kept(), ...part });
}

export function kept(): Record<string, unknown> {
  return { ...api.getState?.() as object | undefined };
}

/** The element of the page with this id; it is there, for the page is ours. */
export function element<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

/** Calls the action with the last of what it is given, at most once a frame. */
export function oncePerFrame<T>(action: (value: T) => void): (value: T) => void {
  let waiting: { value: T } | undefined;
  return (value) => {
    if (waiting === undefined) {
      requestAnimationFrame(() => {
        const last = waiting;
        waiting = undefined;
        if (last !== undefined) action(last.value);
      });
    }
    waiting = { value };
  };
}
