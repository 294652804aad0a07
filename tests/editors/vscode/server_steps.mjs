// The server beside an open preview: killed, busy, not to be found; and its log.
import assert from 'node:assert/strict';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { waitUntil } from './editor.mjs';
import { waitForPicture } from './pictures.mjs';
import { servers } from './text_steps.mjs';

const status = (editor, label) => editor.page.locator(`.statusbar-item a[aria-label^="texbrdf: ${label}"]`);

async function setExponent(editor, from, to) {
  await editor.select(`${from}`, { in: '% range' });
  await editor.page.keyboard.type(`${to}`);
  await editor.waitForSource(new RegExp(`p = ${to} %`));
}

/** VS Code as it is installed for the tests has no part that writes logs (spdlog): what can be seen of the trace is the setting. */
async function setTrace(editor, value) {
  await editor.command('texbrdf: Set trace');
  await editor.pick(value);
  await waitUntil(() => editor.userSettings(), (text) => text.includes(`"texbrdf.trace.server": "${value}"`));
}

function setServerPath(editor, server) {
  const folder = path.join(editor.workspace, '.vscode');
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, 'settings.json'), JSON.stringify({ 'texbrdf.server.path': server }));
}

/** The next thing that the status bar says of our server other than that it is ready. */
function nextTrouble(editor) {
  return editor.page.evaluate(() => new Promise((resolve) => {
    const observer = new MutationObserver(() => {
      const label = document.querySelector('.statusbar-item a[aria-label^="texbrdf:"]')?.ariaLabel ?? '';
      if (label === '' || label.startsWith('texbrdf: ready')) return;
      observer.disconnect();
      resolve(label);
    });
    setTimeout(() => { resolve('it stays ready'); }, 30000);
    observer.observe(document.querySelector('.part.statusbar'), { subtree: true, childList: true, attributes: true });
  }));
}

export const serverSteps = [
  {
    name: 'a server that is killed while it draws: its preview comes back by itself, with what was typed meanwhile',
    run: async (editor, { program }) => {
      await editor.webview.locator('#exposure').fill('0.5');
      await waitForPicture(editor, program, ['--exposure', '0.5']);
      const [first] = servers(editor);
      process.kill(first, 'SIGSTOP');
      await setExponent(editor, 60, 25);
      await editor.webview.locator('#stage[data-fresh="outdated"]').waitFor();
      process.kill(first, 'SIGKILL');
      await waitForPicture(editor, program, ['--exposure', '0.5']);
      await editor.webview.locator('#resetLook').click();
      await setExponent(editor, 25, 60);
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'a server that cannot be found is told of with the path, and one that can be draws again',
    run: async (editor, { program }) => {
      setServerPath(editor, '/nowhere/texbrdf');
      await status(editor, 'does not run: there is no /nowhere/texbrdf').waitFor();
      await editor.page.locator('.notification-toast', { hasText: 'texbrdf does not run: there is no /nowhere/texbrdf' }).waitFor();
      await editor.screenshot('no-server');
      setServerPath(editor, path.join(editor.workspace, 'paper.tex'));
      await status(editor, `does not run: ${path.join(editor.workspace, 'paper.tex')} is not executable`).waitFor();
      await setExponent(editor, 60, 40);
      rmSync(path.join(editor.workspace, '.vscode'), { recursive: true });
      await status(editor, 'ready').waitFor();
      await waitForPicture(editor, program);
      await setExponent(editor, 40, 60);
      await waitForPicture(editor, program);
      await editor.command('Notifications: Clear All Notifications');
    },
  },
  {
    name: 'the log is shown, and the trace set',
    run: async (editor) => {
      await editor.command('texbrdf: Show log');
      const channel = editor.page.locator('.part.panel .composite.title select');
      await waitUntil(() => channel.evaluate((select) => select.selectedOptions[0]?.textContent), (name) => name === 'texbrdf');
      await setTrace(editor, 'messages');
      await editor.hover('\\rho_d', 'ℝ³', { in: '\\frac' });
      await setTrace(editor, 'off');
      await editor.command('View: Hide Panel');
      await channel.waitFor({ state: 'hidden' });
    },
  },
  {
    name: 'the status bar says when the server is busy',
    run: async (editor) => {
      const equation = (number) => `Equation ${number} of a long document.\n\\begin{equation}\n  a_{${number}} = \\frac{${number}}{\\pi}\n\\end{equation}\n`;
      writeFileSync(path.join(editor.workspace, 'long.tex'), Array.from({ length: 20000 }, (_, number) => equation(number)).join(''));
      const trouble = nextTrouble(editor);
      await editor.open('long.tex');
      assert.match(await trouble, /long\.tex/);
      await status(editor, 'ready').waitFor();
      await editor.command('View: Close Editor');
      await editor.open('paper.tex');
      rmSync(path.join(editor.workspace, 'long.tex'));
    },
  },
];
