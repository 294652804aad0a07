// Values beside the picture: readout, plots, bad pixels.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { waitUntil } from './editor.mjs';
import { frame, waitForPicture } from './pictures.mjs';

const light = { theta: 33.8941, phi: 145.826 };
const exponent = { in: '% range' };

/** The BRDF's value at the pole of the sphere, for the light that a preview begins with. */
function valueAtPole(editor, program, text) {
  const [theta, phi] = [light.theta, light.phi].map((degrees) => degrees * Math.PI / 180);
  const directions = path.join(editor.out, 'pole.csv');
  writeFileSync(directions, `Lx,Ly,Lz,Vx,Vy,Vz\n${Math.sin(theta) * Math.cos(phi)},${Math.sin(theta) * Math.sin(phi)},${Math.cos(theta)},0,0,1\n`);
  const answer = execFileSync(program, ['eval', '-', '--directions', directions], { input: text, encoding: 'utf8' });
  return answer.trim().split('\n')[1].split(',').slice(6).map(Number);
}

async function pointAtPole(editor) {
  const { x, y, width, height } = await editor.webview.locator('#stage').boundingBox();
  await editor.page.mouse.move(x + width / 2 + 5, y + height / 2);
  await editor.page.mouse.move(x + width / 2, y + height / 2, { steps: 3 });
}

const curve = (editor, which = ':not(.pinned)') => editor.webview.locator(`#cartesian .curve.red${which}`);

export const valueSteps = [
  {
    name: 'the point below the pointer is read out',
    run: async (editor, { program }) => {
      await pointAtPole(editor);
      await editor.webview.locator('#definition').selectOption({ label: 'k_s' });
      await pointAtPole(editor);
      const read = (id) => editor.webview.locator(id).textContent();
      assert.match(await waitUntil(() => read('#readoutDefinition'), (text) => text !== ''), /^= 0\.30*$/);
      await waitUntil(() => read('#readoutDirections'), (text) => /^light θ 3[34]\.\d° φ 14\d\.\d° · view θ 0\.[0-2]° φ /.test(text));
      const shown = /^f = \(([\d.]+), ([\d.]+), ([\d.]+)\)$/.exec(await read('#readoutValue')).slice(1).map(Number);
      const exact = valueAtPole(editor, program, await editor.source());
      exact.forEach((value, channel) => assert.ok(Math.abs(shown[channel] / value - 1) < 0.01, `${shown} is not ${exact}`));
    },
  },
  {
    name: 'keys move the point that is read out',
    run: async (editor) => {
      await editor.page.mouse.move(700, 893);
      await editor.webview.locator('#readoutDirections', { hasText: 'Point at the sphere' }).waitFor();
      await editor.webview.locator('#stage').focus();
      await editor.page.keyboard.press('d');
      await editor.webview.locator('#readoutValue', { hasText: 'f = (' }).waitFor();
      await editor.webview.locator('#probeMark[visibility="visible"]').waitFor();
    },
  },
  {
    name: 'the plots follow an edit and a slider, beside those of a pinned state',
    run: async (editor, { program }) => {
      const before = await waitUntil(() => curve(editor).getAttribute('d'), (d) => d.length > 1000);
      await editor.webview.locator('#cursor').fill('34');
      const value = await waitUntil(() => editor.webview.locator('#cursorValue').textContent(), (text) => /^34\.0°: R [\d.]+ · G [\d.]+ · B [\d.]+$/.test(text));
      await editor.webview.locator('#pin').click();
      await editor.select('60', exponent);
      await editor.page.keyboard.type('20');
      await editor.waitForSource(/p = 20 %/);
      await waitUntil(() => curve(editor).getAttribute('d'), (d) => d !== before);
      await waitForPicture(editor, program);
      await editor.webview.locator('#cartesian .curve.pinned').nth(2).waitFor({ state: 'attached' });
      await waitUntil(() => editor.webview.locator('#polar .curve').count(), (count) => count === 6);
      await waitUntil(() => editor.webview.locator('#pinnedValue').textContent(), (text) => text === `pinned: ${value}`);
      await waitUntil(() => editor.webview.locator('#cursorValue').textContent(), (text) => text !== value);
      await editor.screenshot('plots-with-a-pinned-state');
      await editor.webview.locator('#pin').click();
      await waitUntil(() => editor.webview.locator('#cartesian .curve.pinned').count(), (count) => count === 0);
      const edited = await curve(editor).getAttribute('d');
      await editor.webview.locator('input[type=range][aria-label="p"]').focus();
      await editor.page.keyboard.down('PageUp');
      await waitUntil(() => curve(editor).getAttribute('d'), (d) => d !== edited);
      assert.match(await editor.source(), /p = 20 %/);
      await editor.page.keyboard.up('PageUp');
      await editor.webview.locator('#resetAll').click();
      await editor.waitForSource(/p = 60 %/);
      await waitUntil(() => curve(editor).getAttribute('d'), (d) => d === before);
    },
  },
  {
    name: 'the plots follow the light, and the scale that is chosen',
    run: async (editor) => {
      const [curveBefore, lampBefore] = [await curve(editor).getAttribute('d'), await editor.webview.locator('#polar .lamp').getAttribute('cx')];
      await editor.webview.locator('#stage').focus();
      for (let presses = 0; presses < 4; ++presses) await editor.page.keyboard.press('ArrowUp');
      await waitUntil(() => editor.webview.locator('#polar .lamp').getAttribute('cx'), (cx) => cx !== lampBefore);
      await editor.page.keyboard.press('0');
      await waitUntil(() => curve(editor).getAttribute('d'), (d) => d === curveBefore);
      await editor.webview.locator('#plotScale').selectOption('log');
      await waitUntil(() => curve(editor).getAttribute('d'), (d) => d !== curveBefore);
      await editor.screenshot('plots-on-a-logarithmic-scale');
      await editor.webview.locator('#plotScale').selectOption('linear');
    },
  },
  {
    name: 'from a bad pixel to the definition that makes it bad',
    run: async (editor, { program }) => {
      await editor.select('0.3', { in: 'k_s' });
      await editor.page.keyboard.type('\\sqrt{\\cos{\\theta_i} - 0.5}');
      await editor.waitForSource(/k_s = \\sqrt\{\\cos\{\\theta_i\} - 0\.5\}/);
      await waitForPicture(editor, program);
      assert.match((await frame(editor)).status, /bad pixels: \d+ NaN/);
      await editor.click('range', exponent);
      await editor.webview.locator('#showBad').click();
      await editor.waitForCaret('Ln 10');
      await editor.webview.locator('#badMark[visibility="visible"]').waitFor();
      await editor.screenshot('the-first-bad-pixel');
      await editor.select('\\sqrt{\\cos{\\theta_i} - 0.5}', { in: 'k_s' });
      await editor.page.keyboard.type('0.3');
      await waitForPicture(editor, program);
      await editor.webview.locator('#showBad').waitFor({ state: 'hidden' });
      await editor.webview.locator('#badMark[visibility="hidden"]').waitFor({ state: 'attached' });
    },
  },
];
