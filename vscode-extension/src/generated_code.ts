// Generated code beside its document: read-only, and made anew while the document changes.
import * as vscode from 'vscode';
import { codeAddress, codeSource, shownCode } from './code_address';
import { linkCode } from './code_links';
import type { CodeDocuments } from './code_links';
import { Debounce } from './debounce';
import { activeDocument, isScene } from './documents';
import type { Api, Place, Target } from './protocol';
import { pickRoot, rootsOf } from './roots';
import type { ServerProcess } from './server_process';
import { wordsOf } from './words_of';

const scheme = 'texbrdf-code';
const quietMilliseconds = 120;

interface Made {
  text: string;
  places: readonly Place[];
  /** Broken: the document has errors, the code is an earlier one. Outdated: it is being made anew. */
  state: 'good' | 'broken' | 'outdated';
}

class GeneratedCode implements vscode.TextDocumentContentProvider, CodeDocuments {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly wasMade = new vscode.EventEmitter<void>();
  readonly scheme = scheme;
  readonly onDidChange = this.changed.event;
  readonly onDidMake = this.wasMade.event;
  private readonly made = new Map<string, Made>();
  private readonly soon = new Debounce(quietMilliseconds);
  /** For each question that is on its way, the sources that changed meanwhile. */
  private readonly asked = new Set<Set<string>>();

  constructor(private readonly api: Api) {}

  places = (code: vscode.Uri): readonly Place[] | undefined => {
    const made = this.made.get(code.toString());
    if (made === undefined || made.state === 'outdated') return undefined;
    return made.state === 'good' ? made.places : [];
  };

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const changed = new Set<string>();
    this.asked.add(changed);
    const answer = await this.api.emit(codeSource(uri.query)).catch((error: unknown) => ({ text: null, problem: wordsOf(error) }));
    this.asked.delete(changed);
    const key = uri.toString();
    const last = this.made.get(key);
    if (answer?.text !== null && answer?.text !== undefined) this.made.set(key, { text: answer.text, places: normal(answer.places), state: 'good' });
    else if (last !== undefined) this.made.set(key, { ...last, state: 'broken' });
    if ([...changed].some((source) => this.isMadeOf(uri, source))) {
      this.outdate(uri);
      this.refreshSoon();
    }
    setTimeout(() => { this.wasMade.fire(); }, 0); // The text is shown first.
    return shownCode(answer?.text, answer?.problem, last?.text);
  }

  sourceChanged(source: string): void {
    for (const changed of this.asked) changed.add(source);
    const shown = openCode().filter((uri) => this.isMadeOf(uri, source));
    shown.forEach((uri) => { this.outdate(uri); });
    if (shown.length > 0) this.refreshSoon();
  }

  refreshAll(): void {
    openCode().forEach((uri) => { this.changed.fire(uri); });
  }

  /** One that changes its language is closed and opened, too. */
  forgetClosed(): void {
    const open = new Set(openCode().map(String));
    for (const key of this.made.keys()) if (!open.has(key)) this.made.delete(key);
  }

  private refreshSoon(): void {
    this.soon.run(() => { openCode().filter((uri) => this.places(uri) === undefined).forEach((uri) => { this.changed.fire(uri); }); });
  }

  /** Also of what its document includes. */
  private isMadeOf(uri: vscode.Uri, source: string): boolean {
    return codeSource(uri.query).uri === source || (this.made.get(uri.toString())?.places.some((place) => place.uri === source) ?? false);
  }

  private outdate(uri: vscode.Uri): void {
    const made = this.made.get(uri.toString());
    if (made !== undefined) made.state = 'outdated';
  }
}

/** With URIs as the editor writes them. */
function normal(places: readonly Place[] = []): Place[] {
  return places.map((place) => ({ ...place, uri: vscode.Uri.parse(place.uri).toString() }));
}

function openCode(): vscode.Uri[] {
  return vscode.workspace.textDocuments.map(({ uri }) => uri).filter((uri) => uri.scheme === scheme);
}

export function showGeneratedCode(server: ServerProcess, api: Api): vscode.Disposable {
  const code = new GeneratedCode(api);
  return vscode.Disposable.from(
    vscode.workspace.registerTextDocumentContentProvider(scheme, code),
    linkCode(code),
    vscode.workspace.onDidChangeTextDocument(({ document }) => { code.sourceChanged(document.uri.toString()); }),
    vscode.workspace.onDidCloseTextDocument(({ uri }) => { if (uri.scheme === scheme) code.forgetClosed(); }),
    server.onStateChange(({ kind }) => { if (kind === 'ready') code.refreshAll(); }),
    vscode.commands.registerCommand('texbrdf.showGeneratedCode', () => show(server, api)),
  );
}

async function show(server: ServerProcess, api: Api): Promise<void> {
  const document = activeDocument();
  if (document === undefined || isScene(document)) return;
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
