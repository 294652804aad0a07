// A lobe and the axes through it as triangles on the canvas, for WebGL.
import type { Point } from '../messages';
import { quadsOf } from './lobe';
import type { Lobe, Projection, Vector } from './lobe';
import type { Scale } from './plot_scale';

/** Red, green, blue, opacity, each 0 to 1. */
export type Paint = readonly [number, number, number, number];

/** A line from the origin. */
export interface Axis {
  end: Vector;
  /** 1 is the largest radius of a lobe. */
  length: number;
  paint: Paint;
  /** On the canvas. */
  width: number;
}

/**
 * Floats of a vertex: x and y on the canvas, nearness to the eye from -1.5 to 1.5, a normal (0 where light does not matter), and a paint.
 * Three vertices make a triangle.
 */
export const vertexFloats = 10;

export function lobeTriangles(lobe: Lobe, scale: Scale, eye: Projection, paint: Paint): number[] {
  const quads = quadsOf(lobe, scale);
  const normals = new Map<number, Vector>();
  for (const { samples, normal } of quads) {
    for (const sample of samples) normals.set(sample, plus(normals.get(sample) ?? [0, 0, 0], normal));
  }
  return quads.flatMap(({ corners, samples, normal }) => {
    const vertex = (i: 0 | 1 | 2 | 3) => {
      const { x, y } = eye.at(corners[i], 1);
      return [x, y, eye.nearness(corners[i]), ...normals.get(samples[i]) ?? normal, ...paint];
    };
    return [0, 1, 2, 0, 2, 3].flatMap((i) => vertex(i as 0 | 1 | 2 | 3));
  });
}

export function axisTriangles({ end, length, paint, width }: Axis, eye: Projection): number[] {
  const [from, to] = [eye.at(end, 0), eye.at(end, length)];
  const beside = perpendicular(from, to, width / 2);
  const vertex = ({ x, y }: Point, side: number, nearness: number) => [x + side * beside.x, y + side * beside.y, nearness, 0, 0, 0, ...paint];
  const far = length * eye.nearness(end);
  const [a, b, c, d] = [vertex(from, 1, 0), vertex(from, -1, 0), vertex(to, -1, far), vertex(to, 1, far)] as const;
  return [a, b, c, a, c, d].flat();
}

function perpendicular(from: Point, to: Point, length: number): Point {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const size = Math.hypot(x, y);
  return size === 0 ? { x: 0, y: 0 } : { x: -y / size * length, y: x / size * length };
}

function plus(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
