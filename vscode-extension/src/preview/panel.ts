// The preview's tab: a webview with a session behind it, which follows the active document.
import { randomBytes } from 'node:crypto';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { activeDocument, findDocument, isScene } from '../documents';
import type { Api, Location, Look } from '../protocol';
import { rootsOf } from '../roots';
import type { ServerProcess } from '../server_process';
import type { TextChange } from '../text_changes';
import { wordsOf } from '../words_of';
import { memoryFrom } from './memory';
import type { FromPage, ToPage } from './messages';
import { webviewPage } from './page';
import { Session } from './session';
import { standardLook } from './standard_look';

const viewType = 'texbrdf.preview';

export class PreviewPanel implements vscode.WebviewPanelSerializer, vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private session: Session | undefined;
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly context: vscode.ExtensionContext, private readonly server: ServerProcess, private readonly api: Api) {
    this.subscriptions = [
      vscode.window.registerWebviewPanelSerializer(viewType, this),
      server.onFrame((frame) => this.session?.frameArrived(frame)),
      server.onPreviewState((state) => this.session?.stateArrived(state)),
      this.reopenAfterRestart(),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.session?.documentChanged(document.uri.toString(), document.version)),
      vscode.workspace.onDidCloseTextDocument((document) => this.session?.documentClosed(document.uri.toString())),
      vscode.window.onDidChangeActiveTextEditor(() => void this.follow()),
    ];
  }

  async open(document: vscode.TextDocument, root: string | undefined, column: vscode.ViewColumn): Promise<void> {
    if (this.panel === undefined) this.create(column);
    else this.panel.reveal(undefined, true);
    await this.show(document, root);
  }

  dispose(): void {
    this.panel?.dispose();
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** The tab of a window that is loaded again. */
  async deserializeWebviewPanel(panel: vscode.WebviewPanel, kept: unknown): Promise<void> {
    const memory = memoryFrom((kept as { session?: unknown } | undefined)?.session);
    if (memory === undefined || this.panel !== undefined) {
      panel.dispose();
      return;
    }
    const session = this.adopt(panel, memory.look);
    try {
      const document = await vscode.workspace.openTextDocument(vscode.Uri.parse(memory.uri));
      if (this.session === session && session.uri === undefined) await this.show(document, memory.root);
    } catch (error) {
      report(wordsOf(error));
      panel.dispose();
    }
  }

  private create(column: vscode.ViewColumn): void {
    this.adopt(vscode.window.createWebviewPanel(viewType, 'BRDF preview', { viewColumn: column, preserveFocus: true }));
  }

  private adopt(panel: vscode.WebviewPanel, look?: Look): Session {
    const dist = vscode.Uri.joinPath(this.context.extensionUri, 'dist');
    const media = vscode.Uri.joinPath(this.context.extensionUri, 'media');
    panel.webview.options = { enableScripts: true, localResourceRoots: [dist, media] };
    const session = new Session({
      api: this.api,
      post: (message: ToPage) => void panel.webview.postMessage(message),
      roots: (uri) => rootsOf(this.server, this.api, uri),
      apply, reveal, saveImage, saveTable, report, standardLook,
    }, look);
    panel.iconPath = vscode.Uri.joinPath(media, 'sphere.svg');
    panel.webview.onDidReceiveMessage((message: FromPage) => void session.pageSays(message));
    panel.onDidChangeViewState(() => { if (!panel.visible) session.pageLost(); });
    panel.onDidDispose(() => {
      session.close();
      this.panel = undefined;
      this.session = undefined;
    });
    panel.webview.html = webviewPage({
      nonce: randomBytes(16).toString('hex'),
      scriptUri: panel.webview.asWebviewUri(vscode.Uri.joinPath(dist, 'preview.js')).toString(),
      styleUri: panel.webview.asWebviewUri(vscode.Uri.joinPath(media, 'preview.css')).toString(),
      source: panel.webview.cspSource,
    });
    this.panel = panel;
    this.session = session;
    return session;
  }

  private async show(document: vscode.TextDocument, root: string | undefined): Promise<void> {
    if (this.panel === undefined) return;
    const name = path.posix.basename(document.uri.path);
    this.panel.title = isScene(document) ? `Scene ${name}` : `BRDF ${name}`;
    await this.session?.show({ uri: document.uri.toString(), name, version: document.version, root });
  }

  private async follow(): Promise<void> {
    if (vscode.window.activeTextEditor === undefined) return; // A pane has the focus.
    const document = activeDocument();
    if (document === undefined || this.session?.uri === document.uri.toString()) return;
    if (this.session === undefined || !vscode.workspace.getConfiguration('texbrdf').get<boolean>('preview.followEditor', true)) return;
    if (isScene(document)) {
      await this.show(document, undefined);
      return;
    }
    const { root, candidates } = await rootsOf(this.server, this.api, document.uri.toString());
    if (activeDocument() === document && (root !== null || candidates.length > 0)) await this.show(document, undefined);
  }

  private reopenAfterRestart(): vscode.Disposable {
    let ran = this.server.running;
    return this.server.onStateChange(() => {
      if (!ran && this.server.canPreview) void this.session?.reopen();
      ran = this.server.running;
    });
  }
}

async function apply(changes: TextChange[]): Promise<boolean> {
  const isOld = ({ uri, version }: TextChange) => version !== null && findDocument(uri)?.version !== version;
  if (changes.some(isOld)) return false;
  const whole = new vscode.WorkspaceEdit();
  for (const { uri, range: { start, end }, newText } of changes) {
    whole.replace(vscode.Uri.parse(uri), new vscode.Range(start.line, start.character, end.line, end.character), newText);
  }
  return vscode.workspace.applyEdit(whole);
}

async function show({ uri, range: { start, end } }: Location): Promise<void> {
  const editor = await vscode.window.showTextDocument(vscode.Uri.parse(uri), { viewColumn: columnOf(uri) });
  editor.selection = new vscode.Selection(start.line, start.character, end.line, end.character);
  editor.revealRange(editor.selection, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}

function reveal(place: Location): void {
  show(place).catch((error: unknown) => { report(wordsOf(error)); });
}

function columnOf(uri: string): vscode.ViewColumn {
  return vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === uri)?.viewColumn ?? vscode.ViewColumn.One;
}

async function save(content: Buffer, proposal: string, filters: Record<string, string[]>): Promise<void> {
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri;
  const target = await vscode.window.showSaveDialog({
    filters,
    ...(folder === undefined ? {} : { defaultUri: vscode.Uri.joinPath(folder, proposal) }),
  });
  if (target !== undefined) await vscode.workspace.fs.writeFile(target, content);
}

function saveImage(png: string, name: string): void {
  const proposal = `${name.replace(/\.\w+$/, '')}.png`;
  save(Buffer.from(png, 'base64'), proposal, { Pictures: ['png'] }).catch((error: unknown) => { report(wordsOf(error)); });
}

function saveTable(table: string, fileName: string): void {
  save(Buffer.from(table, 'utf8'), fileName, { Tables: ['csv'] }).catch((error: unknown) => { report(wordsOf(error)); });
}

function report(problem: string): void {
  void vscode.window.showWarningMessage(`texbrdf: ${problem}`);
}
