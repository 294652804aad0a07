// The axis of a plot's values: its ends and its ticks, as people would choose them.
import type { Value } from '../messages';

export type ScaleKind = 'linear' | 'log';

export interface Scale {
  kind: ScaleKind;
  /** Of the axis; exponents of ten where it is logarithmic. */
  low: number;
  high: number;
  /** Values, not exponents. */
  ticks: number[];
}

const someTicks = 4;
const mostDecades = 8;
const largest = 1e300;
const smallest = 1e-300;

export function scaleFor(kind: ScaleKind, values: readonly (Value | null)[]): Scale {
  const numbers = values.filter((value) => typeof value === 'number');
  return kind === 'linear' ? linearScale(numbers) : logScale(numbers);
}

/** For a plot whose origin is 0: what is negative has no place. */
export function withoutNegative(scale: Scale): Scale {
  return scale.kind === 'log' || scale.high <= 0 ? scale : { ...scale, low: Math.max(scale.low, 0) };
}

/** Where a value lies between the ends, 0 to 1; undefined where it has no place. */
export function fractionOf({ kind, low, high }: Scale, value: Value): number | undefined {
  if (typeof value === 'string') return undefined;
  const place = kind === 'linear' ? value : Math.log10(value);
  const fraction = (place - low) / (high - low);
  return Number.isNaN(fraction) || fraction < -1e-9 ? undefined : Math.min(fraction, 1);
}

export function tickText({ kind }: Scale, value: number): string {
  if (value === 0) return '0';
  const exponent = Math.log10(Math.abs(value));
  if (kind === 'linear' && exponent > -4 && exponent < 5) return String(Number(value.toPrecision(4))).replace('-', '−');
  if (kind === 'log' && Math.abs(exponent) < 2.5) return String(Number(value.toPrecision(1)));
  if (kind === 'log') return `10${superscript(Math.round(exponent))}`;
  return value.toPrecision(2).replace('-', '−');
}

function linearScale(values: readonly number[]): Scale {
  const least = Math.max(values.reduce((a, b) => Math.min(a, b), 0), -largest);
  const most = Math.min(values.reduce((a, b) => Math.max(a, b), 0), largest);
  if (most - least < smallest) return { kind: 'linear', low: 0, high: 1, ticks: [0, 0.5, 1] };
  const step = niceStep((most - least) / someTicks);
  const [first, last] = [Math.floor(least / step + 1e-9), Math.ceil(most / step - 1e-9)];
  return { kind: 'linear', low: first * step, high: last * step, ticks: multiples(first, last, step) };
}

function niceStep(atLeast: number): number {
  const power = 10 ** Math.floor(Math.log10(atLeast));
  return power * ([1, 2, 5].find((factor) => factor * power >= atLeast * (1 - 1e-9)) ?? 10);
}

function logScale(values: readonly number[]): Scale {
  const positive = values.filter((value) => value > 0 && value >= smallest);
  if (positive.length === 0) return { kind: 'log', low: -1, high: 0, ticks: [0.1, 1] };
  const most = Math.min(positive.reduce((a, b) => Math.max(a, b)), largest);
  const high = Math.ceil(Math.log10(most) - 1e-9);
  const least = Math.floor(Math.log10(positive.reduce((a, b) => Math.min(a, b))) + 1e-9);
  const low = Math.min(Math.max(least, high - mostDecades), high - 1);
  const step = Math.ceil((high - low) / someTicks);
  const exponents = multiples(0, Math.floor((high - low) / step), step).map((below) => high - below).reverse();
  return { kind: 'log', low, high, ticks: exponents.map((exponent) => Number(`1e${exponent}`)) };
}

function multiples(first: number, last: number, step: number): number[] {
  return Array.from({ length: last - first + 1 }, (_, index) => Number(((first + index) * step).toPrecision(12)));
}

function superscript(exponent: number): string {
  return [...String(exponent)].map((digit) => digit === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('');
}
