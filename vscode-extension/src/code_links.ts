// An equation and its generated code mark each other: what is selected in one is revealed in the other.
import * as vscode from 'vscode';
import { placeAt, placeOfLine } from './code_places';
import type { Place } from './protocol';
import { wordsOf } from './words_of';

export interface CodeDocuments {
  scheme: string;
  /** Of a document of code; undefined while it is made anew. */
  places: (code: vscode.Uri) => readonly Place[] | undefined;
  onDidMake: vscode.Event<void>;
}

const highlight: vscode.DecorationRenderOptions = {
  backgroundColor: new vscode.ThemeColor('editor.selectionHighlightBackground'),
  overviewRulerColor: new vscode.ThemeColor('editorOverviewRuler.selectionHighlightForeground'),
};

class CodeLinks {
  private readonly equationMark = vscode.window.createTextEditorDecorationType(highlight);
  private readonly codeMark = vscode.window.createTextEditorDecorationType({ ...highlight, isWholeLine: true });
  readonly disposables = [this.equationMark, this.codeMark];

  constructor(private readonly code: CodeDocuments) {}

  /** Marks what belongs to the selection of this editor. */
  follow(editor: vscode.TextEditor | undefined): void {
    if (editor === undefined) return;
    if (this.isCode(editor)) this.showEquation(editor);
    else this.showCode(editor);
  }

  /** The equation of code that was selected, in a document that may not be on the screen. */
  async open(editor: vscode.TextEditor): Promise<void> {
    const place = this.selectedPlace(editor);
    if (place === undefined || editorOf(place.uri) !== undefined) return;
    await vscode.window.showTextDocument(vscode.Uri.parse(place.uri), { viewColumn: columnBeside(editor), preserveFocus: true });
    this.showEquation(editor);
  }

  isCode({ document }: vscode.TextEditor): boolean {
    return document.uri.scheme === this.code.scheme;
  }

  private showCode(editor: vscode.TextEditor): void {
    const uri = editor.document.uri.toString();
    for (const code of vscode.window.visibleTextEditors.filter((candidate) => this.isCode(candidate))) {
      const places = this.code.places(code.document.uri);
      if (places === undefined) continue;
      const place = placeAt(places, uri, editor.selection.active);
      mark(code, this.codeMark, place === undefined ? undefined : linesOf(place));
    }
    editor.setDecorations(this.equationMark, []);
  }

  private showEquation(code: vscode.TextEditor): void {
    const places = this.code.places(code.document.uri);
    if (places === undefined) return;
    const selected = this.selectedPlace(code);
    for (const uri of new Set(places.map((place) => place.uri))) {
      const editor = editorOf(uri);
      if (editor !== undefined) mark(editor, this.equationMark, selected?.uri === uri ? rangeOf(selected) : undefined);
    }
    code.setDecorations(this.codeMark, []);
  }

  private selectedPlace(code: vscode.TextEditor): Place | undefined {
    return placeOfLine(this.code.places(code.document.uri) ?? [], code.selection.active.line);
  }
}

export function linkCode(code: CodeDocuments): vscode.Disposable {
  const links = new CodeLinks(code);
  const followActive = () => { links.follow(vscode.window.activeTextEditor); };
  return vscode.Disposable.from(
    ...links.disposables,
    vscode.window.onDidChangeTextEditorSelection(({ textEditor, kind }) => {
      if (textEditor !== vscode.window.activeTextEditor) return;
      links.follow(textEditor);
      if (kind === vscode.TextEditorSelectionChangeKind.Mouse && links.isCode(textEditor)) links.open(textEditor).catch(report);
    }),
    vscode.window.onDidChangeVisibleTextEditors(followActive),
    vscode.workspace.onDidChangeTextDocument(({ document }) => { if (document.uri.scheme === code.scheme) followActive(); }),
    code.onDidMake(followActive),
  );
}

function report(error: unknown): void {
  void vscode.window.showWarningMessage(`texbrdf: ${wordsOf(error)}`);
}

function mark(editor: vscode.TextEditor, type: vscode.TextEditorDecorationType, range: vscode.Range | undefined): void {
  editor.setDecorations(type, range === undefined ? [] : [range]);
  if (range !== undefined) editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}

function linesOf({ lines: [first, last] }: Place): vscode.Range {
  return new vscode.Range(first, 0, last, 0);
}

function rangeOf({ range: { start, end } }: Place): vscode.Range {
  return new vscode.Range(start.line, start.character, end.line, end.character);
}

function editorOf(uri: string): vscode.TextEditor | undefined {
  return vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === uri);
}

/** Where another document lies, so that the code stays on the screen. */
function columnBeside(code: vscode.TextEditor): vscode.ViewColumn {
  const other = vscode.window.visibleTextEditors.find(({ viewColumn }) => viewColumn !== undefined && viewColumn !== code.viewColumn);
  return other?.viewColumn ?? (code.viewColumn === vscode.ViewColumn.One ? vscode.ViewColumn.Two : vscode.ViewColumn.One);
}
