// From the first bad pixel to the definition that makes it bad.
import type { Location } from '../protocol';
import { wordsOf } from '../words_of';
import type { ShownPreview } from './shown_preview';

export interface Pointer {
  reveal: (place: Location) => void;
  report: (problem: string) => void;
}

export async function showBadPixel(shown: ShownPreview, { reveal, report }: Pointer): Promise<void> {
  const preview = shown.id();
  if (preview === undefined) return;
  try {
    const found = await shown.api.badPixels(preview);
    if (preview !== shown.id()) return;
    const first = found?.first ?? null;
    if (first === null) {
      report(found?.problem ?? (found === null ? 'Nothing that can be drawn was searched.' : 'In double precision no pixel is bad: single precision is at fault.'));
      return;
    }
    shown.post({ type: 'badPixel', pixel: first });
    if (first.location === null) report(`The document has no definition of ${first.label} any more.`);
    else reveal(first.location);
  } catch (error) {
    report(wordsOf(error));
  }
}
