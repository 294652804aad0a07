// The surface of all f · ω_o, seen in parallel from an eye that goes around it: where it is on the canvas, and its faces from behind to the
// front.
import type { Point, Surface, Value } from '../messages';
import type { PlotSize } from './plot_frame';
import { fractionOf } from './plot_scale';
import type { Scale } from './plot_scale';

export interface Eye {
  /** Degrees from where a mirror sends the light, around the normal. */
  azimuth: number;
  /** Degrees above the surface, 0 to 90. */
  elevation: number;
}

/** A corner of the surface's grid stands for a sample. */
export interface Face {
  points: Point[];
  /** 0 to 1: how much light it gets. */
  light: number;
  sample: number;
  isPinned: boolean;
}

export type Vector = readonly [number, number, number];

const degree = Math.PI / 180;
/** The part of the light that every face gets. */
export const ambient = 0.4;

export interface Projection {
  at(direction: Vector, length: number): Point;
  nearness(v: Vector): number;
  /** Where the light comes from. */
  lamp: Vector;
  light(normal: Vector): number;
}

export function projection({ azimuth, elevation }: Eye, lightPhi: number, { width, height }: PlotSize): Projection {
  const around = (lightPhi + 180 + azimuth) * degree;
  const [sine, cosine] = [Math.sin(elevation * degree), Math.cos(elevation * degree)];
  const right: Vector = [-Math.sin(around), Math.cos(around), 0];
  const towards: Vector = [cosine * Math.cos(around), cosine * Math.sin(around), sine];
  const up = cross(towards, right);
  const above = Math.max(1.08 * cosine, sine);
  const radius = Math.max(Math.min(width / 2 - 24, (height - 40) / (above + sine + 0.1)) / 1.08, 10);
  const origin = { x: width / 2, y: 20 + (height - 40 - radius * (above + sine)) / 2 + radius * above };
  const lamp: Vector = [0, 1, 2].map((i) => (towards[i] ?? 0) + 0.3 * (up[i] ?? 0) - 0.3 * (right[i] ?? 0)) as unknown as Vector;
  return {
    at: (v, length) => ({ x: origin.x + radius * length * dot(v, right), y: origin.y - radius * length * dot(v, up) }),
    nearness: (v) => dot(v, towards),
    lamp,
    light: (normal) => {
      const size = Math.sqrt(dot(normal, normal) * dot(lamp, lamp));
      return size === 0 ? 1 : ambient + (1 - ambient) * Math.abs(dot(normal, lamp)) / size;
    },
  };
}

export function direction(theta: number, phi: number): Vector {
  const s = Math.sin(theta * degree);
  return [s * Math.cos(phi * degree), s * Math.sin(phi * degree), Math.cos(theta * degree)];
}

export interface Lobe {
  surface: Surface;
  /** One number for each sample. */
  numbers: readonly (Value | null)[];
  isPinned: boolean;
}

export function facesOf(lobes: readonly Lobe[], scale: Scale, eye: Projection): Face[] {
  const faces = lobes.flatMap((lobe) => facesOfOne(lobe, scale, eye));
  return faces.sort((a, b) => a.nearness - b.nearness).map(({ face }) => face);
}

function facesOfOne(lobe: Lobe, scale: Scale, eye: Projection): { nearness: number; face: Face }[] {
  return quadsOf(lobe, scale).map(({ corners, normal, sample }) => {
    const nearness = corners.reduce((sum, corner) => sum + eye.nearness(corner) / 4, 0);
    return { nearness, face: { points: corners.map((corner) => eye.at(corner, 1)), light: eye.light(normal), sample, isPinned: lobe.isPinned } };
  });
}

/** A cell of the surface's grid. */
export interface Quad {
  /** The largest radius is 1. */
  corners: readonly [Vector, Vector, Vector, Vector];
  /** The places of the corners in the list of samples. */
  samples: readonly [number, number, number, number];
  /** Of any length, towards either side. */
  normal: Vector;
  /** What stands for the cell. */
  sample: number;
}

/** Between each four samples that have a place. */
export function quadsOf({ surface: { rows, columns }, numbers }: Lobe, scale: Scale): Quad[] {
  const corners = rows.flatMap((theta, row) => columns.map((phi, column) => {
    const fraction = fractionOf(scale, numbers[row * columns.length + column] ?? 'nan');
    return fraction === undefined ? undefined : scaled(direction(theta, phi), Math.max(fraction, 0));
  }));
  const found: Quad[] = [];
  for (let row = 1; row < rows.length; ++row) {
    for (let column = 1; column < columns.length; ++column) {
      const sample = row * columns.length + column;
      const samples = [sample - columns.length - 1, sample - columns.length, sample, sample - 1] as const;
      const [a, b, c, d] = samples.map((at) => corners[at]);
      if (a === undefined || b === undefined || c === undefined || d === undefined) continue;
      found.push({ corners: [a, b, c, d], samples, normal: cross(minus(c, a), minus(d, b)), sample });
    }
  }
  return found;
}

/** The sample of the frontmost face at a place. */
export function sampleUnder(faces: readonly Face[], place: Point): number | undefined {
  for (let i = faces.length - 1; i >= 0; --i) {
    const face = faces[i];
    if (face !== undefined && !face.isPinned && isInside(face.points, place)) return face.sample;
  }
  return undefined;
}

function isInside(points: readonly Point[], { x, y }: Point): boolean {
  let inside = false;
  points.forEach((a, index) => {
    const b = points[(index + points.length - 1) % points.length] ?? a;
    if (a.y > y !== b.y > y && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  });
  return inside;
}

function scaled(v: Vector, factor: number): Vector {
  return [v[0] * factor, v[1] * factor, v[2] * factor];
}

function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
