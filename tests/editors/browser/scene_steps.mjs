// A scene in the preview in a browser: looked around in, steered, broken and mended.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const key = (x) => ({ velocity: { x, y: 0, z: 0 } });
const text = JSON.stringify({
  shaders: [{ name: 'plain', code: 'float3 shade(FragmentProperties properties) { return 0.5 + 0.5 * properties.world_normal; }' }],
  materials: [{ base_shader: 'plain', name: 'plain' }],
  scene: [
    { name: 'ball', type: 'Primitives/Sphere', material_id: 'plain', dynamic: { keys: { J: key(-2), W: key(2) } } },
    { type: 'Primitives/Cuboid', material_id: 'plain', transform: { position: { x: 0, y: -1, z: 0 } } },
  ],
}, null, 2);

export function sceneSteps({ program, editor, untilTrue, difference, shot, most }) {
  const file = path.join(mkdtempSync(path.join(tmpdir(), 'scene-')), 'ball.scene.json');
  const uri = `file://${file}`;
  let version = 0;
  const change = (changed) => editor.notify('textDocument/didChange', { textDocument: { uri, version: ++version }, contentChanges: [{ text: changed }] });
  const shown = (page) => page.locator('#picture').evaluate((image) => image.src.split(',')[1]);

  async function isRendered(page, view) {
    const size = await page.locator('#picture').evaluate((image) => image.naturalWidth);
    const png = execFileSync(program, ['render', file, '-o', '-', '--size', `${size}`, '--view', view]).toString('base64');
    return await difference(page, png) <= most;
  }

  /** Does something until the picture is another one, then lets R put everything back. */
  async function changesUntilReset(page, what, action) {
    const before = await shown(page);
    await action();
    await untilTrue(`${what} changes nothing`, async () => await difference(page, before) > 20);
    await shot(page, `scene-${what.replace(/\W+/g, '-')}`);
    await page.keyboard.press('r');
    await untilTrue(`after ${what} R does not lead back`, () => isRendered(page, 'normals'));
  }

  return {
    'a scene is drawn, at rest with more and more samples': async (page) => {
      writeFileSync(file, text);
      editor.notify('textDocument/didOpen', { textDocument: { uri, languageId: 'json', version: ++version, text } });
      await page.locator('#name', { hasText: 'ball.scene.json' }).waitFor();
      await page.locator('#status', { hasText: /\d+ of 64 samples · / }).waitFor();
      assert.ok(!await page.locator('#parameters, #plots, #readout').first().isVisible(), 'there are controls of a BRDF');
      await shot(page, 'scene');
    },
    'keys and the list switch the views of a scene': async (page) => {
      await page.locator('#sceneLayer').click();
      await page.keyboard.press('2');
      await untilTrue('the normals are not what texbrdf render makes', () => isRendered(page, 'normals'));
      assert.equal(await page.locator('#sceneView').inputValue(), 'normals');
      await page.locator('#sceneView').selectOption('depth');
      await untilTrue('the depth is not what texbrdf render makes', () => isRendered(page, 'depth'));
      await page.locator('#sceneView').selectOption('normals');
      await page.locator('#sceneLayer').focus();
      await untilTrue('the normals are not there again', () => isRendered(page, 'normals'));
    },
    'drags, wheel and keys look around in a scene, and R leads back': async (page) => {
      const { x, y, width, height } = await page.locator('#sceneLayer').boundingBox();
      await changesUntilReset(page, 'a drag', async () => {
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 3 });
        await page.mouse.up();
      });
      await changesUntilReset(page, 'the wheel', () => page.mouse.wheel(0, 300));
      await changesUntilReset(page, 'an arrow', () => page.keyboard.press('ArrowUp', { delay: 300 }));
    },
    'keys of a scene move its object': async (page) => {
      await page.locator('#sceneKeys', { hasText: 'ball: J W' }).waitFor();
      await changesUntilReset(page, 'J', () => page.keyboard.press('j', { delay: 300 }));
      await changesUntilReset(page, 'W', () => page.keyboard.press('w', { delay: 300 }));
    },
    'a mistake in a scene keeps the last picture, and is told': async (page) => {
      const before = await shown(page);
      change(text.replace('Primitives/Sphere', 'Primitives/Sphare'));
      await page.locator('#stage[data-state="errors"]').waitFor();
      assert.match(await page.locator('#notice').textContent(), /line \d+: there is no object `Primitives\/Sphare`.*last good picture/);
      assert.equal(await difference(page, before), 0);
      await untilTrue('the editor is told of no mistake', () => editor.diagnostics.get(uri)?.length === 1);
      await page.waitForTimeout(500); // Words that come and go come late.
      await shot(page, 'scene-mistake');
      change(text.replace('0.5 + 0.5 * properties', '0.5 + 0.5 * propertees'));
      await page.locator('#notice', { hasText: /error: .*propertees/ }).waitFor();
      change(text);
      await page.locator('#stage[data-state="good"]').waitFor();
      await untilTrue('the mended scene is not drawn', () => isRendered(page, 'normals'));
    },
    'a closed scene makes room for the document': async (page) => {
      editor.notify('textDocument/didClose', { textDocument: { uri } });
      await page.locator('#name', { hasText: 'paper.tex' }).waitFor();
      await page.locator('#readout').waitFor();
    },
  };
}
