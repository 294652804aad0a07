// VS Code with extensions, in a browser without a window: started, looked at, typed into, and ended as a whole.
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, openSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { homedir, tmpdir } from 'node:os';
import path from 'node:path';

const { chromium } = createRequire(path.resolve('package.json'))('playwright-core');

const cache = process.env.XDG_CACHE_HOME ?? path.join(homedir(), '.cache');
export const serverMain = path.join(cache, 'texbrdf/vscode-4.100.3/package/lib/vscode/out/server-main.js');
const patience = Number(process.env.PATIENCE ?? 60) * 1000; // milliseconds; a busy machine

const settings = {
  'workbench.startupEditor': 'none', 'workbench.enableExperiments': false, 'security.workspace.trust.enabled': false,
  'telemetry.telemetryLevel': 'off', 'extensions.autoUpdate': false, 'extensions.autoCheckUpdates': false, 'extensions.ignoreRecommendations': true,
  'update.mode': 'none', 'editor.minimap.enabled': false, 'editor.hover.delay': 100, 'git.enabled': false, 'files.autoSave': 'afterDelay', 'files.autoSaveDelay': 20,
  'editor.wordBasedSuggestions': 'off', 'editor.quickSuggestions': { other: 'off' }, 'editor.autoClosingBrackets': 'never',
  'editor.stickyScroll.enabled': false, 'workbench.tips.enabled': false,
};

const browserOptions = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];

async function freePort() {
  const probe = createServer().listen(0, '127.0.0.1');
  await new Promise((resolve) => probe.once('listening', resolve));
  const { port } = probe.address();
  await new Promise((resolve) => probe.close(resolve));
  return port;
}

export const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Waits until what is read is as wanted, and gives it. */
export async function waitUntil(read, isWanted, complaint = (found) => `it stays ${found}`) {
  for (const end = Date.now() + patience; ; await pause(50)) {
    const found = await read();
    if (isWanted(found)) return found;
    if (Date.now() > end) throw new Error(complaint(found));
  }
}

export class Editor {
  /** Opens a copy of the workspace; screenshots and logs go to `out`. */
  static async start({ extensions, workspace, out }) {
    const editor = new Editor();
    editor.out = out;
    editor.folder = mkdtempSync(path.join(tmpdir(), 'texbrdf-vscode-'));
    editor.workspace = path.join(editor.folder, 'workspace');
    cpSync(workspace, editor.workspace, { recursive: true });
    await editor.startServer(extensions);
    await editor.startBrowser();
    return editor;
  }

  async startServer(packages) {
    const [data, extensions, home] = ['data', 'extensions', 'home'].map((name) => path.join(this.folder, name));
    mkdirSync(path.join(data, 'User'), { recursive: true });
    mkdirSync(home);
    writeFileSync(path.join(data, 'User', 'settings.json'), JSON.stringify(settings));
    const environment = { ...process.env, HOME: home };
    const folders = ['--accept-server-license-terms', '--server-data-dir', this.folder, '--user-data-dir', data, '--extensions-dir', extensions];
    execFileSync(process.execPath, [serverMain, ...folders, ...packages.flatMap((vsix) => ['--install-extension', vsix])], { env: environment, stdio: 'ignore' });
    this.url = `http://127.0.0.1:${await freePort()}/`;
    const log = openSync(path.join(this.out, 'server.log'), 'w');
    this.server = spawn(process.execPath, [serverMain, '--host', '127.0.0.1', '--port', new URL(this.url).port, '--without-connection-token',
      '--telemetry-level', 'off', ...folders], { env: environment, detached: true, stdio: ['ignore', log, log] });
    await waitUntil(() => fetch(this.url).then(() => true, () => false), (answers) => answers, () => 'VS Code does not answer');
  }

  async startBrowser() {
    this.browser = await chromium.launchPersistentContext(path.join(this.folder, 'browser'),
      { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, viewport: { width: 1400, height: 900 }, args: browserOptions });
    this.hosts = new Set();
    this.browser.on('request', (request) => {
      const { protocol, hostname } = new URL(request.url());
      if (protocol.startsWith('http')) this.hosts.add(hostname);
    });
    this.page = this.browser.pages()[0] ?? await this.browser.newPage();
    this.page.setDefaultTimeout(patience);
    this.violations = [];
    this.page.on('console', (message) => {
      if (message.text().includes('Content Security Policy')) this.violations.push(`${message.location().url}: ${message.text()}`);
      if (message.type() === 'error') writeFileSync(path.join(this.out, 'console.log'), `${message.text()}\n`, { flag: 'a' });
    });
    await this.page.goto(`${this.url}?folder=${encodeURIComponent(this.workspace)}`);
    await this.page.waitForSelector('.monaco-workbench');
  }

  /** Ends all processes, those that the server started too. */
  async end() {
    await this.browser?.close();
    const signal = (name) => {
      try {
        process.kill(-this.server.pid, name);
      } catch {
        // They have ended already.
      }
    };
    if (this.server !== undefined) {
      const ended = new Promise((resolve) => this.server.once('exit', resolve));
      signal('SIGTERM');
      await Promise.race([ended, pause(5000)]);
      await pause(300);
      signal('SIGKILL');
    }
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }

  async screenshot(name) {
    await this.page.screenshot({ path: path.join(this.out, `${name}.png`) });
  }

  async open(file) {
    this.file = file;
    const item = this.page.locator('.explorer-folders-view .monaco-list-row', { hasText: file });
    const tab = this.page.locator(`.tab.active[data-resource-name="${file}"]`);
    // A file that appears moves the rows below it: a click may meet another one.
    await waitUntil(async () => {
      await item.dblclick();
      return tab.waitFor({ timeout: 5000 }).then(() => true, () => false);
    }, (opened) => opened, () => `${file} was not opened`);
    await this.page.locator('.editor-instance .view-line').first().waitFor();
  }

