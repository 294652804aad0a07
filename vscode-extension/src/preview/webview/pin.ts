// A picture that is kept, to be compared with later ones: beside them, or over their left part; and its curves.
import { element } from './host';
import { pinPlot } from './plots';

const stage = element('stage');
const picture = element<HTMLImageElement>('picture');
const pinned = element<HTMLImageElement>('pinned');
const button = element<HTMLButtonElement>('pin');
const choice = element<HTMLSelectElement>('compare');
const wipe = element<HTMLInputElement>('wipe');

export function watchPin(): void {
  button.addEventListener('click', () => {
    if (pinned.hidden) pin();
    else unpin();
  });
  choice.addEventListener('change', refresh);
  wipe.addEventListener('input', refresh);
}

export function unpin(): void {
  pinned.hidden = true;
  pinned.removeAttribute('src');
  pinPlot(false);
  refresh();
}

function pin(): void {
  if (picture.hidden) return;
  pinned.src = picture.src;
  pinned.hidden = false;
  pinPlot(true);
  refresh();
}

function refresh(): void {
  const isPinned = !pinned.hidden;
  button.setAttribute('aria-pressed', String(isPinned));
  button.textContent = isPinned ? 'Unpin' : 'Pin';
  element('comparison').hidden = !isPinned;
  element('wipeLabel').hidden = !isPinned || choice.value !== 'over';
  stage.dataset.compare = isPinned ? choice.value : 'none';
  pinned.style.setProperty('--wipe', `${wipe.value}%`);
}
