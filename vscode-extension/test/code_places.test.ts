import assert from 'node:assert/strict';
import { test } from 'node:test';
import { placeAt, placeOfLine } from '../src/code_places';
import type { Place } from '../src/protocol';

const place = (name: string, uri: string, first: number, last: number, lines: [number, number]): Place =>
  ({ name, uri, range: { start: { line: first, character: 2 }, end: { line: last, character: 9 } }, lines });
const places = [place('whole', 'a', 0, 20, [0, 1]), place('f', 'a', 4, 6, [10, 12]), place('D', 'b', 4, 4, [13, 13])];

test('a place in an equation leads to its code, from its first column to its last', () => {
  const at = (uri: string, line: number, character: number) => placeAt(places, uri, { line, character })?.name;
  assert.equal(at('b', 4, 2), 'D');
  assert.equal(at('b', 4, 9), 'D');
  assert.equal(at('b', 4, 1), undefined);
  assert.equal(at('b', 4, 10), undefined);
  assert.equal(at('c', 4, 3), undefined);
});

test('of equations around a place the shortest counts', () => {
  assert.equal(placeAt(places, 'a', { line: 5, character: 0 })?.name, 'f');
  assert.equal(placeAt(places, 'a', { line: 7, character: 0 })?.name, 'whole');
});

test('a line of code leads to its equation', () => {
  assert.deepEqual([9, 10, 12, 13, 14].map((line) => placeOfLine(places, line)?.name), [undefined, 'f', 'f', 'D', undefined]);
});
