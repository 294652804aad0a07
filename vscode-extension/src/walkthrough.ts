// The example of the walkthrough: a document of one's own, so that nothing typed into it spoils the original.
import * as vscode from 'vscode';

export function walkthroughCommands(context: vscode.ExtensionContext): vscode.Disposable {
  return vscode.commands.registerCommand('texbrdf.openExample', async () => {
    const example = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(context.extensionUri, 'dist', 'example.tex'));
    const document = await vscode.workspace.openTextDocument({ language: 'latex', content: Buffer.from(example).toString('utf8') });
    await vscode.window.showTextDocument(document);
  });
}
