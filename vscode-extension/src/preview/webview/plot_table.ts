// The numbers of a plot as CSV: a row for each sample, digits that read back as the same number.
import type { Plot, Surface, Value } from '../messages';

const channelNames = ['red', 'green', 'blue'];

export function curveTable({ angles, values, errors }: Plot, angleName: string): string {
  const names = namesOf(values.length);
  const head = [angleName, ...names, ...errors === undefined ? [] : names.map((name) => `${name}_error`)];
  const rows = angles.map((angle, index) => [angle, ...cellsAt(values, index), ...cellsAt(errors ?? [], index)]);
  return table(head, rows);
}

export function surfaceTable({ rows, columns, values }: Surface, angleNames: [string, string]): string {
  const cells = rows.flatMap((row, i) => columns.map((column, k) => [row, column, ...cellsAt(values, i * columns.length + k)]));
  return table([...angleNames, ...namesOf(values.length)], cells);
}

function namesOf(channels: number): string[] {
  return channels === 1 ? ['value'] : channelNames.slice(0, channels);
}

/** Empty where a direction is below the surface. */
function cellsAt(values: readonly (readonly (Value | null)[])[], index: number): (Value | '')[] {
  return values.map((list) => list[index] ?? '');
}

function table(head: string[], rows: (Value | '')[][]): string {
  return [head, ...rows].map((row) => `${row.join(',')}\n`).join('');
}
