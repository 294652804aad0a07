// A preview of one document after the other: keeps the server and the page of right account of each other. Knows nothing of VS Code.
import { Debounce } from '../debounce';
import { largestSide, smallestSide } from '../protocol';
import type { FrameParams, Look, PreviewStateParams, Roots } from '../protocol';
import { isSceneFile } from '../scene_files';
import { wordsOf } from '../words_of';
import { showBadPixel } from './bad_pixels';
import type { FromPage, Pin } from './messages';
import { Parameters } from './parameters';
import { Pictures } from './pictures';
import { FurtherPlots, Plots } from './plots';
import { Readout } from './readout';
import { ScenePart } from './scene';
import type { ShownPreview } from './shown_preview';
import type { Subject, Surroundings } from './surroundings';

export type { Subject, Surroundings };

const documentAfter = 40; // ms of quiet
const rememberAfter = 200;

export class Session {
  private subject: Subject | undefined;
  private look: Look;
  /** Of the pane, in device pixels; there is no preview before the page has told it. */
  private side: number | undefined;
  private preview: number | undefined;
  /** Grows with each document, so that answers about an earlier one are known. */
  private turn = 0;
  private pageReady = false;
  /** Outlives the page, which is made anew when its tab was hidden. */
  private pinned: { uri: string; pin: Pin } | undefined;
  private roots: Roots = { root: null, candidates: [] };
  private readonly shown: ShownPreview;
  private readonly pictures: Pictures;
  private readonly parameters: Parameters;
  private readonly readout: Readout;
  private readonly plots: Plots;
  private readonly furtherPlots: FurtherPlots;
  private readonly scene: ScenePart;
  private readonly soon = new Debounce(documentAfter);
  private readonly later = new Debounce(rememberAfter);

  constructor(private readonly around: Surroundings, look?: Look) {
    this.look = look ?? around.standardLook();
    this.shown = { api: around.api, post: around.post, id: () => this.preview };
    this.pictures = new Pictures(this.shown);
    this.parameters = new Parameters(this.shown, { uri: () => this.uri, apply: around.apply, report: around.report });
    this.readout = new Readout(this.shown);
    this.plots = new Plots(this.shown);
    this.furtherPlots = new FurtherPlots(this.shown);
    this.scene = new ScenePart(this.shown);
  }

  get uri(): string | undefined {
    return this.subject?.uri;
  }

  private get isScene(): boolean {
    return this.subject !== undefined && isSceneFile(this.subject.uri);
  }

  async show(subject: Subject): Promise<void> {
    this.close();
    this.scene.forget();
    this.subject = subject;
    this.parameters.forget();
    this.roots = { root: null, candidates: [] };
    this.postDocument();
    this.postPin();
    this.remember();
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
    this.later.cancel();
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
    this.refreshSoon();
  }

  frameArrived(frame: FrameParams): void {
    if (frame.preview !== this.preview) return;
    if (this.pictures.frameArrived(frame)) this.refreshSoon();
    if (this.isScene) this.scene.frameArrived(frame);
    if (!this.pageReady) return;
    this.pictures.post();
    if (this.isScene) return;
    this.readout.refresh();
    this.plots.refresh();
    this.furtherPlots.refresh();
  }

  /** After each change of what is drawn, wherever in the project it was made: numbers may be others too. */
  stateArrived(state: PreviewStateParams): void {
    if (state.preview !== this.preview) return;
    this.pictures.stateArrived(state);
    if (this.isScene) this.scene.stateArrived(state);
    this.refreshSoon();
  }

  /** The page is gone, as when its tab is hidden. What it did not show stays unacknowledged: no picture is sent to nobody. */
  pageLost(): void {
    this.pageReady = false;
    this.readout.pointAt(undefined);
    this.plots.show(false);
    this.furtherPlots.choose(undefined);
  }

  async pageSays(message: FromPage): Promise<void> {
    switch (message.type) {
      case 'ready': this.greetPage(); break;
      case 'shown': this.pictures.acknowledge(); break;
      case 'size': await this.resize(message.side); break;
      case 'look': this.changeLook(message.change); break;
      case 'root': await this.chooseRoot(message.root); break;
      case 'set': this.parameters.set(message.name, message.value); break;
      case 'write': await this.written(this.parameters.write([{ name: message.name, value: message.value }])); break;
      case 'reset': await this.written(this.parameters.reset(message.names)); break;
      case 'reveal': this.revealParameter(message.name); break;
      case 'probe': this.readout.pointAt(message.point ?? undefined); break;
      case 'definition': this.readout.choose(message.name ?? undefined); break;
      case 'plots': this.plots.show(message.shown); break;
      case 'furtherPlot': this.furtherPlots.choose(message.question ?? undefined); break;
      case 'saveTable': this.around.saveTable(message.table, `${(this.subject?.name ?? '').replace(/\.\w+$/, '')}-${message.kind}.csv`); break;
      case 'pin': this.pin(message.pin); break;
      case 'sceneInput': this.scene.input(message.input); break;
      case 'sceneView': this.scene.choose(message.view); break;
      case 'showBad': await showBadPixel(this.shown, this.around); break;
      case 'saveImage': if (this.pictures.png !== undefined) this.around.saveImage(this.pictures.png, this.subject?.name ?? ''); break;
    }
  }

