// Numbers as people would choose them.

/** The step of a slider: 1, 2 or 5 times a power of ten, of which its range has some hundreds. */
export function sliderStep(low: number, high: number): number {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return 1e-3;
  const exact = span / 500;
  const power = 10 ** Math.floor(Math.log10(exact));
  const factor = [5, 2, 1].find((candidate) => candidate * power <= exact * (1 + 1e-9)) ?? 1;
  return Number((factor * power).toPrecision(1));
}

/** The multiple of the step that is nearest, without the tail of digits that binary fractions bring. */
export function rounded(value: number, step: number): number {
  const decimals = Math.min(Math.max(0, -Math.floor(Math.log10(step))), 15);
  return Number((Math.round(value / step) * step).toFixed(decimals));
}

export function shown(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(6))) : String(value);
}

export function clamped(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}
