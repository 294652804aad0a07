// Generated code beside its document.
import assert from 'node:assert/strict';
import { waitUntil } from './editor.mjs';

const exponent = { in: '% range' };

/** The marked parts of the text that lie in the line of a word. */
async function marksBeside(editor, word, options) {
  const { x, y, height } = await editor.wordBox(word, options);
  return editor.page.evaluate(([wordX, middle]) => [...document.querySelectorAll('.view-overlays .cdr[class*="ced-"]')].filter((node) => {
    const box = node.getBoundingClientRect();
    return box.top <= middle && middle <= box.bottom && box.left <= wordX + 1 && box.right >= wordX;
  }).length, [x, y + height / 2]);
}

export const codeSteps = [
  {
    name: 'generated code opens beside the text',
    run: async (editor) => {
      await editor.click('range', exponent);
      await editor.command('texbrdf: Show generated code');
      await editor.pick('GLSL');
      await editor.page.locator('.view-line', { hasText: 'const float p = 60.0;' }).waitFor();
    },
  },
  {
    name: 'an equation reveals its code, and code its equation',
    run: async (editor) => {
      await editor.click('k_s', { in: '0.3' });
      await waitUntil(() => marksBeside(editor, 'const float k_s'), (count) => count === 1);
      await editor.screenshot('an-equation-marks-its-code');
      await editor.click('rho_d / pi');
      await waitUntil(() => marksBeside(editor, '\\rho_d', { in: '\\frac' }), (count) => count > 0);
      assert.equal(await marksBeside(editor, 'const float k_s'), 0);
      await editor.screenshot('code-marks-its-equation');
    },
  },
  {
    name: 'generated code follows the text, and its mark the caret',
    run: async (editor) => {
      await editor.select('60', exponent);
      await editor.page.keyboard.type('33');
      await editor.page.locator('.view-line', { hasText: 'const float p = 33.0;' }).waitFor();
      await waitUntil(() => marksBeside(editor, 'const float p ='), (count) => count === 1);
    },
  },
];
