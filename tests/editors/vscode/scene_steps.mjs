// A scene: its squiggles, its picture in the preview, and looking around in it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { waitUntil } from './editor.mjs';
import { difference, frame, most, waitForOther } from './pictures.mjs';

const file = 'ball.scene.json';
/** Waits for the picture that texbrdf makes of the file. */
async function waitForScene(editor, program, view) {
  await waitUntil(async () => {
    await editor.source();
    const { png, width } = await frame(editor);
    const made = execFileSync(program, ['render', path.join(editor.workspace, file), '-o', '-', '--size', `${width}`, '--view', view]);
    return difference(editor, png, made.toString('base64'));
  }, (apart) => apart <= most, (apart) => `the picture is ${apart}/255 away from texbrdf render`);
}

export const sceneSteps = [
  {
    name: 'a scene has a squiggle under its mistake',
    run: async (editor) => {
      await editor.open(file);
      await editor.waitForSquiggles(1);
      const squiggle = await editor.page.locator('.editor-instance .squiggly-error').boundingBox();
      const word = await editor.wordBox('"point"');
      assert.ok(Math.abs(squiggle.x - word.x) < 1.5 && Math.abs(squiggle.width - word.width) < 1.5, JSON.stringify({ squiggle, word }));
      await editor.hover('point', 'paint');
    },
  },
  {
    name: 'a scene is shown as soon as it has no mistake',
    run: async (editor, { program }) => {
      await editor.command('texbrdf: Open preview to the side');
      await editor.webview.locator('#stage[data-state="errors"]').waitFor();
      await editor.select('point');
      await editor.page.keyboard.type('paint');
      await editor.waitForSquiggles(0);
      await editor.webview.locator('#status', { hasText: /\d samples? · / }).waitFor();
      await editor.webview.locator('#sceneKeys', { hasText: 'box: J' }).waitFor();
      await editor.webview.locator('#sceneView').selectOption('normals');
      await waitForScene(editor, program, 'normals');
    },
  },
  {
    name: 'looking around in a scene, and back',
    run: async (editor, { program }) => {
      const layer = editor.webview.locator('#sceneLayer');
      const { x, y, width, height } = await layer.boundingBox();
      const doing = [
        async () => {
          await editor.page.mouse.move(x + width / 2, y + height / 2);
          await editor.page.mouse.down();
          await editor.page.mouse.move(x + width / 2 + 60, y + height / 2 + 20, { steps: 3 });
          await editor.page.mouse.up();
        },
        () => editor.page.keyboard.press('j', { delay: 300 }),
        () => editor.page.keyboard.press('ArrowDown', { delay: 300 }),
      ];
      for (const action of doing) {
        const before = await frame(editor);
        await action();
        await waitForOther(editor, before);
        await editor.screenshot(`scene-${doing.indexOf(action) + 1}`);
        await editor.page.keyboard.press('r');
        await waitForScene(editor, program, 'normals');
      }
    },
  },
  {
    name: 'an edit of a scene moves what is shown; then the document is shown again',
    run: async (editor, { program }) => {
      const before = await frame(editor);
      await editor.click('Cuboid');
      await editor.select('Cuboid');
      await editor.page.keyboard.type('Sphere');
      await waitForOther(editor, before);
      await waitForScene(editor, program, 'normals');
      await editor.open('paper.tex');
      await editor.webview.locator('#name', { hasText: 'paper.tex' }).waitFor();
    },
  },
];
