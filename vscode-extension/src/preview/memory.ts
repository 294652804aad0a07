// What a preview needs to be as it was when the window is loaded again.
import type { Light, Look } from '../protocol';
import { isObjectLook } from './object_look';

export interface Memory {
  uri: string;
  /** What is to be drawn, if not what the document says. */
  root?: string;
  look: Look;
}

/** From what the page kept; another version of the extension may have written it. */
export function memoryFrom(kept: unknown): Memory | undefined {
  const { uri, root, look } = membersOf(kept);
  if (typeof uri !== 'string' || !isLook(look)) return undefined;
  return { uri, look, ...(typeof root === 'string' ? { root } : {}) };
}

function isLook(value: unknown): value is Look {
  const { light, zoom, exposure, gamma, cosine, object } = membersOf(value);
  return (object === undefined || isObjectLook(object)) && isLight(light) && [zoom, exposure, gamma].every(Number.isFinite) && typeof cosine === 'boolean';
}

function isLight(value: unknown): value is Light {
  const { theta, phi } = membersOf(value);
  return [theta, phi].every(Number.isFinite);
}

function membersOf(value: unknown): Record<string, unknown> {
  return typeof value === 'object' && value !== null ? value as Record<string, unknown> : {};
}
