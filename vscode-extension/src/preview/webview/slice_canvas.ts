// Slices onto a canvas, in the colours of the page.
import type { Point, Surface, Value } from '../messages';
import { coloursOf, prepare, rgb, write } from './canvas';
import type { Colours } from './canvas';
import { scaleFor, fractionOf, tickText, withoutNegative } from './plot_scale';
import type { Scale, ScaleKind } from './plot_scale';
import { heat, pixelsOf, shownPart, sliceFrame } from './slice';

export interface SlicePicture {
  surface: Surface;
  numbers: readonly (Value | null)[];
  scaleKind: ScaleKind;
  label: string;
}

export function drawSlice(canvas: HTMLCanvasElement, { surface, numbers, scaleKind, label }: SlicePicture): void {
  const context = prepare(canvas);
  if (context === null || surface.rows.length === 0) return;
  const colours = coloursOf(canvas);
  const scale = withoutNegative(scaleFor(scaleKind, scaleKind === 'linear' ? shownPart(numbers) : numbers));
  const { left, top, side } = sliceFrame({ width: canvas.clientWidth, height: canvas.clientHeight });
  const cells = document.createElement('canvas');
  [cells.width, cells.height] = [surface.columns.length, surface.rows.length];
  cells.getContext('2d')?.putImageData(new ImageData(pixelsOf(surface, numbers, scale), cells.width, cells.height), 0, 0);
  context.imageSmoothingEnabled = false;
  context.drawImage(cells, left, top, side, side);
  for (const angle of [0, 30, 60, 90]) {
    const along = angle / 90 * side;
    write(context, `${angle}°`, { x: left + along, y: top + side + 13 }, colours, 'center');
    write(context, `${angle}°`, { x: left - 4, y: top + side - along + 4 }, colours, 'right');
  }
  write(context, 'θ_h', { x: left + side / 2, y: top + side + 26 }, colours, 'center');
  write(context, 'θ_d', { x: left - 22, y: top + side / 2 - 20 }, colours, 'right');
  drawBar(context, { x: left + side + 10, y: top }, side, scale, label, colours);
}

function drawBar(context: CanvasRenderingContext2D, { x, y }: Point, side: number, scale: Scale, label: string, colours: Colours): void {
  for (let i = 0; i < side; ++i) {
    context.fillStyle = rgb(heat(1 - i / side));
    context.fillRect(x, y + i, 10, 1.5);
  }
  for (const tick of scale.ticks) write(context, tickText(scale, tick), { x: x + 13, y: y + side * (1 - (fractionOf(scale, tick) ?? 0)) + 4 }, colours, 'left');
  write(context, label, { x, y: y + side + 26 }, colours, 'left');
}
