// The curves beside the sphere: asked for anew with each picture, as long as the page shows them.
import type { Plot, Surface } from '../protocol';
import type { FurtherQuestion } from './messages';
import { OneAtATime } from './one_at_a_time';
import type { ShownPreview } from './shown_preview';

export class Plots {
  private areShown = false;
  private last: Plot | undefined;
  private readonly questions = new OneAtATime<number, Plot | Surface | null>(
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
  private arrived(plot: Plot | Surface | null): void {
    if (plot === null || isSurface(plot) || JSON.stringify(plot) === JSON.stringify(this.last)) return;
    this.last = plot;
    this.repeat();
  }

  private repeat(): void {
    if (this.areShown && this.last !== undefined) this.shown.post({ type: 'plot', plot: this.last });
  }
}

/** The plot that the page asks for beside those, of whatever kind. */
export class FurtherPlots {
  private question: FurtherQuestion | undefined;
  private last: Plot | Surface | undefined;
  private readonly questions = new OneAtATime<{ preview: number; question: FurtherQuestion }, Plot | Surface | null>(
    ({ preview, question }) => this.shown.api.plot({ preview, ...question }),
    (plot, { question }) => { this.arrived(plot, question); },
  );

  constructor(private readonly shown: ShownPreview) {}

  choose(question: FurtherQuestion | undefined): void {
    this.question = question;
    this.last = undefined;
    this.refresh();
  }

  /** The picture changed. */
  refresh(): void {
    const preview = this.shown.id();
    if (this.question !== undefined && preview !== undefined) this.questions.put({ preview, question: this.question });
  }

  forget(): void {
    this.last = undefined;
    this.questions.forget();
  }

  private arrived(plot: Plot | Surface | null, question: FurtherQuestion): void {
    if (plot === null || question !== this.question || JSON.stringify(plot) === JSON.stringify(this.last)) return;
    this.last = plot;
    this.shown.post({ type: 'furtherPlot', further: { question, plot } });
  }
}

export function isSurface(plot: Plot | Surface): plot is Surface {
  return 'rows' in plot;
}
