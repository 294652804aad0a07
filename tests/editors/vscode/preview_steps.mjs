// The preview beside the text: frames, the light, sliders, undo.
import assert from 'node:assert/strict';
import { waitUntil } from './editor.mjs';
import { frame, waitForOther, waitForPicture } from './pictures.mjs';

/** Milliseconds from a key to the picture of what it typed, as the page shows it; of the browser's driver too. */
async function keyToPicture(editor, key) {
  const page = editor.webview.locator('#status');
  const version = /version (\d+)/.exec(await page.textContent())[1];
  const shown = page.evaluate((status, old) => new Promise((resolve) => {
    const look = () => {
      if (status.textContent.includes(`version ${old}`)) requestAnimationFrame(look);
      else resolve(Date.now());
    };
    look();
  }), version);
  const pressed = Date.now();
  await editor.page.keyboard.press(key);
  return await shown - pressed;
}

const exponent = { in: '% range' };
const slider = (editor) => editor.webview.locator('.row:has(button.link:text-is("p"))');

export const previewSteps = [
  {
    name: 'the preview opens beside the text and shows it',
    run: async (editor, { program }) => {
      await editor.page.locator('.editor-actions a[aria-label^="Open preview to the side"]').click();
      await waitForPicture(editor, program);
      const { width, height } = await frame(editor);
      assert.ok(width === height && width > 200, `${width} × ${height}`);
    },
  },
  {
    name: 'typing a number changes the picture',
    run: async (editor, { program }) => {
      const before = await frame(editor);
      await editor.select('60', exponent);
      await editor.page.keyboard.type('9');
      await editor.waitForSource(/p = 9 %/);
      await waitForPicture(editor, program);
      await waitForOther(editor, before);
      await waitUntil(() => slider(editor).locator('input[type=number]').inputValue(), (value) => value === '9');
    },
  },
  {
    name: 'pictures follow keys',
    run: async (editor, { say }) => {
      await editor.click('9', exponent);
      const times = [];
      for (let round = 0; round < 10; ++round) {
        for (const key of ['1', 'Backspace']) times.push(await keyToPicture(editor, key));
      }
      times.sort((a, b) => a - b);
      say(`        key to picture: median ${times[10]} ms, least ${times[0]}, most ${times[19]}; ${(await frame(editor, '')).status}`);
      await editor.waitForSource(/p = 9 %/);
    },
  },
  {
    name: 'an error leaves the last good picture, marked',
    run: async (editor, { program }) => {
      await editor.click('9', exponent);
      await editor.page.keyboard.type('x');
      await editor.waitForSquiggles(1);
      await editor.webview.locator('#notice', { hasText: 'last good picture' }).waitFor();
      await editor.screenshot('an-error-in-the-text');
      await editor.page.keyboard.press('Backspace');
      await editor.waitForSquiggles(0);
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'moving a slider changes the picture, letting it go the document',
    run: async (editor, { program }) => {
      const range = slider(editor).locator('input[type=range]');
      await range.scrollIntoViewIfNeeded();
      const box = await range.boundingBox();
      const before = await editor.source();
      await editor.page.mouse.move(box.x + 8, box.y + box.height / 2);
      await editor.page.mouse.down();
      await editor.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 10 });
      const value = await slider(editor).locator('input[type=number]').inputValue();
      assert.ok(Number(value) > 200 && Number(value) < 300, value);
      await waitForPicture(editor, program, ['--set', `p=${value}`]);
      assert.equal(await editor.source(), before);
      await editor.page.mouse.up();
      await editor.waitForSource(new RegExp(`p = ${value} % range`));
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'one undo restores document and slider',
    run: async (editor, { program }) => {
      await editor.click('range', exponent);
      await editor.page.keyboard.press('Control+z');
      await editor.waitForSource(/p = 9 %/);
      await waitUntil(() => slider(editor).locator('input[type=number]').inputValue(), (value) => value === '9');
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'dragging turns the light, a double click turns it back',
    run: async (editor, { program }) => {
      const before = await frame(editor);
      const { x, y, width, height } = await editor.webview.locator('#stage').boundingBox();
      await editor.page.mouse.move(x + width / 2, y + height / 2);
      await editor.page.mouse.down();
      await editor.page.mouse.move(x + width / 2 + 120, y + height / 2, { steps: 8 });
      await editor.page.mouse.up();
      await waitForOther(editor, before);
      await editor.page.mouse.dblclick(x + width / 2, y + height / 2);
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'keys turn the light and reset it',
    run: async (editor, { program }) => {
      const before = await frame(editor);
      await editor.webview.locator('#stage').focus();
      for (let presses = 0; presses < 6; ++presses) await editor.page.keyboard.press('ArrowRight');
      await waitForOther(editor, before);
      await editor.page.keyboard.press('0');
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'a pinned picture stays beside what is typed next',
    run: async (editor, { program }) => {
      const before = await frame(editor);
      await editor.webview.locator('#pin').click();
      await editor.select('9', exponent);
      await editor.page.keyboard.type('200');
      await editor.waitForSource(/p = 200 %/);
      await waitForPicture(editor, program);
      const pinned = editor.webview.locator('#pinned');
      assert.equal(await pinned.evaluate((image) => image.src.split(',')[1]), before.png);
      const [left, right] = [await pinned.boundingBox(), await editor.webview.locator('#picture').boundingBox()];
      assert.ok(left.x + left.width <= right.x + 1, 'side by side');
      await editor.screenshot('pinned-side-by-side');
      await editor.webview.locator('#compare').selectOption('over');
      await editor.screenshot('pinned-overlaid');
      await editor.webview.locator('#pin').click();
      await pinned.waitFor({ state: 'hidden' });
    },
  },
  {
    name: 'what is pinned is there again when its tab was hidden',
    run: async (editor) => {
      const { png } = await frame(editor);
      const pinned = editor.webview.locator('#pinned');
      await editor.webview.locator('#pin').click();
      await pinned.waitFor();
      await editor.page.locator('.tab', { hasText: 'BRDF paper.tex' }).click();
      await editor.command('File: New Untitled Text File');
      await editor.page.locator('.tab.active', { hasText: 'Untitled-1' }).waitFor();
      await editor.page.locator('iframe.webview.ready[src*="extensionId=texbrdf"]').waitFor({ state: 'hidden' });
      await editor.page.locator('.tab', { hasText: 'Untitled-1' }).click({ button: 'middle' });
      await pinned.waitFor();
      assert.equal(await pinned.evaluate((image) => image.src.split(',')[1]), png);
      await frame(editor);
      await editor.webview.locator('#pin').click();
      await pinned.waitFor({ state: 'hidden' });
    },
  },
  {
    name: 'a colour that is picked stands in the document',
    run: async (editor, { program }) => {
      await editor.webview.locator('input[type=color]').evaluate((input) => {
        input.value = '#3399cc';
        for (const type of ['input', 'change']) input.dispatchEvent(new Event(type));
      });
      await editor.waitForSource(/\\rho_d = \\vec\{0\.033, 0\.319, 0\.604\}/);
      await waitForPicture(editor, program);
      await editor.webview.locator('#resetAll').click();
      await editor.waitForSource(/\\rho_d = \\vec\{0\.7, 0\.35, 0\.2\}[^]*p = 60 %/);
      await waitForPicture(editor, program);
    },
  },
];
