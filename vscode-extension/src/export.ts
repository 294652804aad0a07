// Export: the program's own command line makes the file.
import { spawn } from 'node:child_process';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { activeDocument, isScene } from './documents';
import { exportKinds, noRenderer, pictureSize, sizeHint, usualSize } from './export_kinds';
import type { ExportKind } from './export_kinds';
import { standardLook } from './preview/standard_look';
import type { ServerProcess } from './server_process';
import { wordsOf } from './words_of';

export function exportCommand(server: ServerProcess): vscode.Disposable {
  return vscode.commands.registerCommand('texbrdf.export', async () => {
    const document = activeDocument();
    if (document === undefined || isScene(document)) return;
    const kind = await vscode.window.showQuickPick(exportKinds, { title: 'Export as' });
    if (kind === undefined) return;
    const size = kind.isPicture ? await askForSize() : usualSize;
    if (size === undefined) return;
    const target = await vscode.window.showSaveDialog({ defaultUri: proposed(document, kind), filters: { [kind.label]: [kind.extension] } });
    if (target === undefined) return;
    try {
      await vscode.workspace.fs.writeFile(target, await made(server.locate().program, kind, size, document));
      void vscode.window.showInformationMessage(`texbrdf wrote ${path.basename(target.path)}.`);
    } catch (error) {
      server.log.appendLine(String(error));
      void vscode.window.showErrorMessage(`texbrdf: ${wordsOf(error)}`);
    }
  });
}

async function askForSize(): Promise<number | undefined> {
  const answer = await vscode.window.showInputBox({
    title: 'Width and height of the picture', prompt: sizeHint, value: `${usualSize}`,
    validateInput: (text) => pictureSize(text) === undefined ? sizeHint : undefined,
  });
  return answer === undefined ? undefined : pictureSize(answer);
}

function proposed({ uri }: vscode.TextDocument, { extension }: ExportKind): vscode.Uri {
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri ?? vscode.Uri.file(process.cwd());
  const base = uri.scheme === 'untitled' ? vscode.Uri.joinPath(folder, path.posix.basename(uri.path)) : uri;
  return base.with({ path: `${base.path.replace(/\.\w+$/, '')}.${extension}` });
}

async function made(program: string, kind: ExportKind, size: number, document: vscode.TextDocument): Promise<Uint8Array> {
  const { exposure, gamma } = standardLook();
  const first = await run(program, kind.arguments({ size, exposure, gamma }), document);
  const last = first.status === noRenderer && kind.withoutRenderer !== undefined
    ? await run(program, [...kind.arguments({ size, exposure, gamma }), ...kind.withoutRenderer], document)
    : first;
  if (last.status !== 0) throw new Error(last.messages.trim().split('\n')[0] ?? `it ended with status ${last.status}`);
  return last.output;
}

interface Outcome {
  status: number | null;
  output: Uint8Array;
  messages: string;
}

/** A file that is saved is read by the program itself, which then finds what it includes. */
async function run(program: string, options: string[], document: vscode.TextDocument): Promise<Outcome> {
  const onDisk = document.uri.scheme === 'file';
  const saved = onDisk && !document.isDirty;
  const child = spawn(program, [...options, saved ? document.uri.fsPath : '-', '-o', '-'],
    { stdio: 'pipe', ...(onDisk ? { cwd: path.dirname(document.uri.fsPath) } : {}) });
  const output: Buffer[] = [];
  let messages = '';
  child.stdout.on('data', (bytes: Buffer) => output.push(bytes));
  child.stderr.on('data', (bytes: Buffer) => { messages += bytes.toString(); });
  child.stdin.on('error', () => undefined); // It ended before it had read all: its status says why.
  child.stdin.end(saved ? '' : document.getText());
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (status) => { resolve({ status, output: Buffer.concat(output), messages }); });
  });
}
