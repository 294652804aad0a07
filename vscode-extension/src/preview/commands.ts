// Opening the preview: from the palette, the editor's title, a code lens.
import * as vscode from 'vscode';
import { activeDocument, isScene } from '../documents';
import { lensCommands } from '../protocol';
import type { Api } from '../protocol';
import { pickRoot, rootsOf } from '../roots';
import type { ServerProcess } from '../server_process';
import type { PreviewPanel } from './panel';

export function previewCommands(server: ServerProcess, api: Api, panel: PreviewPanel): vscode.Disposable {
  const open = async (column: vscode.ViewColumn, uri?: vscode.Uri) => {
    const document = uri === undefined ? activeDocument() : await vscode.workspace.openTextDocument(uri);
    if (document === undefined) {
      void vscode.window.showInformationMessage('texbrdf: open a LaTeX document or a scene first.');
      return;
    }
    if (!drawable(server)) return;
    if (isScene(document)) {
      await panel.open(document, undefined, column);
      return;
    }
    const root = await pickRoot(await rootsOf(server, api, document.uri.toString()));
    if (root !== null) await panel.open(document, root, column);
  };
  const openRoot = async (uri: string, root: string) => {
    if (!drawable(server)) return;
    const isTheDocuments = (await rootsOf(server, api, uri)).root === root;
    await panel.open(await vscode.workspace.openTextDocument(vscode.Uri.parse(uri)), isTheDocuments ? undefined : root, vscode.ViewColumn.Beside);
  };
  return vscode.Disposable.from(
    vscode.commands.registerCommand('texbrdf.openPreview', (uri?: vscode.Uri) => open(vscode.ViewColumn.Active, uri)),
    vscode.commands.registerCommand('texbrdf.openPreviewToSide', (uri?: vscode.Uri) => open(vscode.ViewColumn.Beside, uri)),
    vscode.commands.registerCommand(lensCommands.preview, openRoot),
  );
}

function drawable(server: ServerProcess): boolean {
  if (server.canPreview) return true;
  const why = server.running ? 'this texbrdf is too old to draw' : 'the server does not run';
  void vscode.window.showWarningMessage(`texbrdf: ${why}.`, 'Show log').then((choice) => {
    if (choice !== undefined) server.log.show();
  });
  return false;
}
