// What is at a point of the picture: directions, the BRDF's value, and that of a definition that was chosen.
import type { Definition, Point, Probed } from '../protocol';
import { OneAtATime } from './one_at_a_time';
import type { ShownPreview } from './shown_preview';

interface Question {
  preview: number;
  point: Point;
  definition: string | undefined;
}

export class Readout {
  private point: Point | undefined;
  private definitions: Definition[] = [];
  private chosen: string | undefined;
  private readonly questions = new OneAtATime<Question, Probed | null>(
    ({ preview, point, definition }) => this.shown.api.probe({ preview, ...point, ...(definition === undefined ? {} : { definition }) }),
    (readout) => { this.shown.post({ type: 'probed', readout }); },
  );

  constructor(private readonly shown: ShownPreview) {}

  /** Undefined: the pointer left the picture. */
  pointAt(point: Point | undefined): void {
    this.point = point;
    if (point === undefined) this.questions.forget();
    this.refresh();
  }

  choose(name: string | undefined): void {
    this.chosen = name;
    this.postDefinitions();
    this.refresh();
  }

  /** The picture changed. */
  refresh(): void {
    const preview = this.shown.id();
    if (this.point !== undefined && preview !== undefined) this.questions.put({ preview, point: this.point, definition: this.choice });
  }

  setDefinitions(definitions: Definition[]): void {
    if (JSON.stringify(definitions) === JSON.stringify(this.definitions)) return;
    this.definitions = definitions;
    this.postDefinitions();
  }

  postDefinitions(): void {
    this.shown.post({ type: 'definitions', definitions: this.definitions, chosen: this.choice ?? null });
  }

  forget(): void {
    this.questions.forget();
  }

  /** What was chosen, as long as the BRDF needs it; it may come back with the next key. */
  private get choice(): string | undefined {
    return this.definitions.find(({ name }) => name === this.chosen)?.name;
  }
}
