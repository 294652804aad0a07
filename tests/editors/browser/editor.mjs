// An editor without webviews, as far as the preview in a browser needs one: it speaks LSP with the program and applies edits.
import { spawn } from 'node:child_process';

export class Editor {
  buffer = Buffer.alloc(0);
  waiting = new Map();
  lastId = 0;
  /** What the server asked for: `window/showDocument`. */
  shown = [];
  /** What was published, by URI. */
  diagnostics = new Map();

  constructor(program, uri, text) {
    Object.assign(this, { uri, text, version: 1 });
    this.process = spawn(program, ['lsp', '--preview-port', '0', '--log-level', 'error'], { stdio: ['pipe', 'pipe', 'inherit'] });
    this.process.stdout.on('data', (bytes) => { this.receive(bytes); });
    this.url = new Promise((resolve) => { this.onUrl = resolve; });
  }

  async start() {
    const capabilities = { workspace: { applyEdit: true, workspaceEdit: { documentChanges: true } }, window: { showDocument: { support: true } } };
    await this.request('initialize', { capabilities });
    this.notify('initialized', {});
    return this.url;
  }

  open() {
    this.notify('textDocument/didOpen', { textDocument: { uri: this.uri, languageId: 'latex', version: this.version, text: this.text } });
  }

  async end() {
    await this.request('shutdown', null);
    const ended = new Promise((resolve) => { this.process.once('exit', resolve); });
    this.notify('exit', null);
    return ended;
  }

  replaceAll(text) {
    this.text = text;
    this.version += 1;
    this.notify('textDocument/didChange', { textDocument: { uri: this.uri, version: this.version }, contentChanges: [{ text }] });
  }

  request(method, params) {
    this.send({ id: ++this.lastId, method, params });
    return new Promise((resolve) => { this.waiting.set(this.lastId, resolve); });
  }

  notify(method, params) {
    this.send({ method, params });
  }

  send(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: '2.0', ...message }));
    this.process.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.process.stdin.write(body);
  }

  receive(bytes) {
    this.buffer = Buffer.concat([this.buffer, bytes]);
    for (let end; (end = this.buffer.indexOf('\r\n\r\n')) >= 0;) {
      const length = Number(/Content-Length: (\d+)/.exec(this.buffer.subarray(0, end).toString())[1]);
      if (this.buffer.length < end + 4 + length) return;
      this.handle(JSON.parse(this.buffer.subarray(end + 4, end + 4 + length).toString()));
      this.buffer = this.buffer.subarray(end + 4 + length);
    }
  }

  handle({ id, method, params, result }) {
    if (method === undefined) this.waiting.get(id)?.(result);
    if (method === 'window/showMessage') this.onUrl(/http:\S+/.exec(params.message)[0]);
    if (method === 'textDocument/publishDiagnostics') this.diagnostics.set(params.uri, params.diagnostics);
    if (method === 'window/showDocument') this.shown.push(params);
    if (method === 'workspace/applyEdit') this.apply(params.edit);
    if (method !== undefined && id !== undefined) this.send({ id, result: method === 'workspace/applyEdit' ? { applied: true } : null });
  }

  apply({ documentChanges: [{ edits }] }) {
    const lines = this.text.split('\n');
    for (const { range: { start, end }, newText } of edits) {
      const line = lines[start.line];
      lines[start.line] = line.slice(0, start.character) + newText + line.slice(end.character);
    }
    this.replaceAll(lines.join('\n'));
  }
}
