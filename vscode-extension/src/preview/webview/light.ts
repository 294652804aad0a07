// Turning the light by dragging the sphere: an arcball.
import type { Light } from '../messages';

export type Vector = readonly [number, number, number];

const degree = Math.PI / 180;

export function direction({ theta, phi }: Light): Vector {
  const sine = Math.sin(theta * degree);
  return [sine * Math.cos(phi * degree), sine * Math.sin(phi * degree), Math.cos(theta * degree)];
}

export function lightFrom([x, y, z]: Vector): Light {
  const phi = Math.atan2(y, x) / degree;
  return { theta: Math.atan2(Math.hypot(x, y), z) / degree, phi: phi < 0 ? phi + 360 : phi };
}

/** The point of the unit sphere below a point of the picture, whose sphere has radius 1; outside of it, the nearest on its edge. */
export function onSphere(x: number, y: number): Vector {
  const radius = Math.hypot(x, y);
  return radius < 1 ? [x, y, Math.sqrt(1 - radius * radius)] : [x / radius, y / radius, 0];
}

/** The light, turned as the sphere turns when its point `from` is dragged to `to`. */
export function turned(light: Light, from: Vector, to: Vector): Light {
  const axis = cross(from, to);
  const sine = Math.hypot(...axis);
  if (sine < 1e-9) return light;
  return lightFrom(rotate(direction(light), [axis[0] / sine, axis[1] / sine, axis[2] / sine], Math.atan2(sine, dot(from, to))));
}

/** The light, moved to the right and up by so many degrees. */
export function nudged(light: Light, right: number, up: number): Light {
  const sideways = rotate(direction(light), [0, 1, 0], right * degree);
  return lightFrom(rotate(sideways, [-1, 0, 0], up * degree));
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Rodrigues' formula. */
function rotate(v: Vector, axis: Vector, angle: number): Vector {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  const [across, along] = [cross(axis, v), dot(axis, v) * (1 - cosine)];
  const part = (i: 0 | 1 | 2) => v[i] * cosine + across[i] * sine + axis[i] * along;
  return [part(0), part(1), part(2)];
}
