// What the parts of a session share: the preview that is shown, its server and its page.
import type { Api } from '../protocol';
import type { ToPage } from './messages';

export interface ShownPreview {
  api: Api;
  post: (message: ToPage) => void;
  /** Its number; undefined while there is none. */
  id: () => number | undefined;
}
