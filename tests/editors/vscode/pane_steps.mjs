// The pane itself: zoom, images that are taken from it, the screen's pixels, the theme, and what may not run in it.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { waitUntil } from './editor.mjs';
import { difference, frame, most, waitForPicture } from './pictures.mjs';

/** How much of a picture the sphere covers. */
async function covered(editor) {
  const { png } = await frame(editor);
  return editor.page.evaluate(async (bytes) => {
    const image = new Image();
    image.src = `data:image/png;base64,${bytes}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let opaque = 0;
    for (let alpha = 3; alpha < data.length; alpha += 4) opaque += data[alpha] > 127;
    return opaque / (canvas.width * canvas.height);
  }, png);
}

const waitForCovered = (editor, isWanted) => waitUntil(() => covered(editor), isWanted, (part) => `the sphere covers ${part} of the picture`);

async function middleOfStage(editor) {
  const { x, y, width, height } = await editor.webview.locator('#stage').boundingBox();
  return [x + width / 2, y + height / 2];
}

/** The screen's; a pretended one tells nobody that it changed, so the window changes its width too. */
async function setPixelRatio(editor, deviceScaleFactor, narrower) {
  const { width, height } = editor.page.viewportSize();
  editor.devtools ??= await editor.browser.newCDPSession(editor.page);
  await editor.devtools.send('Emulation.setDeviceMetricsOverride', { width: width - narrower, height, deviceScaleFactor, mobile: false });
}

async function waitForPixels(editor, ratio) {
  const side = () => editor.webview.locator('#stage').evaluate((stage) => Math.min(stage.clientWidth, stage.clientHeight));
  await waitUntil(async () => [await side(), (await frame(editor)).width], ([points, pixels]) => pixels === ratio * points,
    ([points, pixels]) => `${points} points, ${pixels} pixels`);
}

/** The least contrast between words of the pane and what is behind them, and where it is. */
async function leastContrast(editor, background) {
  return editor.webview.locator('body').evaluate((body, ground) => {
    const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
    const luminance = (colour) => {
      const [r, g, b] = channels(colour).map((value) => value / 255).map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const behind = (element) => {
      if (element === null) return ground;
      const { backgroundColor } = getComputedStyle(element);
      return (channels(backgroundColor)[3] ?? 1) > 0 ? backgroundColor : behind(element.parentElement);
    };
    const isShown = (element) => element.checkVisibility() && element.getClientRects().length > 0;
    const hasWords = (element) => [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim() !== '');
    return [...body.querySelectorAll('*')].filter((element) => isShown(element) && hasWords(element)).map((element) => {
      const style = getComputedStyle(element);
      const [light, dark] = [luminance(element instanceof SVGElement ? style.fill : style.color), luminance(behind(element))].sort((a, b) => b - a);
      return { ratio: (light + 0.05) / (dark + 0.05), words: element.textContent.trim() };
    }).reduce((least, each) => (each.ratio < least.ratio ? each : least));
  }, background);
}

/** The pane lies on the background of the window, and its words can be read there. */
async function checkTheme(editor, kind) {
  await editor.webview.locator(`body[data-vscode-theme-kind="vscode-${kind}"]`).waitFor();
  const background = () => editor.page.evaluate(() => getComputedStyle(document.querySelector('.monaco-workbench .part.editor > .content')).backgroundColor);
  const { ratio, words } = await waitUntil(async () => leastContrast(editor, await background()), (least) => least.ratio >= 4.5,
    (least) => `contrast ${least.ratio.toFixed(2)} of "${least.words}"`);
  await frame(editor);
  await editor.screenshot(`theme-${kind}`);
  return `${ratio.toFixed(2)} of "${words}"`;
}

/** What a hostile page would try, and the part of the policy that forbids it. */
function attack(body, { picture, style }) {
  const add = (name, attributes) => body.appendChild(Object.assign(document.createElement(name), attributes));
  const refused = [];
  document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => { refused.push(effectiveDirective); });
  const added = [
    add('script', { textContent: 'window.intruded = true' }),
    add('script', { src: picture.replace('png', 'js') }),
    add('img', { src: picture }),
    add('style', { textContent: 'body { display: none }' }),
    add('p', { innerHTML: '<b onclick="window.intruded = true">click</b>' }),
  ];
  added.at(-1).firstChild.click();
  const asked = fetch(picture).then(() => 'answered', () => 'refused');
  const loaded = new Promise((resolve) => { add('link', { rel: 'stylesheet', href: style, onload: () => resolve('loaded'), onerror: () => resolve('refused') }); });
  return Promise.all([asked, loaded]).then(async ([fetched, foreignStyle]) => {
    for (let tries = 0; tries < 1000 && refused.length < 6; ++tries) await new Promise((resolve) => { setTimeout(resolve, 20); });
    for (const element of [...added, body.querySelector(`link[href="${style}"]`)]) element?.remove();
    console.log('the attack is over');
    return { refused: refused.sort(), fetched, foreignStyle, intruded: window.intruded ?? false, shown: getComputedStyle(body).display };
  });
}

export const paneSteps = [
  {
    name: 'the wheel zooms, a double click sets it back',
    run: async (editor, { program }) => {
      await editor.page.mouse.move(...await middleOfStage(editor));
      const before = await covered(editor);
      await editor.page.mouse.wheel(0, -200);
      await waitForCovered(editor, (part) => part > before * 1.2);
      await editor.screenshot('zoomed');
      await editor.page.mouse.wheel(0, 400);
      await waitForCovered(editor, (part) => part < before * 0.8);
      await editor.page.mouse.dblclick(...await middleOfStage(editor));
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'plus and minus zoom, 0 sets it back',
    run: async (editor, { program }) => {
      const before = await covered(editor);
      await editor.webview.locator('#stage').focus();
      for (let presses = 0; presses < 3; ++presses) await editor.page.keyboard.press('+');
      await waitForCovered(editor, (part) => part > before * 1.2);
      for (let presses = 0; presses < 6; ++presses) await editor.page.keyboard.press('-');
      await waitForCovered(editor, (part) => part < before * 0.8);
      await editor.page.keyboard.press('0');
      await waitForPicture(editor, program);
    },
  },
  {
    name: 'the picture can be saved',
    run: async (editor) => {
      const { png } = await frame(editor);
      await editor.webview.locator('#saveImage').click();
      const name = await editor.waitForFileDialog('paper.png');
      const file = path.join(editor.workspace, 'saved.png');
      await name.fill(file);
      await name.press('Enter');
      await waitUntil(() => editor.read('saved.png')?.toString('base64'), (written) => written === png, () => 'the file is not the picture that was shown');
    },
  },
  {
    name: 'the picture can be copied, by a key',
    run: async (editor) => {
      await editor.browser.grantPermissions(['clipboard-read', 'clipboard-write']);
      await editor.page.evaluate(() => navigator.clipboard.writeText('something else'));
      const { png } = await frame(editor);
      await editor.webview.locator('#copyImage').focus();
      await editor.page.keyboard.press('Enter');
      const copied = await waitUntil(() => editor.page.evaluate(async () => {
        const [item] = await navigator.clipboard.read();
        if (!item.types.includes('image/png')) return undefined;
        const bytes = new Uint8Array(await (await item.getType('image/png')).arrayBuffer());
        return btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), ''));
      }), (found) => found !== undefined, () => 'there is no picture in the clipboard');
      const apart = await difference(editor, copied, png);
      assert.ok(apart <= most, `what was copied is ${apart}/255 away`);
    },
  },
  {
    name: 'a screen with twice the pixels gets a picture with twice the pixels',
    run: async (editor, { program }) => {
      await waitForPixels(editor, 1);
      await setPixelRatio(editor, 2, 20);
      await waitForPixels(editor, 2);
      await waitForPicture(editor, program);
      await editor.screenshot('twice-the-pixels');
      await setPixelRatio(editor, 1, 0);
      await waitForPixels(editor, 1);
    },
  },
  {
    name: 'the pane follows the theme',
    run: async (editor, { say }) => {
      const [first, second] = await editor.webview.locator('body[data-vscode-theme-kind="vscode-dark"]').count() > 0 ? ['dark', 'light'] : ['light', 'dark'];
      for (const kind of [first, second]) {
        say(`        ${kind}: least contrast ${await checkTheme(editor, kind)}`);
        await editor.command('Preferences: Toggle between Light/Dark Themes');
      }
    },
  },
  {
    name: 'nothing foreign runs or is loaded in the pane',
    run: async (editor, { program }) => {
      const asked = [];
      const stranger = createServer(({ url }, answer) => {
        asked.push(url);
        answer.writeHead(200, { 'access-control-allow-origin': '*' }).end();
      }).listen(0, '127.0.0.1');
      try {
        await new Promise((resolve) => { stranger.once('listening', resolve); });
        const picture = `http://127.0.0.1:${stranger.address().port}/picture.png`;
        await fetch(picture);
        assert.deepEqual(asked, ['/picture.png'], 'it answers those that may ask');
        writeFileSync(path.join(editor.workspace, 'foreign.css'), 'body { visibility: hidden }');
        const own = await editor.webview.locator('link[rel=stylesheet]').first().getAttribute('href');
        const style = own.replace(/(vscode-cdn\.net|vscode-resource)\/.*/, `$1${path.join(editor.workspace, 'foreign.css')}`);
        assert.notEqual(style, own);
        const over = editor.page.waitForEvent('console', (message) => message.text() === 'the attack is over');
        const outcome = await editor.webview.locator('body').evaluate(attack, { picture, style });
        assert.deepEqual(outcome, {
          refused: ['connect-src', 'img-src', 'script-src-attr', 'script-src-elem', 'script-src-elem', 'style-src-elem'],
          fetched: 'refused', foreignStyle: 'refused', intruded: false, shown: 'flex',
        });
        assert.equal(asked.length, 1);
        await over;
        assert.ok(editor.violations.splice(0).length >= outcome.refused.length, 'the console tells of each');
      } finally {
        stranger.close();
      }
      await waitForPicture(editor, program);
    },
  },
];
