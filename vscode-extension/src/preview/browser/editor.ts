// The editor on the other side of the server: it changes documents and shows places when it is asked to.
import type { Edited } from '../../browser_protocol';
import type { TextChange } from '../../text_changes';
import type { Link } from './link';

const patience = 5000; // ms
const textFollowsWithin = 1000;

/** Resolves with undefined when the time is over. */
function within<T>(milliseconds: number, wait: (found: (value: T) => void) => void): Promise<T | undefined> {
  return new Promise((resolve) => {
    const timer = setTimeout(() => { resolve(undefined); }, milliseconds);
    wait((value) => {
      clearTimeout(timer);
      resolve(value);
    });
  });
}

export class Editor {
  private readonly outcomes = new Map<number, boolean>();
  private readonly edits = new Map<number, (applied: boolean) => void>();
  private afterNextText: (() => void)[] = [];

  constructor(private readonly link: Link) {
    link.on('texbrdf/edited', (edited) => { this.wasEdited(edited); });
    link.on('texbrdf/document', () => { this.textArrived(); });
  }

  /** True once the server has the changed text as well, so that no picture of the old one follows. */
  async apply(changes: TextChange[]): Promise<boolean> {
    const text = new Promise<void>((resolve) => { this.afterNextText.push(resolve); });
    const { edit } = await this.link.request('texbrdf/applyEdit', { changes });
    const applied = await this.outcome(edit);
    if (applied) await within<void>(textFollowsWithin, (found) => { void text.then(found); });
    return applied;
  }

  private async outcome(edit: number): Promise<boolean> {
    const known = this.outcomes.get(edit);
    this.outcomes.delete(edit);
    return known ?? await within<boolean>(patience, (found) => { this.edits.set(edit, found); }) ?? false;
  }

  private wasEdited({ edit, applied }: Edited): void {
    const found = this.edits.get(edit);
    this.edits.delete(edit);
    if (found === undefined) this.outcomes.set(edit, applied);
    else found(applied);
  }

  private textArrived(): void {
    for (const found of this.afterNextText) found();
    this.afterNextText = [];
  }
}
