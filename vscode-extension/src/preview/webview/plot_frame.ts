// The two ways to lay out a plot over the viewer's angle: where a point goes, and which angle a point means.
import type { Point } from '../messages';
import { clamped } from './numbers';

export interface PlotSize {
  width: number;
  height: number;
}

export interface PlotFrame {
  /** Where the angle, in degrees, has a value that lies so far along the axis, 0 to 1. */
  at(angle: number, fraction: number): Point;
  angleAt(point: Point): number;
}

export interface CartesianFrame extends PlotFrame {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export interface PolarFrame extends PlotFrame {
  centre: Point;
  radius: number;
}

const degree = Math.PI / 180;

/** The angles of an axis, and what they are. */
export interface AngleAxis {
  low: number;
  high: number;
  ticks: readonly number[];
  label: string;
}

export const viewerAxis: AngleAxis = { low: -90, high: 90, ticks: [-90, -60, -30, 0, 30, 60, 90], label: 'θₒ' };

export function quarterAxis(label: string): AngleAxis {
  return { low: 0, high: 90, ticks: [0, 15, 30, 45, 60, 75, 90], label };
}

export function cartesianFrame({ width, height }: PlotSize, { low, high }: AngleAxis = viewerAxis): CartesianFrame {
  const [left, top] = [40, 20];
  const [right, bottom] = [Math.max(width - 10, left + 10), Math.max(height - 30, top + 10)];
  return {
    left, right, top, bottom,
    at: (angle, fraction) => ({ x: left + (angle - low) / (high - low) * (right - left), y: bottom - fraction * (bottom - top) }),
    angleAt: ({ x }) => clamped((x - left) / (right - left) * (high - low) + low, low, high),
  };
}

export function polarFrame({ width, height }: PlotSize): PolarFrame {
  const [side, top, bottom] = [34, 18, 30];
  const radius = Math.max(Math.min(width / 2 - side, height - top - bottom), 10);
  const centre = { x: width / 2, y: top + (height - top - bottom + radius) / 2 };
  return {
    centre, radius,
    at: (angle, fraction) => ({
      x: centre.x + fraction * radius * Math.sin(angle * degree), y: centre.y - fraction * radius * Math.cos(angle * degree),
    }),
    angleAt: ({ x, y }) => clamped(Math.atan2(x - centre.x, centre.y - y) / degree, -90, 90),
  };
}
