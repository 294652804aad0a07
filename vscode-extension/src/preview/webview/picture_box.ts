// Where the picture lies in the window: a square in the middle of its element.
import type { Point } from '../messages';
import { element } from './host';

const stage = element('stage');
const image = element<HTMLImageElement>('picture');

export interface PictureBox {
  centre: Point;
  side: number;
}

export function pictureBox(): PictureBox {
  const { left, top, width, height } = (image.hidden ? stage : image).getBoundingClientRect();
  return { centre: { x: left + width / 2, y: top + height / 2 }, side: Math.min(width, height) };
}

/** The point of the picture below the pointer; undefined beside it. */
export function pictureFraction({ clientX, clientY }: MouseEvent): Point | undefined {
  const { centre, side } = pictureBox();
  const [x, y] = [0.5 + (clientX - centre.x) / side, 0.5 + (clientY - centre.y) / side];
  return x >= 0 && x <= 1 && y >= 0 && y <= 1 ? { x, y } : undefined;
}

/** Puts a mark at a point of the picture, or takes it away. */
export function placeMark(id: string, at: Point | undefined): void {
  const mark = document.getElementById(id);
  if (at !== undefined) {
    mark?.setAttribute('cx', String(at.x));
    mark?.setAttribute('cy', String(at.y));
  }
  mark?.setAttribute('visibility', at === undefined ? 'hidden' : 'visible');
}
