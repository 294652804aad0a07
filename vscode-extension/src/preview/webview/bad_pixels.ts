// Where the picture is bad: a button that asks for it, and a ring around the first such pixel.
import type { BadPixels, FirstBadPixel } from '../messages';
import { element, tell } from './host';
import { placeMark } from './picture_box';

const button = element<HTMLButtonElement>('showBad');

export function watchBadPixels(): void {
  button.addEventListener('click', () => { tell({ type: 'showBad' }); });
}

export function countBadPixels({ nan, infinite, negative }: BadPixels): void {
  button.hidden = nan + infinite + negative === 0;
}

export function markBadPixel(pixel: FirstBadPixel): void {
  placeMark('badMark', pixel);
}

/** What is drawn now is another thing. */
export function unmarkBadPixel(): void {
  placeMark('badMark', undefined);
}
