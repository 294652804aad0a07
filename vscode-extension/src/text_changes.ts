// The changes of text that edits of the server ask for.
import type { Range, WorkspaceEdit } from 'vscode-languageserver-protocol';

export interface TextChange {
  uri: string;
  /** Of the document that the change is made for; null where that does not matter. */
  version: number | null;
  range: Range;
  newText: string;
}

export function textChanges(edits: WorkspaceEdit[]): TextChange[] {
  return edits.flatMap(({ documentChanges, changes }) => {
    if (documentChanges === undefined) {
      return Object.entries(changes ?? {}).flatMap(([uri, list]) => list.map(({ range, newText }) => ({ uri, version: null, range, newText })));
    }
    return documentChanges.flatMap((change) => {
      if (!('textDocument' in change)) return [];
      const { uri, version } = change.textDocument;
      return change.edits.map(({ range, newText }) => ({ uri, version, range, newText }));
    });
  });
}