  private async open(): Promise<void> {
    const { subject, side } = this;
    if (subject === undefined || side === undefined) return;
    const turn = ++this.turn;
    const sent = { side, look: this.look, root: subject.root };
    try {
      const preview = this.isScene ? await this.scene.open(subject.uri, side) : await this.openSphere(subject.uri, side);
      if (turn === this.turn) this.opened(preview, sent);
      else this.around.api.closePreview(preview);
    } catch (error) {
      if (turn === this.turn) this.around.post({ type: 'state', state: 'none', message: wordsOf(error) });
      return;
    }
    if (turn === this.turn) await this.refreshDocument();
  }

  private async openSphere(uri: string, side: number): Promise<number> {
    const { preview } = await this.around.api.openPreview({ uri, view: 'sphere', width: side, height: side, ...this.rootOption(), ...this.look });
    return preview;
  }

  /** What changed while it was opened is told now. */
  private opened(preview: number, sent: { side: number; look: Look; root: string | undefined }): void {
    this.preview = preview;
    const { side = sent.side, look } = this;
    const change = {
      ...(look === sent.look ? {} : look),
      ...(side === sent.side ? {} : { width: side, height: side }),
      ...(this.subject?.root === sent.root ? {} : this.rootOption()),
    };
    if (Object.keys(change).length > 0) this.update(change);
  }

  private rootOption(): { root?: string } {
    return this.subject?.root === undefined ? {} : { root: this.subject.root };
  }

  private forgetPreview(): void {
    ++this.turn;
    this.preview = undefined;
    this.pictures.forget();
    this.readout.forget();
    this.plots.forget();
    this.furtherPlots.forget();
  }

  private greetPage(): void {
    this.pageReady = true;
    this.postDocument();
    this.around.post({ type: 'look', look: this.look, standard: this.around.standardLook() });
    this.parameters.post();
    this.readout.postDefinitions();
    this.postPin();
    this.remember();
    this.pictures.postState();
    this.pictures.post();
  }

  private postDocument(): void {
    const { subject } = this;
    if (subject === undefined) return;
    const root = subject.root ?? this.roots.root;
    this.around.post({ type: 'document', uri: subject.uri, name: subject.name, version: subject.version, roots: this.roots.candidates, root, isScene: this.isScene });
    if (this.isScene) this.scene.post();
  }

  private pin(pin: Pin | null): void {
    if (this.subject === undefined) return;
    this.pinned = pin === null ? undefined : { uri: this.subject.uri, pin };
    this.postPin();
  }

  private postPin(): void {
    const pin = this.pinned?.uri === this.subject?.uri ? this.pinned?.pin : undefined;
    this.around.post({ type: 'pinned', pin: pin ?? null });
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
    this.remember();
  }

  private update(change: Partial<Look> & { width?: number; height?: number; root?: string }): void {
    const { preview, around: { api } } = this;
    if (preview === undefined) return;
    if (!this.isScene) api.updatePreview({ preview, ...change });
    else if (change.width !== undefined && change.height !== undefined) api.updateScene({ preview, width: change.width, height: change.height });
  }

  private async chooseRoot(root: string): Promise<void> {
    if (this.subject === undefined) return;
    this.subject = { ...this.subject, root };
    this.update({ root });
    this.remember();
    await this.refreshDocument();
  }

  private refreshSoon(): void {
    this.soon.run(() => { void this.refreshDocument(); });
  }

  private async refreshDocument(): Promise<void> {
    const { subject, turn } = this;
    if (subject === undefined || this.isScene) return;
    const model = { uri: subject.uri, ...this.rootOption() };
    const [parameters, definitions, roots] = await Promise.all([
      this.around.api.parameters(model).catch(() => undefined),
      this.around.api.definitions(model).catch(() => undefined),
      this.around.roots(subject.uri),
    ]);
    if (turn !== this.turn) return;
    this.roots = roots;
    this.postDocument();
    // With errors some may be missing; controls that come and go at each key would be in the way.
    if (this.pictures.hasErrors && !this.parameters.isEmpty) return;
    if (parameters !== undefined) this.parameters.show(parameters);
    if (definitions !== undefined) this.readout.setDefinitions(definitions);
  }

  private async written(isWritten: Promise<boolean>): Promise<void> {
    if (!await isWritten) await this.refreshDocument();
  }

  private revealParameter(name: string): void {
    const parameter = this.parameters.find(name);
    if (parameter !== undefined) this.around.reveal(parameter.location);
  }

  /** For a window that is loaded again. */
  private remember(): void {
    this.later.run(() => {
      if (this.subject !== undefined) this.around.post({ type: 'remember', memory: { uri: this.subject.uri, ...this.rootOption(), look: this.look } });
    });
  }
}
