// What the preview shows, and whether it is what `texbrdf render` makes of the text.
import { execFileSync } from 'node:child_process';
import { waitUntil } from './editor.mjs';

export const most = 2; // of 255, between a frame and `texbrdf render`

/** What the pane shows once the editor's text has been drawn: its PNG and its status line. */
export async function frame(editor, source = 'GPU') {
  const stage = editor.webview.locator('#stage[data-fresh="current"]');
  await stage.waitFor();
  await editor.webview.locator('#status', { hasText: source }).waitFor();
  return editor.webview.locator('#picture').evaluate((image) => ({
    png: image.src.split(',')[1], width: image.naturalWidth, height: image.naturalHeight, status: document.getElementById('status').textContent,
  }));
}

/** The largest difference of a channel between two PNGs, each over black; decoded by the browser. */
export async function difference(editor, one, other) {
  return editor.page.evaluate(async (pictures) => {
    const [a, b] = await Promise.all(pictures.map(async (png) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.naturalWidth, height: image.naturalHeight });
      const context = canvas.getContext('2d');
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    }));
    if (a.length !== b.length) return Infinity;
    return a.reduce((worst, value, index) => Math.max(worst, Math.abs(value - b[index])), 0);
  }, [one, other]);
}

/** What `texbrdf render` makes of the text, in base64. */
export function rendered(program, text, size, options = []) {
  return execFileSync(program, ['render', '-', '-o', '-', '--size', `${size}`, ...options], { input: text }).toString('base64');
}

/** Waits for a frame that is the one that `texbrdf render` makes of the text. */
export async function waitForPicture(editor, program, options) {
  await waitUntil(async () => {
    const { png, width } = await frame(editor);
    return difference(editor, png, rendered(program, await editor.source(), width, options));
  }, (apart) => apart <= most, (apart) => `the picture is ${apart}/255 away from texbrdf render`);
}

/** Waits for a frame that is another one. */
export async function waitForOther(editor, { png }) {
  await waitUntil(async () => difference(editor, png, (await frame(editor)).png), (apart) => apart > 20, (apart) => `the picture is only ${apart}/255 away`);
}
