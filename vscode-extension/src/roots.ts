// Which definitions of a document may be drawn; and the context key that shows the preview's icon.
import * as vscode from 'vscode';
import { Debounce } from './debounce';
import { activeDocument, isScene } from './documents';
import type { Api, Roots } from './protocol';
import type { ServerProcess } from './server_process';

const contextKey = 'texbrdf.hasBrdf';
const none: Roots = { root: null, candidates: [] };

export async function rootsOf(server: ServerProcess, api: Api, uri: string): Promise<Roots> {
  return server.canPreview ? api.roots(uri).catch(() => none) : none;
}

/** Keeps the context key right for the active editor. */
export function watchRoots(server: ServerProcess, api: Api): vscode.Disposable {
  const soon = new Debounce(150);
  const refresh = async () => {
    if (vscode.window.activeTextEditor === undefined) return; // A pane has the focus: the icon of the editor beside it stays.
    const document = activeDocument();
    if (document !== undefined && isScene(document)) {
      await vscode.commands.executeCommand('setContext', contextKey, true);
      return;
    }
    const { root, candidates } = document === undefined ? none : await rootsOf(server, api, document.uri.toString());
    if (activeDocument() === document) await vscode.commands.executeCommand('setContext', contextKey, root !== null || candidates.length > 0);
  };
  const later = () => { soon.run(() => void refresh()); };
  return vscode.Disposable.from(
    vscode.window.onDidChangeActiveTextEditor(() => void refresh()),
    vscode.workspace.onDidChangeTextDocument(({ document }) => { if (document === activeDocument()) later(); }),
    server.onStateChange(later),
    { dispose: () => { soon.cancel(); } },
  );
}

/** What to draw: undefined where the document's own choice is to hold; null where the user changed their mind. */
export async function pickRoot(roots: Roots): Promise<string | undefined | null> {
  if (roots.candidates.length < 2) return undefined;
  const items = roots.candidates.map((name) => ({ label: name, description: name === roots.root ? 'what the document says' : '' }));
  items.sort((a, b) => Number(b.label === roots.root) - Number(a.label === roots.root));
  const choice = await vscode.window.showQuickPick(items, { title: 'Preview of which definition?' });
  if (choice === undefined) return null;
  return choice.label === roots.root ? undefined : choice.label;
}
