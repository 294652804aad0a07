// Generated code beside its document: read-only, and made anew while the document changes.
import * as vscode from 'vscode';
import { codeAddress, codeSource, shownCode } from './code_address';
import { Debounce } from './debounce';
import { activeDocument } from './documents';
import type { Api, Target } from './protocol';
import { pickRoot, rootsOf } from './roots';
import type { ServerProcess } from './server_process';

const scheme = 'texbrdf-code';
const quietMilliseconds = 120;

class GeneratedCode implements vscode.TextDocumentContentProvider {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.changed.event;
  private readonly lastGood = new Map<string, string>();
  private readonly soon = new Debounce(quietMilliseconds);

  constructor(private readonly api: Api) {}

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const answer = await this.api.emit(codeSource(uri.query)).catch((error: unknown) => ({ text: null, problem: String(error) }));
    const key = uri.toString();
    if (answer?.text !== null && answer?.text !== undefined) this.lastGood.set(key, answer.text);
    return shownCode(answer?.text, answer?.problem, this.lastGood.get(key));
  }

  sourceChanged(source: string): void {
    const shown = openCode().filter((uri) => codeSource(uri.query).uri === source);
    if (shown.length > 0) this.soon.run(() => { shown.forEach((uri) => { this.changed.fire(uri); }); });
  }

  refreshAll(): void {
    openCode().forEach((uri) => { this.changed.fire(uri); });
  }

  forget(uri: vscode.Uri): void {
    this.lastGood.delete(uri.toString());
  }
}

function openCode(): vscode.Uri[] {
  return vscode.workspace.textDocuments.map(({ uri }) => uri).filter((uri) => uri.scheme === scheme);
}

export function showGeneratedCode(server: ServerProcess, api: Api): vscode.Disposable {
  const code = new GeneratedCode(api);
  return vscode.Disposable.from(
    vscode.workspace.registerTextDocumentContentProvider(scheme, code),
    vscode.workspace.onDidChangeTextDocument(({ document }) => { code.sourceChanged(document.uri.toString()); }),
    vscode.workspace.onDidCloseTextDocument(({ uri }) => { if (uri.scheme === scheme) code.forget(uri); }),
    server.onStateChange(({ kind }) => { if (kind === 'ready') code.refreshAll(); }),
    vscode.commands.registerCommand('texbrdf.showGeneratedCode', () => show(server, api)),
  );
}

async function show(server: ServerProcess, api: Api): Promise<void> {
  const document = activeDocument();
  if (document === undefined) return;
  const target = await pickTarget();
  if (target === undefined) return;
  const uri = document.uri.toString();
  const root = await pickRoot(await rootsOf(server, api, uri));
  if (root === null) return;
  const address = codeAddress({ uri, target, ...(root === undefined ? {} : { root }) });
  const opened = await vscode.workspace.openTextDocument(vscode.Uri.from({ scheme, ...address }));
  const highlighted = await vscode.languages.setTextDocumentLanguage(opened, await shaderLanguage());
  await vscode.window.showTextDocument(highlighted, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: false });
}

async function pickTarget(): Promise<Target | undefined> {
  const targets: (vscode.QuickPickItem & { target: Target })[] = [
    { label: 'GLSL', description: 'functions for your own renderer', target: 'glsl' },
    { label: 'Disney BRDF Explorer', description: 'a .brdf file', target: 'disney' },
  ];
  return (await vscode.window.showQuickPick(targets, { title: 'Generated code for' }))?.target;
}

/** GLSL where an extension knows it; C++ comes near. */
async function shaderLanguage(): Promise<string> {
  const known = await vscode.languages.getLanguages();
  return ['glsl', 'cpp'].find((language) => known.includes(language)) ?? 'plaintext';
}
