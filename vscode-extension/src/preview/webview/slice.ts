// A slice over half vector and difference angle: where it lies, and the colours of its cells.
import type { Point, Surface, Value } from '../messages';
import { clamped } from './numbers';
import type { PlotSize } from './plot_frame';
import { fractionOf } from './plot_scale';
import type { Scale } from './plot_scale';

export interface SliceFrame {
  left: number;
  top: number;
  side: number;
}

export type Rgb = readonly [number, number, number];

const stops: readonly (readonly [number, Rgb])[] = [
  [0, [0, 0, 4]], [0.2, [60, 15, 112]], [0.45, [160, 40, 110]], [0.7, [238, 95, 60]], [0.88, [252, 180, 60]], [1, [255, 255, 215]],
];
const belowHorizon: Rgb = [128, 128, 128];
const noNumber: Rgb = [255, 0, 255];

export function sliceFrame({ width, height }: PlotSize): SliceFrame {
  const side = Math.max(Math.min(width - 110, height - 40), 10);
  return { left: Math.max((width - side - 70) / 2, 0) + 40, top: 8, side };
}

/** From black over blue, red and yellow to white, lighter all the way. */
export function heat(fraction: number): Rgb {
  const index = Math.max(stops.findIndex(([at]) => at >= fraction), 1);
  const [low, high] = [stops[index - 1], stops[index]];
  if (low === undefined || high === undefined) return noNumber;
  const part = (fraction - low[0]) / (high[0] - low[0]);
  const channel = (c: 0 | 1 | 2) => Math.round(low[1][c] + part * (high[1][c] - low[1][c]));
  return [channel(0), channel(1), channel(2)];
}

export function colourOf(value: Value | null, scale: Scale): Rgb {
  if (value === null) return belowHorizon;
  if (typeof value === 'string') return noNumber;
  return heat(clamped(fractionOf(scale, value) ?? 0, 0, 1));
}

/** What nearly all numbers are below: a few near the horizon are often far above all others. */
export function shownPart(values: readonly (Value | null)[]): number[] {
  const numbers = values.filter((value) => typeof value === 'number').sort((a, b) => a - b);
  return numbers.slice(0, Math.ceil(numbers.length * 0.98));
}

/** Row by row from the top, where the difference angle is largest; red, green, blue, opacity of each cell. */
export function pixelsOf({ rows, columns }: Surface, numbers: readonly (Value | null)[], scale: Scale): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(rows.length * columns.length * 4);
  rows.forEach((_, row) => {
    columns.forEach((__, column) => {
      const colour = colourOf(numbers[row * columns.length + column] ?? null, scale);
      pixels.set([...colour, 255], ((rows.length - 1 - row) * columns.length + column) * 4);
    });
  });
  return pixels;
}

/** The sample of the cell at a place. */
export function cellUnder({ rows, columns }: Surface, { left, top, side }: SliceFrame, { x, y }: Point): number | undefined {
  const [across, up] = [(x - left) / side, 1 - (y - top) / side];
  if (!(across >= 0 && across < 1 && up >= 0 && up < 1)) return undefined;
  return Math.floor(up * rows.length) * columns.length + Math.floor(across * columns.length);
}
