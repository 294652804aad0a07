// Lobes and slices onto a canvas, in the colours of the page.
import type { Point, Surface, Value } from '../messages';
import { direction, facesOf, projection } from './lobe';
import type { Eye, Face, Projection } from './lobe';
import { scaleFor, fractionOf, tickText, withoutNegative } from './plot_scale';
import type { Scale, ScaleKind } from './plot_scale';
import { heat, pixelsOf, shownPart, sliceFrame } from './slice';

interface Colours {
  text: string;
  grid: string;
  light: string;
  surface: [number, number, number];
}

export interface LobePicture {
  surface: Surface;
  numbers: readonly (Value | null)[];
  earlier: Surface | undefined;
  earlierNumbers: readonly (Value | null)[];
  eye: Eye;
  scaleKind: ScaleKind;
  label: string;
}

export interface SlicePicture {
  surface: Surface;
  numbers: readonly (Value | null)[];
  scaleKind: ScaleKind;
  label: string;
}

/** Clears the canvas and gives it a pixel for each of the display. */
export function prepare(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  const context = canvas.getContext('2d');
  context?.scale(ratio, ratio);
  return context;
}

/** Returns what is drawn of the surface, from behind to the front. */
export function drawLobe(canvas: HTMLCanvasElement, picture: LobePicture): Face[] {
  const context = prepare(canvas);
  if (context === null) return [];
  const { surface, numbers, earlier, earlierNumbers, eye, label } = picture;
  const colours = coloursOf(canvas);
  const scale = withoutNegative(scaleFor(picture.scaleKind, [...numbers, ...earlierNumbers]));
  const view = projection(eye, surface.light.phi ?? 0, { width: canvas.clientWidth, height: canvas.clientHeight });
  drawGround(context, view, scale, colours);
  drawAxes(context, view, surface, colours);
  const lobes = [{ surface, numbers, isPinned: false }, ...earlier === undefined ? [] : [{ surface: earlier, numbers: earlierNumbers, isPinned: true }]];
  const faces = facesOf(lobes, scale, view);
  for (const face of faces) drawFace(context, face, colours);
  write(context, label, { x: 4, y: 12 }, colours, 'left');
  return faces;
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

function drawGround(context: CanvasRenderingContext2D, view: Projection, scale: Scale, colours: Colours): void {
  for (const radius of [1, ...scale.ticks.map((tick) => fractionOf(scale, tick) ?? 0)]) {
    if (radius <= 0) continue;
    outline(context, Array.from({ length: 91 }, (_, i) => view.at(direction(90, 4 * i), radius)));
    context.globalAlpha = radius === 1 ? 0.7 : 0.35;
    context.strokeStyle = colours.grid;
    context.stroke();
    context.globalAlpha = 1;
  }
  const along = direction(90, 45);
  for (const tick of scale.ticks) {
    const radius = fractionOf(scale, tick) ?? 0;
    if (radius > 0) write(context, tickText(scale, tick), view.at(along, radius), colours, 'center');
  }
}

function drawAxes(context: CanvasRenderingContext2D, view: Projection, { light }: Surface, colours: Colours): void {
  const axes = [[90, 0, 'X', colours.text], [90, 90, 'Y', colours.text], [0, 0, 'n', colours.text], [light.theta, light.phi ?? 0, 'ωᵢ', colours.light]] as const;
  for (const [theta, phi, name, colour] of axes) {
    outline(context, [view.at([0, 0, 0], 0), view.at(direction(theta, phi), 1.05)]);
    context.strokeStyle = colour;
    context.stroke();
    write(context, name, view.at(direction(theta, phi), 1.12), colours, 'center');
  }
}

function drawFace(context: CanvasRenderingContext2D, { points, light, isPinned }: Face, { surface, text }: Colours): void {
  outline(context, points);
  context.closePath();
  if (isPinned) {
    context.globalAlpha = 0.12;
    context.fillStyle = text;
    context.fill();
    context.globalAlpha = 1;
    return;
  }
  const shade = rgb([surface[0] * light, surface[1] * light, surface[2] * light]);
  context.fillStyle = shade;
  context.fill();
  context.strokeStyle = shade;
  context.lineWidth = 0.5;
  context.stroke();
  context.lineWidth = 1;
}

function outline(context: CanvasRenderingContext2D, points: readonly Point[]): void {
  context.beginPath();
  points.forEach(({ x, y }, index) => {
    if (index === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
}

function write(context: CanvasRenderingContext2D, text: string, { x, y }: Point, { text: colour }: Colours, align: CanvasTextAlign): void {
  context.fillStyle = colour;
  context.textAlign = align;
  context.fillText(text, x, y);
}

function rgb([red, green, blue]: readonly number[]): string {
  return `rgb(${Math.round(red ?? 0)} ${Math.round(green ?? 0)} ${Math.round(blue ?? 0)})`;
}

/** The colours of the theme, as they stand in the page. */
function coloursOf(canvas: HTMLCanvasElement): Colours {
  const style = getComputedStyle(canvas);
  const named = (name: string, otherwise: string) => style.getPropertyValue(name).trim() || otherwise;
  return { text: style.color, grid: named('--vscode-descriptionForeground', '#888'), light: named('--vscode-charts-yellow', '#c69026'), surface: [62, 139, 255] };
}
