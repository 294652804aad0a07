import assert from 'node:assert/strict';
import { test } from 'node:test';
import { codeAddress, codeSource, shownCode } from '../src/code_address';
import { browserPage, browserPolicy, contentSecurityPolicy, webviewPage } from '../src/preview/page';

const parts = { nonce: 'abc123', scriptUri: 'vscode://s.js', styleUri: 'vscode://s.css', source: 'vscode://' };

test('the page may load nothing but its own', () => {
  const policy = contentSecurityPolicy(parts);
  assert.match(policy, /^default-src 'none';/);
  assert.doesNotMatch(policy, /unsafe|https?:|\*|connect-src/);
});

test('every script of the page has the nonce, and nothing is inline', () => {
  const page = webviewPage(parts);
  const scripts = page.match(/<script[^>]*>/g) ?? [];
  assert.equal(scripts.length, 1);
  assert.ok(scripts.every((script) => script.includes('nonce="abc123"') && script.includes('src=')));
  assert.doesNotMatch(page, /\son\w+=|\sstyle=/);
});

test('in a browser the page may load nothing but its own, and talk to its own server', () => {
  assert.match(browserPolicy, /^default-src 'none';/);
  assert.doesNotMatch(browserPolicy, /unsafe|https?:|\*/);
  const page = browserPage({ scriptUri: 'preview.js', styleUri: 'preview.css' });
  assert.ok(page.includes(`content="${browserPolicy}"`) && page.includes('<script src="preview.js"></script>'));
  assert.doesNotMatch(page, /nonce|\son\w+=|\sstyle=/);
});

test('every control of the page has a name for screen readers', () => {
  const page = webviewPage(parts);
  for (const [control] of page.matchAll(/<(?:input|select)\b[^>]*>/g)) {
    const before = page.slice(0, page.indexOf(control));
    assert.ok(before.lastIndexOf('<label') > before.lastIndexOf('</label>'), control);
  }
});

test('the address of generated code says what it is made of', () => {
  const source = { uri: 'file:///a/my%20paper.tex', target: 'glsl' as const, root: 'f_{r}' };
  const { path, query } = codeAddress(source);
  assert.equal(path, '/my paper (f_{r}).glsl');
  assert.deepEqual(codeSource(query), source);
});

test('while there is no code, the last good one stays below the reason', () => {
  assert.equal(shownCode('new', undefined, 'old'), 'new');
  assert.equal(shownCode(null, 'undefined\nname', 'old'), '// undefined name\n// What follows is of an earlier version of the document.\n\nold');
  assert.equal(shownCode(undefined, undefined, undefined), '// the document has errors\n');
});
