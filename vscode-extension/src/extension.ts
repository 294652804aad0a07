// The extension: puts its parts together, and starts the server with the first document that is ours.
import * as vscode from 'vscode';
import { isOurs, watchActiveDocument } from './documents';
import { exportCommand } from './export';
import { showGeneratedCode } from './generated_code';
import { previewCommands } from './preview/commands';
import { PreviewPanel } from './preview/panel';
import { Api } from './protocol';
import { watchRoots } from './roots';
import { serverCommands } from './server_commands';
import { ServerProcess } from './server_process';
import { showStatus } from './status';
import { walkthroughCommands } from './walkthrough';

let server: ServerProcess | undefined;

export function activate(context: vscode.ExtensionContext): void {
  const started = new ServerProcess(context);
  const api = new Api(started);
  const panel = new PreviewPanel(context, started, api);
  server = started;
  context.subscriptions.push(
    started, panel,
    watchActiveDocument(),
    showStatus(started),
    watchRoots(started, api),
    serverCommands(started),
    previewCommands(started, api, panel),
    showGeneratedCode(started, api),
    exportCommand(started),
    walkthroughCommands(context),
    vscode.workspace.onDidOpenTextDocument((document) => { startFor(started, [document]); }),
    vscode.workspace.onDidGrantWorkspaceTrust(() => { if (started.state.kind === 'failed') void started.restart(); }),
    vscode.workspace.onDidChangeConfiguration((event) => {
      const another = ['texbrdf.server.path', 'texbrdf.markdown.enabled'].some((name) => event.affectsConfiguration(name));
      if (another && started.state.kind !== 'stopped') void started.restart();
      else if (another) startFor(started, vscode.workspace.textDocuments);
    }),
  );
  startFor(started, vscode.workspace.textDocuments);
}

export function deactivate(): Promise<void> | undefined {
  return server?.stop();
}

function startFor(started: ServerProcess, documents: readonly vscode.TextDocument[]): void {
  if (started.state.kind === 'stopped' && documents.some(isOurs)) void started.start();
}
