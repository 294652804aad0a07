// Canvases that surfaces are drawn on: their size, words, and the colours of the page.
import type { Point } from '../messages';

export interface Colours {
  text: string;
  grid: string;
  light: string;
  surface: [number, number, number];
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

export function write(context: CanvasRenderingContext2D, text: string, { x, y }: Point, { text: colour }: Colours, align: CanvasTextAlign): void {
  context.fillStyle = colour;
  context.textAlign = align;
  context.fillText(text, x, y);
}

export function rgb([red, green, blue]: readonly number[]): string {
  return `rgb(${Math.round(red ?? 0)} ${Math.round(green ?? 0)} ${Math.round(blue ?? 0)})`;
}

/** The colours of the theme, as they stand in the page. */
export function coloursOf(canvas: HTMLCanvasElement): Colours {
  const style = getComputedStyle(canvas);
  const named = (name: string, otherwise: string) => style.getPropertyValue(name).trim() || otherwise;
  return { text: style.color, grid: named('--vscode-descriptionForeground', '#888'), light: named('--vscode-charts-yellow', '#c69026'), surface: [62, 139, 255] };
}

/** Red, green and blue, 0 to 255, of a colour as CSS writes it. */
export function partsOf(colour: string): [number, number, number] {
  const context = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  if (context === null) return [128, 128, 128];
  context.fillStyle = colour;
  context.fillRect(0, 0, 1, 1);
  const [red = 128, green = 128, blue = 128] = context.getImageData(0, 0, 1, 1).data;
  return [red, green, blue];
}
