// A preview of one document after the other: keeps the server and the page of right account of each other. Knows nothing of VS Code.
import { Debounce } from '../debounce';
import { largestSide, smallestSide } from '../protocol';
import type { Api, FrameParams, Look, Parameter, PreviewStateParams, Roots } from '../protocol';
import { textChanges } from '../text_changes';
import type { TextChange } from '../text_changes';
import type { FromPage, ToPage } from './messages';

export interface Subject {
  uri: string;
  name: string;
  version: number;
  /** What is to be drawn, if not what the document says. */
  root: string | undefined;
}

export interface Surroundings {
  api: Api;
  post: (message: ToPage) => void;
  /** One step that can be undone; false where the document has changed since. */
  apply: (changes: TextChange[]) => Promise<boolean>;
  reveal: (uri: string, parameter: Parameter) => void;
  saveImage: (png: string, name: string) => void;
  roots: (uri: string) => Promise<Roots>;
  report: (problem: string) => void;
  standardLook: () => Look;
}

const parametersAfter = 40; // ms of quiet

export class Session {
  private subject: Subject | undefined;
  private look: Look;
  /** Of the pane, in device pixels; there is no preview before the page has told it. */
  private side: number | undefined;
  private preview: number | undefined;
  /** Grows with each document, so that answers about an earlier one are known. */
  private turn = 0;
  private pageReady = false;
  private frame: FrameParams | undefined;
  private unacknowledged = false;
  private state: PreviewStateParams | undefined;
  private parameters: Parameter[] = [];
  private roots: Roots = { root: null, candidates: [] };
  /** The values with which the parameters were first seen: what reset brings back. By document and name. */
  private readonly first = new Map<string, number[]>();
  private readonly soon = new Debounce(parametersAfter);

  constructor(private readonly around: Surroundings) {
    this.look = around.standardLook();
  }

  get uri(): string | undefined {
    return this.subject?.uri;
  }

  async show(subject: Subject): Promise<void> {
    this.close();
    this.subject = subject;
    this.parameters = [];
    this.roots = { root: null, candidates: [] };
    this.postDocument();
    await this.open();
  }

  /** After the server was started again. */
  async reopen(): Promise<void> {
    this.forgetPreview();
    if (this.subject !== undefined) await this.open();
  }

  close(): void {
    if (this.preview !== undefined) this.around.api.closePreview(this.preview);
    this.soon.cancel();
    this.forgetPreview();
  }

  documentClosed(uri: string): void {
    if (this.subject?.uri !== uri) return;
    this.close();
    this.subject = undefined;
    this.around.post({ type: 'state', state: 'none', message: 'The document was closed.' });
  }

  documentChanged(uri: string, version: number): void {
    if (this.subject?.uri !== uri) return;
    this.subject = { ...this.subject, version };
    this.around.post({ type: 'version', version });
    this.soon.run(() => { void this.refreshDocument(); });
  }

  frameArrived(frame: FrameParams): void {
    if (frame.preview !== this.preview) return;
    this.frame = frame;
    this.unacknowledged = true;
    if (frame.current && this.state !== undefined && frame.version > this.state.version) this.stateArrived({ ...this.state, state: 'good', message: '' });
    if (this.pageReady) this.postFrame(frame);
  }

  stateArrived(state: PreviewStateParams): void {
    if (state.preview !== this.preview) return;
    if (this.state?.state === 'errors' && state.state === 'good') this.soon.run(() => { void this.refreshDocument(); });
    this.state = state;
    this.around.post({ type: 'state', state: state.state, message: state.message });
  }

  /** The page is gone, as when its tab is hidden. What it did not show stays unacknowledged: nothing is drawn for nobody. */
  pageLost(): void {
    this.pageReady = false;
  }

  async pageSays(message: FromPage): Promise<void> {
    switch (message.type) {
      case 'ready': this.greetPage(); break;
      case 'shown': this.acknowledge(); break;
      case 'size': await this.resize(message.side); break;
      case 'look': this.changeLook(message.change); break;
      case 'root': await this.chooseRoot(message.root); break;
      case 'set': this.setParameter(message.name, message.value); break;
      case 'write': await this.write([{ name: message.name, value: message.value }]); break;
      case 'reset': await this.write(this.firstValues(message.names)); break;
      case 'reveal': this.reveal(message.name); break;
      case 'saveImage': if (this.frame !== undefined) this.around.saveImage(this.frame.png, this.subject?.name ?? ''); break;
    }
  }

  private async open(): Promise<void> {
    const { subject, side } = this;
    if (subject === undefined || side === undefined) return;
    const turn = ++this.turn;
    try {
      const { preview } = await this.around.api.openPreview({
        uri: subject.uri, view: 'sphere', width: side, height: side, ...this.rootOption(), ...this.look,
      });
      if (turn === this.turn) this.preview = preview;
      else this.around.api.closePreview(preview);
    } catch (error) {
      this.around.post({ type: 'state', state: 'none', message: error instanceof Error ? error.message : String(error) });
      return;
    }
    if (turn === this.turn) await this.refreshDocument();
  }

