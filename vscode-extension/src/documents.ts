// Which documents are ours.
import * as vscode from 'vscode';
import { isSceneFile, scenePattern } from './scene_files';

const schemes = ['file', 'untitled'];
const alwaysOurs = ['latex', 'tex'];
let lastActive: vscode.TextDocument | undefined;

function languages(): string[] {
  const markdown = vscode.workspace.getConfiguration('texbrdf').get<boolean>('markdown.enabled', false);
  return markdown ? [...alwaysOurs, 'markdown'] : alwaysOurs;
}

/** Of the server: LaTeX, perhaps Markdown, and scenes. */
export function documentSelector(): ({ scheme: string; language: string } | { scheme: string; pattern: string })[] {
  return schemes.flatMap((scheme) => [...languages().map((language) => ({ scheme, language })), { scheme, pattern: scenePattern }]);
}

export function isOurs(document: vscode.TextDocument): boolean {
  return vscode.languages.match(documentSelector(), document) > 0;
}

export function isScene(document: vscode.TextDocument): boolean {
  return isSceneFile(document.uri.path);
}

/** Where no text has the focus, but a pane or the walkthrough, the one that had it last. */
export function activeDocument(): vscode.TextDocument | undefined {
  const editor = vscode.window.activeTextEditor;
  const document = editor === undefined ? lastActive : editor.document;
  return document !== undefined && !document.isClosed && isOurs(document) ? document : undefined;
}

export function watchActiveDocument(): vscode.Disposable {
  const remember = (editor: vscode.TextEditor | undefined) => { if (editor !== undefined && isOurs(editor.document)) lastActive = editor.document; };
  remember(vscode.window.activeTextEditor);
  return vscode.window.onDidChangeActiveTextEditor(remember);
}

export function findDocument(uri: string): vscode.TextDocument | undefined {
  return vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri);
}
