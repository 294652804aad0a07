// A document with several BRDFs: which one is drawn is asked, and can be changed.
import { waitUntil } from './editor.mjs';
import { waitForPicture } from './pictures.mjs';

const rows = (editor) => editor.page.locator('.quick-input-list .monaco-list-row');
const button = (editor) => editor.page.locator('.editor-actions a[aria-label^="Open preview to the side"]');

export const choiceSteps = [
  {
    name: 'of several BRDFs the one that is picked is drawn',
    run: async (editor, { program }) => {
      await editor.command('View: Close All Editors');
      await editor.open('two.tex');
      await button(editor).click();
      await waitUntil(() => rows(editor).count(), (count) => count === 2, (count) => `${count} choices`);
      await editor.screenshot('which-definition');
      await rows(editor).filter({ hasText: 'f_{gloss}' }).click();
      await waitForPicture(editor, program, ['--root', 'f_{gloss}']);
    },
  },
  {
    name: 'the menu of the pane draws another one',
    run: async (editor, { program }) => {
      const menu = editor.webview.locator('#root');
      await waitUntil(() => menu.inputValue(), (value) => value === 'f_{gloss}');
      await menu.selectOption('f_{clay}');
      await waitForPicture(editor, program, ['--root', 'f_{clay}']);
    },
  },
  {
    name: 'a choice that is not made changes nothing',
    run: async (editor, { program }) => {
      await editor.click('pi', { in: 'clay' });
      await button(editor).click();
      await rows(editor).filter({ hasText: 'f_{gloss}' }).waitFor();
      await editor.page.keyboard.press('Escape');
      await rows(editor).first().waitFor({ state: 'hidden' });
      await waitForPicture(editor, program, ['--root', 'f_{clay}']);
    },
  },
];
