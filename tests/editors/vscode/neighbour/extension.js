// Stands for another LaTeX extension: once it is started it answers the questions that ours answers, wherever they are asked; and it
// reports what the editor hears from all extensions together.
'use strict';
const vscode = require('vscode');

const latex = { language: 'latex' };
const word = /\\?[a-z]+/;

function wordAt(document, position) {
  const range = document.getWordRangeAtPosition(position, word);
  return range === undefined ? undefined : document.getText(range);
}

function provideHover(document, position) {
  const found = wordAt(document, position);
  return found === undefined ? undefined : new vscode.Hover(`neighbour: ${found}`);
}

function provideCompletionItems() {
  const item = new vscode.CompletionItem('\\theneighbour', vscode.CompletionItemKind.Function);
  return [item];
}

/** From \ref{name} to \label{name}. */
function provideDefinition(document, position) {
  const reference = document.getWordRangeAtPosition(position, /\\ref\{\w+\}/);
  if (reference === undefined) return undefined;
  const label = document.getText().indexOf(document.getText(reference).replace('ref', 'label'));
  return label < 0 ? undefined : new vscode.Location(document.uri, document.positionAt(label));
}

function check(diagnostics, document) {
  const found = [...document.getText().matchAll(/colour/g)].map(({ index }) => {
    const range = new vscode.Range(document.positionAt(index), document.positionAt(index + 'colour'.length));
    return Object.assign(new vscode.Diagnostic(range, 'spelling', vscode.DiagnosticSeverity.Warning), { source: 'neighbour' });
  });
  diagnostics.set(document.uri, found);
}

function start(subscriptions) {
  const diagnostics = vscode.languages.createDiagnosticCollection('neighbour');
  const checkOurs = (document) => { if (vscode.languages.match(latex, document) > 0) check(diagnostics, document); };
  subscriptions.push(
    diagnostics,
    vscode.languages.registerHoverProvider(latex, { provideHover }),
    vscode.languages.registerCompletionItemProvider(latex, { provideCompletionItems }, '\\'),
    vscode.languages.registerDefinitionProvider(latex, { provideDefinition }),
    vscode.workspace.onDidChangeTextDocument(({ document }) => { checkOurs(document); }),
  );
  vscode.workspace.textDocuments.forEach(checkOurs);
}

const ask = (command, ...rest) => vscode.commands.executeCommand(`vscode.execute${command}`, ...rest).then((found) => found ?? []);

async function answersAt(uri, position) {
  const [hovers, definitions, highlights, completions, actions] = await Promise.all([
    ask('HoverProvider', uri, position), ask('DefinitionProvider', uri, position), ask('DocumentHighlights', uri, position),
    ask('CompletionItemProvider', uri, position), ask('CodeActionProvider', uri, new vscode.Range(position, position)),
  ]);
  return {
    hovers: hovers.flatMap(({ contents }) => contents.map(({ value }) => value)), definitions: definitions.map(({ range, targetRange = range }) => targetRange.start.line),
    highlights: highlights.length, completions: completions.items.map(({ label }) => label.label ?? label), actions: actions.map(({ title }) => title),
  };
}

/** What all extensions say at each word of a document, and the lines that they decorate. */
async function report() {
  const { document } = vscode.window.activeTextEditor;
  const [lenses, hints, folds] = await Promise.all([
    ask('CodeLensProvider', document.uri), ask('InlayHintProvider', document.uri, new vscode.Range(0, 0, document.lineCount, 0)), ask('FoldingRangeProvider', document.uri),
  ]);
  const words = [];
  for (const { index, 0: text } of document.getText().matchAll(/\\?[a-z]+/g)) {
    const position = document.positionAt(index + text.length);
    words.push({ text, line: position.line, ...await answersAt(document.uri, position) });
  }
  const decorated = [...lenses.map(({ range }) => range.start.line), ...hints.map(({ position }) => position.line), ...folds.map(({ start: line }) => line)];
  const diagnostics = vscode.languages.getDiagnostics(document.uri).map(({ source, range }) => ({ source, line: range.start.line }));
  const target = vscode.Uri.joinPath(vscode.workspace.workspaceFolders[0].uri, 'report.json');
  await vscode.workspace.fs.writeFile(target, Buffer.from(JSON.stringify({ words, decorated, diagnostics })));
  void vscode.window.showInformationMessage('neighbour: reported');
}

exports.activate = ({ subscriptions }) => {
  subscriptions.push(vscode.commands.registerCommand('neighbour.start', () => { start(subscriptions); }), vscode.commands.registerCommand('neighbour.report', report));
};
