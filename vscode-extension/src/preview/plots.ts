// The curves beside the sphere: asked for anew with each picture, as long as the page shows them.
import type { Plot } from '../protocol';
import { OneAtATime } from './one_at_a_time';
import type { ShownPreview } from './shown_preview';

export class Plots {
  private areShown = false;
  private last: Plot | undefined;
  private readonly questions = new OneAtATime<number, Plot | null>(
    (preview) => this.shown.api.plot({ preview, kind: 'cartesian' }), // The data of both kinds are the same.
    (plot) => { this.arrived(plot); },
  );

  constructor(private readonly shown: ShownPreview) {}

  show(areShown: boolean): void {
    this.areShown = areShown;
    this.repeat();
    this.refresh();
  }

  /** The picture changed. */
  refresh(): void {
    const preview = this.shown.id();
    if (this.areShown && preview !== undefined) this.questions.put(preview);
  }

  forget(): void {
    this.last = undefined;
    this.questions.forget();
  }

  /** Null where nothing was drawn so far. */
  private arrived(plot: Plot | null): void {
    if (plot === null || JSON.stringify(plot) === JSON.stringify(this.last)) return;
    this.last = plot;
    this.repeat();
  }

  private repeat(): void {
    if (this.areShown && this.last !== undefined) this.shown.post({ type: 'plot', plot: this.last });
  }
}
