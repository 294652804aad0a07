// The picture, its status line, and the mark where it is not of the present text.
import type { Picture } from '../messages';
import { countBadPixels, unmarkBadPixel } from './bad_pixels';
import { element, tell } from './host';
import { freshness, statusText } from './status_line';

const image = element<HTMLImageElement>('picture');
const stage = element('stage');
const notice = element('notice');
const status = element<HTMLOutputElement>('status');

let documentVersion = 0;
let last: Picture | undefined;
let problem = '';
/** How often the picture was forgotten: one that was decoded meanwhile is of another document. */
let forgotten = 0;

export async function showPicture(picture: Picture): Promise<void> {
  const before = forgotten;
  image.src = `data:image/png;base64,${picture.png}`;
  // Acknowledged also when it cannot be shown: otherwise no other would follow.
  await image.decode().catch(() => undefined);
  if (forgotten !== before) return;
  image.hidden = false;
  last = picture;
  countBadPixels(picture.badPixels);
  refresh();
  requestAnimationFrame(() => { tell({ type: 'shown' }); });
}

export function showVersion(version: number): void {
  if (version !== documentVersion) unmarkBadPixel();
  documentVersion = version;
  refresh();
}

export function showState(state: 'good' | 'errors' | 'none', message: string): void {
  problem = state === 'good' ? '' : message;
  stage.dataset.state = state;
  refresh();
}

export function forgetPicture(): void {
  ++forgotten;
  last = undefined;
  problem = '';
  image.hidden = true;
  image.removeAttribute('src');
  countBadPixels({ nan: 0, infinite: 0, negative: 0 });
  refresh();
}

export function shownPicture(): Picture | undefined {
  return last;
}

/** For the clipboard. */
export async function pictureBlob(): Promise<Blob> {
  const bytes = Uint8Array.from(atob(last?.png ?? ''), (character) => character.charCodeAt(0));
  return Promise.resolve(new Blob([bytes], { type: 'image/png' }));
}

function refresh(): void {
  const fresh = last === undefined ? 'current' : freshness(last, documentVersion);
  stage.dataset.fresh = fresh;
  status.textContent = last === undefined ? '' : statusText(last);
  notice.textContent = noticeText(fresh);
  const what = document.body.dataset.kind === 'scene' ? 'The scene' : 'The BRDF on a lit object';
  image.alt = last === undefined ? '' : `${what}. ${statusText(last)}`;
}

function noticeText(fresh: ReturnType<typeof freshness>): string {
  if (problem !== '') return last === undefined ? problem : `${problem} — this is the last good picture`;
  switch (fresh) {
    case 'errors': return 'The document has errors: this is the last good picture';
    case 'outdated': return 'Drawing …';
    case 'current': return '';
  }
}
