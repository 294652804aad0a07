import assert from 'node:assert/strict';
import { test } from 'node:test';
import { exportKinds, pictureSize, usualSize } from '../src/export_kinds';

test('only what `texbrdf render` draws is a size', () => {
  assert.deepEqual(['16', ' 300 ', '2048'].map(pictureSize), [16, 300, 2048]);
  for (const text of ['', ' ', '15', '2049', '1e2', '-20', '20.5', '0x40', 'big', '1'.repeat(400)]) assert.equal(pictureSize(text), undefined, text);
  assert.equal(pictureSize(`${usualSize}`), usualSize);
});

test('a size is asked for where the command line has one', () => {
  const withSize = exportKinds.filter((kind) => kind.arguments({ size: 77, exposure: 0, gamma: 2 }).includes('77'));
  assert.deepEqual(withSize, exportKinds.filter(({ isPicture }) => isPicture));
  assert.equal(withSize.length, 1);
});
