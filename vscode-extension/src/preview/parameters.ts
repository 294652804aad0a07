// The parameters of the drawn BRDF: their values while controls move, and in the document when they are let go.
import type { Parameter } from '../protocol';
import { textChanges } from '../text_changes';
import type { TextChange } from '../text_changes';
import type { ShownPreview } from './shown_preview';

interface Assignment {
  name: string;
  value: number[];
}

export interface Document {
  uri: () => string | undefined;
  /** One step that can be undone; false where the document has changed since. */
  apply: (changes: TextChange[]) => Promise<boolean>;
  report: (problem: string) => void;
}

export class Parameters {
  private list: Parameter[] = [];
  /** The values with which the parameters were first seen: what reset brings back. By document and name. */
  private readonly first = new Map<string, number[]>();

  /** How often each was moved, so that a write does not end what was moved after it. */
  private readonly moves = new Map<string, number>();

  constructor(private readonly shown: ShownPreview, private readonly document: Document) {}

  get isEmpty(): boolean {
    return this.list.length === 0;
  }

  find(name: string): Parameter | undefined {
    return this.list.find((candidate) => candidate.name === name);
  }

  forget(): void {
    this.list = [];
  }

  show(parameters: Parameter[]): void {
    this.list = parameters;
    for (const { name, value } of parameters) if (!this.first.has(this.key(name))) this.first.set(this.key(name), value);
    this.post();
  }

  post(): void {
    this.shown.post({ type: 'parameters', parameters: this.list });
  }

  set(name: string, value: number[] | null): void {
    if (value !== null) this.moves.set(name, (this.moves.get(name) ?? 0) + 1);
    const preview = this.shown.id();
    if (preview !== undefined) this.shown.api.setParameter({ preview, name, value });
  }

  /** Back to the first values. False where the document changed meanwhile. */
  async reset(names: string[]): Promise<boolean> {
    return this.write(names.flatMap((name) => {
      const value = this.first.get(this.key(name));
      return value === undefined ? [] : [{ name, value }];
    }));
  }

  /** Writes the values into the document; only then the pictures follow the document again. False where it changed meanwhile. */
  async write(assignments: Assignment[]): Promise<boolean> {
    const uri = this.document.uri();
    if (uri === undefined) return true;
    const before = new Map(this.moves);
    const written = await this.tryToWrite(uri, assignments) || await this.tryToWrite(uri, assignments);
    if (!written) this.document.report('The document changed meanwhile: the value was not written.');
    for (const { name } of assignments) if (this.moves.get(name) === before.get(name)) this.set(name, null);
    return written;
  }

  private async tryToWrite(uri: string, assignments: Assignment[]): Promise<boolean> {
    try {
      const edits = await Promise.all(assignments.map(({ name, value }) => this.shown.api.parameterEdit({ uri, name, value })));
      const changes = textChanges(edits);
      return changes.length === 0 || await this.document.apply(changes);
    } catch {
      return false;
    }
  }

  private key(name: string): string {
    return `${this.document.uri() ?? ''}\n${name}`;
  }
}
