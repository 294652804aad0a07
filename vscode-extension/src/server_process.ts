// The server's process and the client that speaks with it: found, started, started again after a crash.
import { spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { statSync } from 'node:fs';
import * as vscode from 'vscode';
import { CloseAction, ErrorAction, LanguageClient } from 'vscode-languageclient/node';
import type {
  LanguageClientOptions, StaticFeature, WorkDoneProgressBegin, WorkDoneProgressEnd, WorkDoneProgressReport,
} from 'vscode-languageclient/node';
import { CrashPolicy, mostCrashes } from './crash_policy';
import { documentSelector } from './documents';
import { frameEvent, lensCommands, stateEvent } from './protocol';
import type { Connection, FrameParams, Notifications, PreviewStateParams, Requests, ServerCapabilities } from './protocol';
import { serverPath } from './server_path';
import type { ServerPath } from './server_path';
import { serverSettings } from './server_settings';

export type ServerState =
  | { kind: 'stopped' }
  | { kind: 'starting' }
  | { kind: 'ready'; version: string }
  | { kind: 'busy'; what: string }
  | { kind: 'failed'; reason: string };

const endsWithin = 500; // ms, once it was told to

export class ServerProcess implements Connection, vscode.Disposable {
  readonly log = vscode.window.createOutputChannel('texbrdf');
  private readonly stateChanged = new vscode.EventEmitter<ServerState>();
  private readonly frameArrived = new vscode.EventEmitter<FrameParams>();
  private readonly previewStateArrived = new vscode.EventEmitter<PreviewStateParams>();
  readonly onStateChange = this.stateChanged.event;
  readonly onFrame = this.frameArrived.event;
  readonly onPreviewState = this.previewStateArrived.event;

  private current: ServerState = { kind: 'stopped' };
  private client: LanguageClient | undefined;
  private process: ChildProcess | undefined;
  /** Grows with each crash, failure and stop, so that what was overtaken by a later one is known. */
  private turn = 0;
  private readonly crashes = new CrashPolicy();
  /** How the present process ended, as soon as it has. */
  private ending: Promise<string> = Promise.resolve('');
  private readonly tasks = new Map<string | number, string>();

  constructor(private readonly context: vscode.ExtensionContext) {}

  get state(): ServerState {
    return this.current;
  }

  get running(): boolean {
    return this.current.kind === 'ready' || this.current.kind === 'busy';
  }

  get canPreview(): boolean {
    const experimental = this.client?.initializeResult?.capabilities.experimental as { texbrdf?: ServerCapabilities } | undefined;
    return this.running && experimental?.texbrdf?.preview === true;
  }

  locate(): ServerPath {
    return serverPath({
      setting: vscode.workspace.getConfiguration('texbrdf').get<string>('server.path', ''),
      extensionFolder: this.context.extensionPath,
      workspaceFolder: vscode.workspace.workspaceFolders?.[0]?.uri.fsPath,
      isTrusted: vscode.workspace.isTrusted,
      platform: process.platform,
      isFile,
    });
  }

  async start(): Promise<void> {
    if (this.client !== undefined) return;
    this.crashes.forget();
    await this.launch();
  }

  async restart(): Promise<void> {
    const turn = await this.end();
    if (turn === this.turn) await this.start();
  }

  async stop(): Promise<void> {
    await this.end();
  }

  dispose(): void {
    void this.stop().finally(() => { this.log.dispose(); });
  }

  async request<M extends keyof Requests>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    if (this.client === undefined || !this.running) throw new Error('the texbrdf server does not run');
    return this.client.sendRequest<Requests[M][1]>(method, params);
  }

  notify<M extends keyof Notifications>(method: M, params: Notifications[M]): void {
    if (this.client !== undefined && this.running) this.client.sendNotification(method, params).catch(() => undefined); // It is gone: that is told of elsewhere.
  }

  private async launch(): Promise<void> {
    this.become({ kind: 'starting' });
    const client: LanguageClient = new QuietClient('texbrdf', 'texbrdf', () => this.spawn(() => this.client === client), this.options(() => void this.crashed(client)));
    this.client = client;
    client.registerFeature(announceCommands);
    client.onNotification(frameEvent, (frame: FrameParams) => { this.frameArrived.fire(frame); });
    client.onNotification(stateEvent, (state: PreviewStateParams) => { this.previewStateArrived.fire(state); });
    try {
      await client.start(); // Not ready before: the documents that are open are told of last.
      if (this.client === client) this.becomeReady();
    } catch (error) {
      if (this.client !== client) return;
      if (error instanceof NotStarted) await this.fail(error.message);
      else await this.crashed(client);
    }
  }

  /** The turn that it took: another one since then, and somebody else decides what comes next. */
  private async end(): Promise<number> {
    const turn = ++this.turn;
    await this.drop();
    if (turn === this.turn) this.become({ kind: 'stopped' });
    return turn;
  }

  /** One that does not end when it is asked to is killed. */
  private async drop(): Promise<void> {
    const { client, process, ending } = this;
    this.client = undefined;
    this.process = undefined;
    const asked = await client?.dispose().then(() => true, () => false);
    if (process === undefined) return;
    if (asked === true) await Promise.race([ending, new Promise((resolve) => setTimeout(resolve, endsWithin))]);
    process.kill('SIGKILL');
  }

  private async crashed(client: LanguageClient): Promise<void> {
    if (this.client !== client) return;
    const turn = ++this.turn;
    await this.drop();
    if (turn !== this.turn) return;
    const pause = this.crashes.crashed(Date.now());
    if (pause === undefined) {
      const how = await this.ending;
      if (turn === this.turn) await this.fail(`it crashed ${mostCrashes} times, last with ${how}`);
      return;
    }
    this.become({ kind: 'starting' });
    await new Promise((resolve) => setTimeout(resolve, pause));
    if (turn === this.turn) await this.launch();
  }

  private options(closed: () => void): LanguageClientOptions {
    return {
      documentSelector: documentSelector(),
      outputChannel: this.log,
      initializationOptions: () => serverSettings(vscode.workspace.getConfiguration('texbrdf')),
      errorHandler: {
        error: () => ({ action: ErrorAction.Continue, handled: true }),
        closed: () => {
          closed();
          return { action: CloseAction.DoNotRestart, handled: true };
        },
      },
      initializationFailedHandler: () => false,
      synchronize: { configurationSection: 'texbrdf' },
      middleware: {
        workspace: {
          configuration: async (params, token, next) => {
            const answers = await next(params, token);
            return Array.isArray(answers) ? answers.map(serverSettings) : answers;
          },
        },
        handleWorkDoneProgress: (token, params, next) => {
          this.progress(token, params);
          next(token, params);
        },
      },
    };
  }

  private async spawn(isWanted: () => boolean): Promise<ChildProcess> {
    const { program, from } = this.locate();
    this.log.appendLine(`Starting ${program} (from ${from})`);
    const server = spawn(program, ['lsp', '--stdio'], { stdio: 'pipe', cwd: vscode.workspace.workspaceFolders?.[0]?.uri.fsPath });
    const ending = endingOf(server);
    await new Promise<void>((resolve, reject) => {
      server.once('spawn', resolve);
      server.once('error', (error: NodeJS.ErrnoException) => { reject(new NotStarted(whyNotStarted(error, program, from))); });
    });
    ending.then((how) => { this.log.appendLine(`The server ended with ${how}`); }).catch(() => undefined); // The log may be gone before.
    if (!isWanted()) {
      server.kill('SIGKILL');
      throw new NotStarted('it is not wanted any more');
    }
    this.process = server;
    this.ending = ending;
    return server;
  }

  private async fail(reason: string): Promise<void> {
    const turn = ++this.turn;
    await this.drop();
    if (turn !== this.turn) return;
    this.log.appendLine(`The server does not run: ${reason}`);
    this.become({ kind: 'failed', reason });
    void vscode.window.showErrorMessage(`texbrdf does not run: ${reason}`, 'Restart', 'Show log').then((choice) => {
      if (choice === 'Restart') void this.restart();
      if (choice === 'Show log') this.log.show();
    });
  }

  private progress(token: string | number, params: WorkDoneProgressBegin | WorkDoneProgressReport | WorkDoneProgressEnd): void {
    if (params.kind === 'begin') this.tasks.set(token, params.title);
    if (params.kind === 'end') this.tasks.delete(token);
    if (this.running) this.becomeReady();
  }

  private becomeReady(): void {
    const task = [...this.tasks.values()].at(-1);
    if (task !== undefined) this.become({ kind: 'busy', what: task });
    else this.become({ kind: 'ready', version: this.client?.initializeResult?.serverInfo?.version ?? '' });
  }

  private become(state: ServerState): void {
    if (state.kind === 'starting') this.tasks.clear();
    this.current = state;
    this.stateChanged.fire(state);
  }
}

