// What a session works with: the editor, or the browser, around it.
import type { Api, Location, Look, Roots } from '../protocol';
import type { TextChange } from '../text_changes';
import type { ToPage } from './messages';

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
  reveal: (place: Location) => void;
  saveImage: (png: string, name: string) => void;
  saveTable: (table: string, fileName: string) => void;
  roots: (uri: string) => Promise<Roots>;
  report: (problem: string) => void;
  standardLook: () => Look;
}
