// The preview in a browser: the page of the webview and the session of the extension in one window, the server behind HTTP.
import { onPageMessage, postToPage } from './vscode_stand_in';
import '../webview/main';
import { Api } from '../../protocol';
import type { Roots } from '../../protocol';
import { defaultLook } from '../default_look';
import { Session } from '../session';
import { Editor } from './editor';
import { Follower } from './follower';
import { Link } from './link';

const none: Roots = { root: null, candidates: [] };

function report(problem: string): void {
  postToPage({ type: 'state', state: 'none', message: problem });
}

function saveImage(png: string, name: string): void {
  download(`data:image/png;base64,${png}`, `${name.replace(/\.\w+$/, '')}.png`);
}

function saveTable(table: string, fileName: string): void {
  download(`data:text/csv;charset=utf-8,${encodeURIComponent(table)}`, fileName);
}

function download(address: string, fileName: string): void {
  const anchor = document.createElement('a');
  anchor.href = address;
  anchor.download = fileName;
  anchor.click();
}

const link = new Link(() => {
  session.close();
  report('texbrdf is gone. When the editor starts it again, it is at another address.');
});
const api = new Api(link);
const editor = new Editor(link);
const session = new Session({
  api,
  post: postToPage,
  apply: (changes) => editor.apply(changes),
  reveal: (place) => { link.request('texbrdf/reveal', place).catch((error: unknown) => { report(String(error)); }); },
  roots: (uri) => api.roots(uri).catch(() => none),
  saveImage, saveTable, report,
  standardLook: () => defaultLook,
});
const follower = new Follower(session, api.roots);

link.on('texbrdf/welcome', () => { void session.reopen(); });
link.on('texbrdf/document', (document) => {
  if (document.uri === null && session.uri === undefined) report('Open a LaTeX document in the editor: it is drawn here.');
  void follower.follow(document);
});
link.on('texbrdf/frame', (frame) => { session.frameArrived(frame); });
link.on('texbrdf/previewState', (state) => { session.stateArrived(state); });
onPageMessage((message) => { void session.pageSays(message); });
void session.pageSays({ type: 'ready' });
