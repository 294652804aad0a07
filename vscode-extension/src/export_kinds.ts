// What can be exported, and the command line that makes it.
import { largestSide, smallestSide } from './protocol';

export interface Picture {
  size: number;
  exposure: number;
  gamma: number;
}

export interface ExportKind {
  label: string;
  description: string;
  extension: string;
  isPicture?: true;
  arguments: (picture: Picture) => string[];
  /** More arguments for a second try where there is no renderer (exit status 3). */
  withoutRenderer?: string[];
}

export const exportKinds: ExportKind[] = [
  { label: 'Disney BRDF Explorer', description: '.brdf', extension: 'brdf', arguments: () => ['compile', '--target', 'disney'] },
  { label: 'GLSL', description: '.glsl', extension: 'glsl', arguments: () => ['compile', '--target', 'glsl'] },
  {
    label: 'Picture of a sphere', description: '.png', extension: 'png', isPicture: true,
    arguments: ({ size, exposure, gamma }) => ['render', '--size', `${size}`, '--exposure', `${exposure}`, '--gamma', `${gamma}`],
    withoutRenderer: ['--device', 'cpu'],
  },
  { label: 'Syntax trees', description: '.svg', extension: 'svg', arguments: () => ['ast', '--format', 'svg'] },
];

export const usualSize = 512;
export const sizeHint = `A whole number of pixels, ${smallestSide} to ${largestSide}`;

/** What somebody typed, in pixels; undefined where no picture has that size. */
export function pictureSize(text: string): number | undefined {
  const size = /^\s*\d+\s*$/.test(text) ? Number(text) : 0;
  return size >= smallestSide && size <= largestSide ? size : undefined;
}

export const noRenderer = 3;
