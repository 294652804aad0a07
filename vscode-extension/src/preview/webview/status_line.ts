// The words below the picture, and the mark on a picture that is not of the present text.
import type { BadPixels, Picture } from '../messages';

export function statusText(picture: Picture): string {
  const { source, width, height, milliseconds, version, badPixels, samples } = picture;
  const counted = samples === undefined ? [] : [`${samples.drawn} of ${samples.all} samples`];
  const parts = [source.toUpperCase(), `${width} × ${height}`, ...counted, `${milliseconds.toFixed(1)} ms`, `version ${version}`, ...badText(badPixels)];
  return parts.join(' · ');
}

function badText({ nan, infinite, negative }: BadPixels): string[] {
  const counted: [number, string][] = [[nan, 'NaN'], [infinite, 'infinite'], [negative, 'negative']];
  const present = counted.filter(([count]) => count > 0).map(([count, what]) => `${count} ${what}`);
  return present.length === 0 ? [] : [`bad pixels: ${present.join(', ')}`];
}

export type Freshness = 'current' | 'outdated' | 'errors';

/** Whether the picture shows the text of the document's version. */
export function freshness(picture: Pick<Picture, 'version' | 'current'>, documentVersion: number): Freshness {
  if (!picture.current) return 'errors';
  return picture.version < documentVersion ? 'outdated' : 'current';
}
