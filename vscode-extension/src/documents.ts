// Which documents are ours.
import * as vscode from 'vscode';

const alwaysOurs = ['latex', 'tex'];

function languages(): string[] {
  const markdown = vscode.workspace.getConfiguration('texbrdf').get<boolean>('markdown.enabled', false);
  return markdown ? [...alwaysOurs, 'markdown'] : alwaysOurs;
}

export function documentSelector(): { language: string }[] {
  return languages().map((language) => ({ language }));
}

export function isOurs(document: vscode.TextDocument): boolean {
  return languages().includes(document.languageId) && !document.uri.scheme.startsWith('git');
}

export function activeDocument(): vscode.TextDocument | undefined {
  const document = vscode.window.activeTextEditor?.document;
  return document !== undefined && isOurs(document) ? document : undefined;
}

export function findDocument(uri: string): vscode.TextDocument | undefined {
  return vscode.workspace.textDocuments.find((document) => document.uri.toString() === uri);
}