  /** Runs a command of the palette by its whole title. */
  async command(title) {
    await this.leaveHover();
    await this.page.keyboard.press('F1');
    const input = this.page.locator('.quick-input-widget input.input');
    await input.fill(`>${title}`);
    await this.page.locator('.quick-input-list .monaco-list-row', { hasText: title }).first().waitFor();
    await this.page.keyboard.press('Enter');
  }

  async pick(label) {
    await this.page.locator('.quick-input-list .monaco-list-row', { hasText: label }).first().click();
  }

  /** The text of the document that was opened: the editor saves by itself. */
  async source() {
    await this.page.locator('.tab', { hasText: this.file }).first().waitFor();
    await this.page.waitForFunction(() => document.querySelector('.tab.dirty') === null);
    return readFileSync(path.join(this.workspace, this.file), 'utf8');
  }

  /** What the user has set, as text: it may be read while it is written. */
  userSettings() {
    return readFileSync(path.join(this.folder, 'data', 'User', 'settings.json'), 'utf8');
  }

  /** The bytes of a file of the workspace, if there is one. */
  read(name) {
    const file = path.join(this.workspace, name);
    return existsSync(file) ? readFileSync(file) : undefined;
  }

  /** Answers the question that the words ask at the top of the window. */
  async answer(words, text) {
    const box = this.page.locator('.quick-input-widget', { hasText: words });
    await box.locator('input.input').fill(text);
    await this.page.keyboard.press('Enter');
  }

  /** The line in which a file to be written is named, once this name is proposed. */
  async waitForFileDialog(name) {
    await this.page.waitForFunction((wanted) => document.querySelector('.quick-input-widget input.input')?.value.endsWith(`/${wanted}`), name);
    return this.page.locator('.quick-input-widget input.input');
  }

  /** The text, as soon as it is as expected. */
  async waitForSource(expected) {
    return waitUntil(() => this.source(), (text) => expected.test(text), (text) => `no ${expected} in\n${text}`);
  }

  /** Where a word stands on the screen; `in` is some text of its line. */
  async wordBox(word, { in: context = word } = {}) {
    const box = await this.page.evaluate(([sought, line]) => {
      for (const node of document.querySelectorAll('.editor-instance .view-line')) {
        const walker = document.createTreeWalker(node, NodeFilter.SHOW_TEXT);
        const texts = [];
        let whole = '';
        for (let text = walker.nextNode(); text !== null; text = walker.nextNode()) {
          texts.push({ text, from: whole.length });
          whole += text.data.replaceAll('\u00a0', ' ');
        }
        const at = whole.indexOf(sought);
        if (at < 0 || !whole.includes(line)) continue;
        const place = (offset) => {
          const { text, from } = texts.findLast((candidate) => candidate.from <= offset);
          return [text, offset - from];
        };
        const range = document.createRange();
        range.setStart(...place(at));
        const [text, offset] = place(at + sought.length - 1);
        range.setEnd(text, offset + 1);
        const { x, y, width, height } = range.getBoundingClientRect();
        return { x, y, width, height };
      }
      return undefined;
    }, [word, context]);
    if (box === undefined) throw new Error(`no ${word} on the screen`);
    return box;
  }

  async click(word, options) {
    await this.leaveHover();
    const { x, y, width, height } = await this.wordBox(word, options);
    await this.page.mouse.click(x + width / 2, y + height / 2);
  }

  async select(word, options) {
    await this.leaveHover();
    const { x, y, width, height } = await this.wordBox(word, options);
    await this.page.mouse.move(x + 1, y + height / 2);
    await this.page.mouse.down();
    await this.page.mouse.move(x + width - 1, y + height / 2, { steps: 3 });
    await this.page.mouse.up();
  }

  /** What is shown when the pointer rests on a word, as soon as it holds the text. */
  async hover(word, expected, options) {
    const hover = this.page.locator('.monaco-hover:not(.hidden) .hover-contents', { hasText: expected }).first();
    for (const end = Date.now() + patience; ; ) {
      await this.rest(word, options);
      // The editor asks once: a server that is starting had nothing to say.
      if (await hover.waitFor({ timeout: patience / 6 }).then(() => true, () => false)) return hover;
      if (Date.now() > end) throw new Error(`no hover with ${expected} on ${word}`);
    }
  }

  async rest(word, options) {
    await this.leaveHover();
    const { x, y, width, height } = await this.wordBox(word, options);
    await this.page.mouse.move(x + width / 2 - 3, y + height / 2);
    await this.page.mouse.move(x + width / 2, y + height / 2, { steps: 4 });
  }

  /** An open hover covers the lines above it: a click there would hit the hover. */
  async leaveHover() {
    await this.page.mouse.move(700, 893);
    await this.page.waitForFunction(() => [...document.querySelectorAll('.monaco-hover')].every((node) => node.offsetParent === null || node.classList.contains('hidden')));
  }

  async waitForSquiggles(count) {
    await this.page.waitForFunction((wanted) => document.querySelectorAll('.editor-instance .squiggly-error').length === wanted, count);
  }

  /** Waits until the caret stands at "Ln 1, Col 2" or what else the status bar is to show. */
  async waitForCaret(place) {
    await this.page.locator('#status\\.editor\\.selection', { hasText: place }).waitFor();
  }

  /** The page inside our webview, for the walkthrough has one too: VS Code puts one frame into another. */
  get webview() {
    return this.page.frameLocator('iframe.webview.ready[src*="extensionId=texbrdf"]').frameLocator('iframe#active-frame');
  }
}
