import assert from 'node:assert/strict';
import { test } from 'node:test';
import { textChanges } from '../src/text_changes';

const range = { start: { line: 1, character: 2 }, end: { line: 1, character: 4 } };

test('both forms of edits are read, and versions kept', () => {
  const versioned = { documentChanges: [{ textDocument: { uri: 'file:///a', version: 3 }, edits: [{ range, newText: '1' }, { range, newText: '2' }] }] };
  const plain = { changes: { 'file:///b': [{ range, newText: '3' }] } };
  assert.deepEqual(textChanges([versioned, plain]), [
    { uri: 'file:///a', version: 3, range, newText: '1' },
    { uri: 'file:///a', version: 3, range, newText: '2' },
    { uri: 'file:///b', version: null, range, newText: '3' },
  ]);
});

test('what is no change of text is left out', () => {
  assert.deepEqual(textChanges([{ documentChanges: [{ kind: 'delete', uri: 'file:///a' }] }, {}]), []);
});
