// A document of several files: the sliders of the preview lead into the file that a number stands in, and write there.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { waitUntil } from './editor.mjs';
import { frame, waitForOther } from './pictures.mjs';

const row = (editor) => editor.webview.locator('.row:has(button.link:text-is("m"))');
const number = (editor) => row(editor).locator('input[type=number]');
const source = (editor, file) => readFileSync(path.join(editor.workspace, file), 'utf8');

export const projectSteps = [
  {
    name: 'a change of another file moves the slider',
    run: async (editor) => {
      await editor.open('report.tex');
      await editor.webview.locator('#name', { hasText: 'report.tex' }).waitFor();
      await waitUntil(() => number(editor).inputValue(), (value) => value === '0.25');
      writeFileSync(path.join(editor.workspace, 'parts/gloss.tex'), source(editor, 'parts/gloss.tex').replace('0.25', '0.5'));
      await waitUntil(() => number(editor).inputValue(), (value) => value === '0.5');
    },
  },
  {
    name: 'a number in another file is written there when its slider is let go',
    run: async (editor) => {
      const [before, report] = [await frame(editor), source(editor, 'report.tex')];
      await number(editor).fill('0.75');
      await number(editor).press('Enter');
      await waitUntil(() => source(editor, 'parts/gloss.tex'), (text) => text.includes('m = 0.75 %'));
      assert.equal(source(editor, 'report.tex'), report);
      await waitForOther(editor, before);
    },
  },
  {
    name: 'its label leads to that file',
    run: async (editor) => {
      await row(editor).locator('button.link').click();
      await editor.page.locator('.tab.active', { hasText: 'gloss.tex' }).waitFor();
      await editor.waitForCaret('Ln 2, Col 11 (4 selected)');
      await editor.open('paper.tex');
      await editor.webview.locator('#name', { hasText: 'paper.tex' }).waitFor();
    },
  },
];
