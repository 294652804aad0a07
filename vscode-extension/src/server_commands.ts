// Commands about the server itself, and what its code lenses run.
import * as vscode from 'vscode';
import { lensCommands } from './protocol';
import type { ServerProcess } from './server_process';

export function serverCommands(server: ServerProcess): vscode.Disposable {
  return vscode.Disposable.from(
    vscode.commands.registerCommand('texbrdf.restartServer', () => server.restart()),
    vscode.commands.registerCommand('texbrdf.showLog', () => { server.log.show(); }),
    vscode.commands.registerCommand('texbrdf.setTrace', setTrace),
    vscode.commands.registerCommand(lensCommands.showReferences, showReferences),
  );
}

async function setTrace(): Promise<void> {
  const choice = await vscode.window.showQuickPick(['off', 'messages', 'verbose'], { title: 'What the log shows of the protocol' });
  if (choice !== undefined) await vscode.workspace.getConfiguration('texbrdf').update('trace.server', choice, vscode.ConfigurationTarget.Global);
}

async function showReferences(uri: string, { line, character }: { line: number; character: number }): Promise<void> {
  const document = vscode.Uri.parse(uri);
  const place = new vscode.Position(line, character);
  const found = await vscode.commands.executeCommand<vscode.Location[]>('vscode.executeReferenceProvider', document, place);
  await vscode.commands.executeCommand('editor.action.showReferences', document, place, found);
}
