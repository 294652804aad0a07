// The page was made for a webview of VS Code. Here its two ways out and in lead to a session in the same window.
import type { FromPage, ToPage } from '../messages';

let listener: (message: FromPage) => void = () => undefined;

Object.assign(globalThis, {
  acquireVsCodeApi: () => ({
    postMessage: (message: FromPage) => { listener(message); },
    getState: () => undefined,
    setState: () => undefined,
  }),
});

export function onPageMessage(listen: (message: FromPage) => void): void {
  listener = listen;
}

export function postToPage(message: ToPage): void {
  window.dispatchEvent(new MessageEvent('message', { data: message, origin: window.origin }));
}
