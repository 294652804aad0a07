// A picture that is kept, to be compared with later ones: beside them, or over their left part; and its curves.
import type { Pin } from '../messages';
import { element, keep, kept, tell } from './host';
import { shownPicture } from './picture';
import { showPinnedFurther, shownFurther } from './further_plot';
import { shownPlot, showPinnedPlot } from './plots';

const stage = element('stage');
const pinned = element<HTMLImageElement>('pinned');
const button = element<HTMLButtonElement>('pin');
const choice = element<HTMLSelectElement>('compare');
const wipe = element<HTMLInputElement>('wipe');

export function watchPin(): void {
  recall();
  button.addEventListener('click', () => { tell({ type: 'pin', pin: pinned.hidden ? shownState() : null }); });
  choice.addEventListener('change', () => {
    keep({ compare: choice.value });
    refresh();
  });
  wipe.addEventListener('change', () => { keep({ wipe: wipe.value }); });
  wipe.addEventListener('input', refresh);
}

export function showPin(pin: Pin | null): void {
  pinned.hidden = pin === null;
  if (pin === null) pinned.removeAttribute('src');
  else pinned.src = `data:image/png;base64,${pin.png}`;
  showPinnedPlot(pin?.plot ?? undefined);
  showPinnedFurther(pin?.further);
  refresh();
}

function shownState(): Pin | null {
  const picture = shownPicture();
  if (picture === undefined) return null;
  const further = shownFurther();
  return { png: picture.png, plot: shownPlot() ?? null, ...further === undefined ? {} : { further } };
}

function recall(): void {
  const { compare, wipe: part } = kept();
  if (compare === 'over') choice.value = compare;
  if (typeof part === 'string') wipe.value = part;
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
