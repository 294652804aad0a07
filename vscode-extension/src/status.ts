// The item of the status bar: whether the server is there, and if not, why.
import * as vscode from 'vscode';
import { activeDocument } from './documents';
import type { ServerProcess, ServerState } from './server_process';

export function showStatus(server: ServerProcess): vscode.Disposable {
  const item = vscode.window.createStatusBarItem('texbrdf.status', vscode.StatusBarAlignment.Right, 50);
  item.name = 'texbrdf';
  item.command = 'texbrdf.showLog';
  const refresh = () => {
    const state = server.state;
    Object.assign(item, { text: text(state), tooltip: tooltip(state) });
    item.backgroundColor = state.kind === 'failed' ? new vscode.ThemeColor('statusBarItem.errorBackground') : undefined;
    item.accessibilityInformation = { label: `texbrdf: ${sentence(state)}` };
    if (state.kind === 'failed' || activeDocument() !== undefined) item.show();
    else item.hide();
  };
  refresh();
  return vscode.Disposable.from(item, server.onStateChange(refresh), vscode.window.onDidChangeActiveTextEditor(refresh));
}

function text(state: ServerState): string {
  switch (state.kind) {
    case 'ready': return '$(check) texbrdf';
    case 'starting':
    case 'busy': return '$(sync~spin) texbrdf';
    case 'failed': return '$(error) texbrdf';
    case 'stopped': return '$(circle-slash) texbrdf';
  }
}

function sentence(state: ServerState): string {
  switch (state.kind) {
    case 'ready': return `ready, version ${state.version}`;
    case 'starting': return 'starting';
    case 'busy': return state.what;
    case 'failed': return `does not run: ${state.reason}`;
    case 'stopped': return 'not started';
  }
}

function tooltip(state: ServerState): vscode.MarkdownString {
  const markdown = new vscode.MarkdownString().appendText(`texbrdf: ${sentence(state)}`);
  markdown.appendMarkdown('\n\n[Restart](command:texbrdf.restartServer) · [Log](command:texbrdf.showLog) · [Trace](command:texbrdf.setTrace)');
  markdown.isTrusted = { enabledCommands: ['texbrdf.restartServer', 'texbrdf.showLog', 'texbrdf.setTrace'] };
  return markdown;
}
