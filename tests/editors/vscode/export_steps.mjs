// Files that are written: each is what the program itself writes.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { difference, most } from './pictures.mjs';

/** Exports the document of the active editor under the name that is proposed, and gives what was written. */
async function exported(editor, kind, name, size) {
  await editor.click('range', { in: '% range' });
  await editor.command('texbrdf: Export');
  await editor.pick(kind);
  if (size !== undefined) await editor.answer('Width and height of the picture', `${size}`);
  await editor.waitForFileDialog(name);
  await editor.page.keyboard.press('Enter');
  await editor.page.locator('.notification-toast', { hasText: `texbrdf wrote ${name}.` }).waitFor();
  return readFileSync(path.join(editor.workspace, name));
}

function exportStep(kind, name, command, check, size) {
  return {
    name: `export writes ${name}`,
    run: async (editor, { program }) => {
      await editor.source();
      const written = await exported(editor, kind, name, size);
      await check(editor, written, execFileSync(program, [...command, 'paper.tex', '-o', '-'], { cwd: editor.workspace }));
    },
  };
}

function same(begins) {
  return (_, written, expected) => {
    assert.match(expected.toString(), begins);
    assert.equal(written.toString(), expected.toString());
  };
}

async function samePicture(editor, written, expected) {
  const apart = await difference(editor, written.toString('base64'), expected.toString('base64'));
  assert.ok(apart <= most, `${apart}/255 away from texbrdf render`);
}

export const exportSteps = [
  exportStep('GLSL', 'paper.glsl', ['compile', '--target', 'glsl'], same(/const float p = 33\.0;/)),
  exportStep('Disney BRDF Explorer', 'paper.brdf', ['compile', '--target', 'disney'], same(/^float p 1 500 33$/m)),
  exportStep('Syntax trees', 'paper.svg', ['ast', '--format', 'svg'], same(/^<\?xml|<svg/)),
  exportStep('Picture of a sphere', 'paper.png', ['render', '--size', '300'], samePicture, 300),
];
