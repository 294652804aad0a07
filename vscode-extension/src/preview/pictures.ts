// The pictures of a preview on their way to the page, one at a time; and whether the document can be drawn.
import type { FrameParams, PreviewStateParams } from '../protocol';
import type { ShownPreview } from './shown_preview';

export class Pictures {
  private frame: FrameParams | undefined;
  private unacknowledged = false;
  private state: PreviewStateParams | undefined;

  constructor(private readonly shown: ShownPreview) {}

  get png(): string | undefined {
    return this.frame?.png;
  }

  get hasErrors(): boolean {
    return this.state?.state === 'errors';
  }

  /** True where the document has no errors any more. */
  frameArrived(frame: FrameParams): boolean {
    this.frame = frame;
    this.unacknowledged = true;
    if (this.state === undefined || !frame.current || frame.version <= this.state.version) return false;
    const hadErrors = this.hasErrors;
    this.stateArrived({ ...this.state, state: 'good', message: '' });
    return hadErrors;
  }

  stateArrived(state: PreviewStateParams): void {
    this.state = state;
    this.postState();
  }

  acknowledge(): void {
    const preview = this.shown.id();
    if (!this.unacknowledged || preview === undefined) return;
    this.unacknowledged = false;
    this.shown.api.frameShown(preview);
  }

  post(): void {
    if (this.frame === undefined) return;
    const { version, source, width, height, png, milliseconds, badPixels, current, samples } = this.frame;
    const counted = samples === undefined ? {} : { samples };
    this.shown.post({ type: 'picture', picture: { version, source, width, height, png, milliseconds, badPixels, current, ...counted } });
  }

  postState(): void {
    if (this.state !== undefined) this.shown.post({ type: 'state', state: this.state.state, message: this.state.message });
  }

  forget(): void {
    this.frame = undefined;
    this.state = undefined;
    this.unacknowledged = false;
  }
}
