// What happens in the text: squiggle, hover, definition, fix, rename, a server that is killed.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, readlinkSync } from 'node:fs';
import path from 'node:path';
import { waitUntil } from './editor.mjs';

const wrong = { in: '\\frac' };

/** The process ids of the server that this editor runs. */
export function servers(editor) {
  return readdirSync('/proc').filter((name) => /^\d+$/.test(name)).filter((id) => {
    try {
      return readlinkSync(`/proc/${id}/exe`).startsWith(path.join(editor.folder, 'extensions')) && readFileSync(`/proc/${id}/cmdline`, 'utf8').includes('lsp');
    } catch {
      return false;
    }
  }).map(Number);
}

export const textSteps = [
  {
    name: 'the squiggle lies under the wrong word',
    run: async (editor) => {
      await editor.open('paper.tex');
      await editor.page.locator('.codelens-decoration', { hasText: 'preview' }).waitFor(); // It moves the lines below it.
      await editor.waitForSquiggles(1);
      const squiggle = await editor.page.locator('.editor-instance .squiggly-error').boundingBox();
      const word = await editor.wordBox('\\theta_hh', wrong);
      assert.ok(Math.abs(squiggle.x - word.x) < 1.5 && Math.abs(squiggle.width - word.width) < 1.5, JSON.stringify({ squiggle, word }));
    },
  },
  {
    name: 'the status bar counts it and shows the server',
    run: async (editor) => {
      await editor.page.locator('#status\\.problems a[aria-label*="1"]').waitFor();
      await editor.page.locator('.statusbar-item a[aria-label^="texbrdf: ready"]').waitFor();
    },
  },
  {
    name: 'its message',
    run: async (editor) => {
      await editor.hover('\\theta', 'E3001', wrong);
    },
  },
  {
    name: 'hover shows the type',
    run: async (editor) => {
      await editor.hover('\\rho_d', 'ℝ³', wrong);
    },
  },
  {
    name: 'F12 goes to the definition',
    run: async (editor) => {
      await editor.click('\\rho_d', wrong);
      await editor.waitForCaret('Ln 20');
      await editor.page.keyboard.press('F12');
      await editor.waitForCaret('Ln 6, Col 3');
    },
  },
  {
    name: 'a fix is applied',
    run: async (editor) => {
      await editor.click('\\theta_hh', wrong);
      await editor.page.keyboard.press('Control+.');
      await editor.page.locator('.action-widget .monaco-list-row', { hasText: 'replace by' }).first().waitFor();
      await editor.page.keyboard.press('Enter');
      await editor.waitForSquiggles(0);
      await editor.waitForSource(/\\cos\{\\theta_h\}/);
    },
  },
  {
    name: 'rename',
    run: async (editor) => {
      await editor.click('k', { in: '0.3' });
      await editor.page.keyboard.press('F2');
      const input = editor.page.locator('.rename-box input, .rename-input').first();
      await input.fill('k_s');
      await editor.page.keyboard.press('Enter');
      await editor.page.locator('.view-line', { hasText: '+ k_s *' }).waitFor();
      await editor.waitForSource(/k_s = 0\.3[^]*\\pi\} \+ k_s \* /);
    },
  },
  {
    name: 'hover shows the definition over the sphere',
    run: async (editor) => {
      const hover = await editor.hover('f', 'over the hemisphere', wrong);
      const picture = hover.locator('img[src^="data:image/png;base64,"]');
      await picture.waitFor();
      assert.equal(await picture.evaluate((image) => image.naturalWidth), 64);
    },
  },
  {
    name: 'a server that is killed comes back',
    run: async (editor) => {
      const [first, ...more] = servers(editor);
      assert.ok(first !== undefined && more.length === 0, 'one server');
      process.kill(first, 'SIGKILL');
      await waitUntil(() => servers(editor), ([another]) => another !== undefined && another !== first);
      await editor.hover('\\rho_d', 'ℝ³', wrong);
    },
  },
  {
    name: 'a server that hangs is ended by a restart',
    run: async (editor) => {
      const [first] = servers(editor);
      process.kill(first, 'SIGSTOP');
      await editor.command('texbrdf: Restart server');
      await waitUntil(() => servers(editor), ([another, ...more]) => another !== undefined && another !== first && more.length === 0);
      await editor.page.locator('.statusbar-item a[aria-label^="texbrdf: ready"]').waitFor();
      await editor.hover('\\rho_d', 'ℝ³', wrong);
    },
  },
  {
    name: 'after five crashes there is a message, and a restart on demand',
    run: async (editor) => {
      const message = editor.page.locator('.notification-toast', { hasText: 'texbrdf does not run' });
      for (let tries = 0; tries < 300 && !await message.isVisible(); ++tries) {
        for (const id of servers(editor)) process.kill(id, 'SIGKILL');
        await editor.page.waitForTimeout(100);
      }
      await editor.page.locator('.statusbar-item a[aria-label^="texbrdf: does not run: it crashed 5 times, last with SIGKILL"]').waitFor();
      assert.equal(await editor.page.locator('.notification-toast').count(), 1);
      await editor.screenshot('five-crashes');
      await message.getByText('Restart', { exact: true }).click();
      await editor.page.locator('.statusbar-item a[aria-label^="texbrdf: ready"]').waitFor();
      await editor.hover('\\rho_d', 'ℝ³', wrong);
    },
  },
  {
    name: 'typing fast keeps the editor answering',
    run: async (editor, { say }) => {
      await editor.click('0.3', { in: 'k_s' });
      await editor.page.keyboard.press('End');
      const burst = async () => {
        const started = Date.now();
        for (let round = 0; round < 10; ++round) {
          await editor.page.keyboard.type('12345678');
          for (let digit = 0; digit < 8; ++digit) await editor.page.keyboard.press('Backspace');
        }
        return Date.now() - started;
      };
      const first = await burst();
      await editor.hover('\\rho_d', 'ℝ³', wrong);
      say(`        320 keys in ${first + await burst()} ms`);
      await editor.page.keyboard.type('\\undefinedname');
      await editor.waitForSquiggles(1);
      for (let letter = 0; letter < 14; ++letter) await editor.page.keyboard.press('Backspace');
      await editor.waitForSquiggles(0);
    },
  },
];
