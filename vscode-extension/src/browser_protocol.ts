// What a browser and `texbrdf lsp --preview-port` say to each other beyond protocol.ts (docs/lsp.md). No other file names these methods.
import type { Events, Location } from './protocol';
import type { TextChange } from './text_changes';

/** The document that was opened or edited last in the editor. */
export type FollowedDocument = { uri: string; name: string; version: number } | { uri: null };

export interface Edited {
  edit: number;
  applied: boolean;
}

export interface BrowserRequests {
  /** The answer says only that the editor was asked; `edited` says what it did. */
  'texbrdf/applyEdit': [{ changes: TextChange[] }, { edit: number }];
  'texbrdf/reveal': [Location, null];
}

export interface BrowserEvents extends Events {
  /** The first of a connection. */
  'texbrdf/welcome': { client: number };
  'texbrdf/document': FollowedDocument;
  'texbrdf/edited': Edited;
}

/** Relative to the page. */
export const eventsAddress = 'events';
export const messagesAddress = (client: number) => `messages/${client}`;
