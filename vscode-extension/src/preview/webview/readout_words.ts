// What the readout says, in words.
import type { Direction, Value } from '../messages';

const words: Record<string, string> = { nan: 'NaN', inf: '∞', '-inf': '−∞' };

export function valueText(value: Value): string {
  if (typeof value === 'string') return words[value] ?? value;
  return String(Number(value.toPrecision(4))).replace('-', '−');
}

export function valuesText(values: readonly Value[]): string {
  const texts = values.map(valueText);
  return texts.length === 1 ? texts.join('') : `(${texts.join(', ')})`;
}

export function areNumbers(values: readonly Value[]): boolean {
  return values.every((value) => typeof value === 'number');
}

/** Whether it is a value that a BRDF must not have. */
export function isBadBrdf(values: readonly Value[]): boolean {
  return values.some((value) => typeof value === 'string' || value < 0);
}

export function directionText(name: string, { theta, phi }: Direction): string {
  return `${name} θ ${theta.toFixed(1)}° φ ${phi.toFixed(1)}°`;
}