/** There is no process. */
class NotStarted extends Error {}

/** What it has to say of trouble goes to the log only: a crash would show a message for each request that it takes along. */
class QuietClient extends LanguageClient {
  override error(message: string, data?: unknown): void {
    super.error(message, data, false);
  }
}

const announceCommands: StaticFeature = {
  fillClientCapabilities: (capabilities) => {
    capabilities.experimental = { ...(capabilities.experimental as object | undefined), texbrdf: { commands: Object.values(lensCommands) } };
  },
  initialize: () => undefined,
  getState: () => ({ kind: 'static' }),
  clear: () => undefined,
};

function isFile(file: string): boolean {
  return statSync(file, { throwIfNoEntry: false })?.isFile() ?? false;
}

/** Its signal or status, and the last that it said but for its log. */
function endingOf(server: ChildProcess): Promise<string> {
  let words = '';
  server.stderr?.on('data', (text: Buffer) => {
    words = text.toString().split('\n').filter((line) => line.trim() !== '' && !/^\[ *[\d.]+\] /.test(line)).at(-1) ?? words;
  });
  return new Promise((resolve) => {
    server.once('close', (code, signal) => { resolve((signal ?? `status ${code}`) + (words === '' ? '' : `: ${words}`)); });
  });
}

function whyNotStarted(error: NodeJS.ErrnoException, program: string, from: ServerPath['from']): string {
  if (error.code === 'ENOENT' && from === 'PATH') return 'it is not in PATH; install it, or set texbrdf.server.path';
  if (error.code === 'ENOENT') return `there is no ${program}`;
  if (error.code === 'EACCES') return `${program} is not executable`;
  return error.message;
}
