import assert from 'node:assert/strict';
import { test } from 'node:test';
import { memoryFrom } from '../src/preview/memory';
import { look } from './fake_server';

test('what was kept comes back', () => {
  const memory = { uri: 'file:///a.tex', root: 'g', look };
  assert.deepEqual(memoryFrom(JSON.parse(JSON.stringify(memory))), memory);
  assert.deepEqual(memoryFrom({ uri: 'file:///a.tex', look }), { uri: 'file:///a.tex', look });
});

test('anything else is nothing', () => {
  const other = [undefined, null, 'text', 3, {}, { uri: 'file:///a.tex' }, { uri: 3, look }, { uri: 'a', look: { ...look, zoom: 'big' } },
    { uri: 'a', look: { ...look, light: { theta: 3 } } }, { uri: 'a', look: { ...look, light: null } }];
  for (const kept of other) assert.equal(memoryFrom(kept), undefined, JSON.stringify(kept));
});
