// The window as a whole: loaded again; and its first page.
import { waitUntil } from './editor.mjs';
import { frame, waitForPicture } from './pictures.mjs';

const exponent = { in: '% range' };

/**
 * The page unfolds the step that is clicked, and what stands below moves: a click may miss its button. A second click while
 * the first one's preview is still opening would land on what opens in the page's place, so each is given time.
 */
async function openFromWalkthrough(editor) {
  const step = editor.page.locator('.getting-started-step', { hasText: 'See it' }).first();
  const button = editor.page.locator('.getting-started-step.expanded').getByText('Open the preview');
  const tab = editor.page.locator('.tab', { hasText: 'BRDF Untitled-1' });
  await waitUntil(async () => {
    if (await button.count() === 0) await step.click();
    await button.last().click({ timeout: 3000 }).catch(() => undefined);
    return tab.waitFor({ timeout: 10_000 }).then(() => true, () => false);
  }, (opened) => opened, () => 'no preview was opened');
  await tab.click();
}

export const windowSteps = [
  {
    name: 'a window that is loaded again has its preview again',
    run: async (editor, { program }) => {
      await editor.command('View: Close All Editors');
      await editor.open('paper.tex');
      await editor.click('range', exponent);
      await editor.page.locator('.editor-actions a[aria-label^="Open preview to the side"]').click();
      const kept = editor.webview.locator('body').evaluate(() => new Promise((resolve) => {
        addEventListener('message', ({ data }) => { if (data.type === 'remember' && data.memory.look.gamma === 3) resolve(); });
      }));
      await editor.webview.locator('#gamma').fill('3');
      await kept;
      await waitForPicture(editor, program, ['--gamma', '3']);
      const loaded = editor.page.waitForEvent('load');
      await editor.command('Developer: Reload Window');
      await loaded;
      await editor.webview.locator('#name', { hasText: 'paper.tex' }).waitFor();
      await waitForPicture(editor, program, ['--gamma', '3']);
      await waitUntil(() => editor.webview.locator('#cartesian .curve.red').getAttribute('d'), (d) => d.length > 1000);
    },
  },
  {
    name: 'the example of the walkthrough is drawn by its own buttons',
    run: async (editor) => {
      await editor.command('View: Close All Editors');
      await editor.command('Welcome: Open Walkthrough');
      await editor.pick('From an equation to a sphere');
      await editor.page.locator('.getting-started-step', { hasText: 'Make a mistake' }).first().waitFor();
      await editor.screenshot('walkthrough');
      await editor.page.locator('.getting-started-step').getByText('Open an example').last().click();
      await editor.page.locator('.tab.active[data-resource-name="Untitled-1"]').waitFor();
      await editor.page.locator('.editor-group-container.active .editor-actions a[aria-label^="Open preview to the side"]').waitFor();
      await editor.page.locator('.tab', { hasText: 'Walkthrough' }).click();
      await openFromWalkthrough(editor);
      await editor.webview.locator('#name', { hasText: 'Untitled-1' }).waitFor();
      await frame(editor);
    },
  },
];
