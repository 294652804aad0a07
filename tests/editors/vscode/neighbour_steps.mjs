// Beside another LaTeX extension: both are heard in equations, and the other one alone in prose.
import assert from 'node:assert/strict';

const own = /neighbour/;
const prose = [2, 3]; // lines of beside.tex, from 0
const equations = { from: 5, to: 11 };

async function completions(editor, word, options, typed) {
  await editor.click(word, options);
  await editor.page.keyboard.press('End');
  await editor.page.keyboard.type(typed);
  await editor.page.keyboard.press('Control+Space');
  const labels = editor.page.locator('.suggest-widget.visible .monaco-list-row .label-name');
  await labels.filter({ hasText: 'theneighbour' }).waitFor();
  return labels.allTextContents();
}

async function takeBack(editor, typed) {
  await editor.page.keyboard.press('Escape');
  for (let letter = 0; letter < typed.length; ++letter) await editor.page.keyboard.press('Backspace');
}

export const neighbourSteps = [
  {
    name: 'two extensions mark their own mistakes',
    run: async (editor) => {
      await editor.command('View: Close All Editors');
      await editor.open('beside.tex');
      await editor.waitForSquiggles(1);
      await editor.command('Neighbour: Start');
      await editor.page.locator('.editor-instance .squiggly-warning').waitFor();
      await editor.waitForSquiggles(1);
    },
  },
  {
    name: 'hovers of both are shown in an equation, of the other alone in prose',
    run: async (editor) => {
      const contents = editor.page.locator('.monaco-hover:not(.hidden) .hover-contents');
      await editor.hover('q', 'ℝ', { in: '= 20' });
      await contents.filter({ hasText: 'neighbour: q' }).waitFor();
      await editor.screenshot('hovers-of-two-extensions');
      await editor.hover('prose', 'neighbour: prose');
      assert.deepEqual((await contents.allTextContents()).filter((text) => text.trim() !== 'neighbour: prose'), []);
    },
  },
  {
    name: 'completions of both are listed in an equation, of the other alone in prose',
    run: async (editor) => {
      const typed = ' + \\the';
      const inEquation = await completions(editor, '20', { in: '= 20' }, typed);
      assert.ok(inEquation.some((label) => label.startsWith('\\theta_')), inEquation.join(', '));
      await editor.screenshot('completions-of-two-extensions');
      await takeBack(editor, typed);
      assert.deepEqual(await completions(editor, 'prose', { in: 'More prose' }, typed), ['\\theneighbour']);
      await takeBack(editor, typed);
      await editor.waitForSource(/of equations\.\n[^]*q = 20\n/);
    },
  },
  {
    name: 'each goes to its own definitions',
    run: async (editor) => {
      await editor.click('ref', { in: 'More prose' });
      await editor.page.keyboard.press('F12');
      await editor.waitForCaret('Ln 3, Col 6');
      await editor.click('q', { in: 'frac' });
      await editor.page.keyboard.press('F12');
      await editor.waitForCaret('Ln 7, Col 3');
    },
  },
  {
    name: 'of all that can be asked nothing is answered outside of equations',
    run: async (editor) => {
      await editor.waitForSquiggles(1);
      await editor.command('Neighbour: Report');
      await editor.page.locator('.notification-toast', { hasText: 'neighbour: reported' }).waitFor();
      const { words, decorated, diagnostics } = JSON.parse(editor.read('report.json'));
      const outside = words.filter(({ line }) => prose.includes(line));
      assert.ok(outside.length > 20, `${outside.length} words`);
      for (const { text, hovers, completions: listed, definitions, highlights, actions } of outside) {
        assert.ok(hovers.length === 1 && own.test(hovers[0]), `${text}: ${hovers.join(' | ')}`);
        assert.deepEqual({ text, listed, highlights, actions }, { text, listed: ['\\theneighbour'], highlights: 0, actions: [] });
        assert.ok(definitions.every((line) => line === 2), `${text} leads to ${definitions.join(', ')}`);
      }
      const inside = words.filter(({ text, line }) => text === 'q' && line > equations.from);
      assert.equal(inside.length, 2);
      for (const { hovers, definitions, highlights } of inside) {
        assert.equal(hovers.length, 2);
        assert.deepEqual({ definitions, highlights }, { definitions: [6], highlights: 2 });
      }
      assert.ok(decorated.length > 0 && decorated.every((line) => line >= equations.from && line <= equations.to), `decorated: ${decorated.join(', ')}`);
      assert.deepEqual(diagnostics.map(({ source, line }) => `${source} ${line}`).sort(), ['neighbour 2', 'texbrdf 10']);
    },
  },
];