  private rootOption(): { root?: string } {
    return this.subject?.root === undefined ? {} : { root: this.subject.root };
  }

  private forgetPreview(): void {
    ++this.turn;
    this.preview = undefined;
    this.frame = undefined;
    this.state = undefined;
    this.unacknowledged = false;
  }

  private greetPage(): void {
    this.pageReady = true;
    this.postDocument();
    this.around.post({ type: 'look', look: this.look, standard: this.around.standardLook() });
    this.around.post({ type: 'parameters', parameters: this.parameters });
    if (this.state !== undefined) this.around.post({ type: 'state', state: this.state.state, message: this.state.message });
    if (this.frame !== undefined) this.postFrame(this.frame);
  }

  private postDocument(): void {
    const { subject } = this;
    if (subject === undefined) return;
    const root = subject.root ?? this.roots.root;
    this.around.post({ type: 'document', name: subject.name, version: subject.version, roots: this.roots.candidates, root });
  }

  private postFrame(frame: FrameParams): void {
    const { version, source, width, height, png, milliseconds, badPixels, current } = frame;
    this.around.post({ type: 'picture', picture: { version, source, width, height, png, milliseconds, badPixels, current } });
  }

  private acknowledge(): void {
    if (!this.unacknowledged || this.preview === undefined) return;
    this.unacknowledged = false;
    this.around.api.frameShown(this.preview);
  }

  private async resize(side: number): Promise<void> {
    const bounded = Math.min(Math.max(Math.round(side), smallestSide), largestSide);
    if (bounded === this.side) return;
    const first = this.side === undefined;
    this.side = bounded;
    if (first) await this.open();
    else this.update({ width: bounded, height: bounded });
  }

  private changeLook(change: Partial<Look>): void {
    this.look = { ...this.look, ...change };
    this.update(change);
  }

  private update(change: Partial<Look> & { width?: number; height?: number; root?: string }): void {
    if (this.preview !== undefined) this.around.api.updatePreview({ preview: this.preview, ...change });
  }

  private async chooseRoot(root: string): Promise<void> {
    if (this.subject === undefined) return;
    this.subject = { ...this.subject, root };
    this.update({ root });
    await this.refreshDocument();
  }

  private async refreshDocument(): Promise<void> {
    const { subject, turn } = this;
    if (subject === undefined) return;
    const [parameters, roots] = await Promise.all([
      this.around.api.parameters({ uri: subject.uri, ...this.rootOption() }).catch(() => undefined),
      this.around.roots(subject.uri),
    ]);
    if (turn !== this.turn) return;
    this.roots = roots;
    this.postDocument();
    // With errors some may be missing; controls that come and go at each key would be in the way.
    const isBroken = this.state?.state === 'errors' && this.parameters.length > 0;
    if (parameters === undefined || isBroken) return;
    this.parameters = parameters;
    for (const { name, value } of parameters) if (!this.first.has(this.key(name))) this.first.set(this.key(name), value);
    this.around.post({ type: 'parameters', parameters });
  }

  private setParameter(name: string, value: number[] | null): void {
    if (this.preview !== undefined) this.around.api.setParameter({ preview: this.preview, name, value });
  }

  private key(name: string): string {
    return `${this.subject?.uri ?? ''}\n${name}`;
  }

  private firstValues(names: string[]): Assignment[] {
    return names.flatMap((name) => {
      const value = this.first.get(this.key(name));
      return value === undefined ? [] : [{ name, value }];
    });
  }

  /** Writes the values into the document; only then the pictures follow the document again. */
  private async write(assignments: Assignment[]): Promise<void> {
    const uri = this.subject?.uri;
    if (uri === undefined) return;
    if (!await this.tryToWrite(uri, assignments) && !await this.tryToWrite(uri, assignments)) {
      this.around.report('The document changed meanwhile: the value was not written.');
      await this.refreshDocument();
    }
    for (const { name } of assignments) this.setParameter(name, null);
  }

  private async tryToWrite(uri: string, assignments: Assignment[]): Promise<boolean> {
    try {
      const edits = await Promise.all(assignments.map(({ name, value }) => this.around.api.parameterEdit({ uri, name, value })));
      const changes = textChanges(edits);
      return changes.length === 0 || await this.around.apply(changes);
    } catch {
      return false;
    }
  }

  private reveal(name: string): void {
    const parameter = this.parameters.find((candidate) => candidate.name === name);
    if (parameter !== undefined && this.subject !== undefined) this.around.reveal(this.subject.uri, parameter);
  }
}

interface Assignment {
  name: string;
  value: number[];
}
