// The session shows the document that was opened or edited last in the editor, if there is something to draw in it.
import type { FollowedDocument } from '../../browser_protocol';
import type { Roots } from '../../protocol';
import { isSceneFile } from '../../scene_files';
import type { Subject } from '../session';

export interface Followed {
  readonly uri: string | undefined;
  show: (subject: Subject) => Promise<void>;
  documentChanged: (uri: string, version: number) => void;
  documentClosed: (uri: string) => void;
}

export class Follower {
  private last: FollowedDocument = { uri: null };

  /** `roots` rejects for documents that are not open. */
  constructor(private readonly session: Followed, private readonly roots: (uri: string) => Promise<Roots>) {}

  async follow(document: FollowedDocument): Promise<void> {
    this.last = document;
    const shown = this.session.uri;
    if (document.uri === null) {
      if (shown !== undefined) this.session.documentClosed(shown);
    } else if (document.uri === shown) {
      this.session.documentChanged(document.uri, document.version);
    } else {
      await this.change(document);
    }
  }

  private async change(document: FollowedDocument & { uri: string }): Promise<void> {
    const isDrawable = await this.isDrawable(document.uri);
    if (this.last !== document) return;
    const shown = this.session.uri;
    if (isDrawable || shown === undefined) {
      await this.session.show({ uri: document.uri, name: document.name, version: document.version, root: undefined });
    } else if (!await this.isOpen(shown) && this.session.uri === shown) {
      this.session.documentClosed(shown);
    }
  }

  private isDrawable(uri: string): Promise<boolean> {
    if (isSceneFile(uri)) return Promise.resolve(true);
    return this.roots(uri).then(({ root, candidates }) => root !== null || candidates.length > 0, () => false);
  }

  private isOpen(uri: string): Promise<boolean> {
    return this.roots(uri).then(() => true, () => false);
  }
}
