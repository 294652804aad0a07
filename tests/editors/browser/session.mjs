// session.mjs PROGRAM OUT: the preview in a browser, as somebody uses it with an editor that has no webviews. Screenshots are left in OUT.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { Editor } from './editor.mjs';

const { chromium } = createRequire(path.resolve('package.json'))('playwright-core');

const [program, out] = process.argv.slice(2).map((argument) => path.resolve(argument));
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const notRun = 77;
const patience = Number(process.env.PATIENCE ?? 30) * 1000; // milliseconds; a busy machine
const most = 2; // of 255, between a frame and `texbrdf render`

const source = [
  '\\begin{equation}', '  p = 60 % range [1, 500]', '\\end{equation}', '\\begin{equation}',
  '  f = \\frac{\\vec{0.7, 0.35, 0.2}}{\\pi} + 0.3 * \\vec{1, 1, 1} * \\frac{p + 8}{8 * \\pi} * \\cos{\\theta_h}^p', '\\end{equation}', '',
].join('\n');

if (!existsSync(executablePath)) {
  console.log('left out: chromium is not installed; ./dev test installs it');
  process.exit(process.env.CI ? 1 : notRun);
}
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const editor = new Editor(program, 'file:///papers/paper.tex', source);
const browser = await chromium.launch({ executablePath, headless: true, args: ['--no-sandbox', '--disable-gpu'] });
const faults = [];

async function openedTab(url) {
  const page = await browser.newPage({ viewport: { width: 900, height: 800 } });
  page.setDefaultTimeout(patience);
  page.on('console', (message) => { if (message.type() === 'error') faults.push(message.text()); });
  page.on('pageerror', (error) => { faults.push(String(error)); });
  page.on('request', (request) => { if (!/^(data:|http:\/\/127\.0\.0\.1:)/.test(request.url())) faults.push(`asks ${request.url()}`); });
  await page.goto(url);
  return page;
}

async function untilTrue(what, holds) {
  for (const end = Date.now() + patience; !await holds(); await new Promise((resolve) => { setTimeout(resolve, 50); })) {
    assert.ok(Date.now() < end, what);
  }
}

/** The largest difference of a channel between the picture that is shown and a PNG; decoded by the page. */
async function difference(page, png) {
  return page.evaluate(async (other) => {
    const pixels = async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.naturalWidth, height: image.naturalHeight });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const [a, b] = [await pixels(document.getElementById('picture').src), await pixels(`data:image/png;base64,${other}`)];
    return a.length === b.length ? a.reduce((worst, value, index) => Math.max(worst, Math.abs(value - b[index])), 0) : Infinity;
  }, png);
}

/** Waits for the picture that `texbrdf render` makes of the editor's text. */
async function picture(page, options = []) {
  await page.locator('#stage[data-fresh="current"] #picture:not([hidden])').waitFor();
  const rendered = async () => {
    const size = await page.locator('#picture').evaluate((image) => image.naturalWidth);
    return execFileSync(program, ['render', '-', '-o', '-', '--size', `${size}`, ...options], { input: editor.text }).toString('base64');
  };
  await untilTrue('the picture is not what texbrdf render makes', async () => await difference(page, await rendered()) <= most);
}

const shot = (page, name) => page.screenshot({ path: path.join(out, `${name}.png`) });
const slider = (page) => page.locator('.row', { hasText: 'p' }).locator('input[type=range]');

const steps = {
  'before a document is open the page asks for one': async (page) => {
    await page.locator('#notice', { hasText: 'Open a LaTeX document' }).waitFor();
    editor.open();
  },
  'the document is drawn': async (page) => {
    await page.locator('#name', { hasText: 'paper.tex' }).waitFor();
    await picture(page);
  },
  'what is typed is drawn': async (page) => {
    editor.replaceAll(editor.text.replace('0.3 *', '0.1 *'));
    await picture(page);
  },
  'a slider draws while it moves, and writes the number when it is let go': async (page) => {
    const before = editor.text;
    const box = await slider(page).boundingBox();
    await page.mouse.move(box.x + 8, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 10 });
    const value = await page.locator('.row input[type=number]').inputValue();
    assert.ok(Number(value) > 200 && Number(value) < 300, value);
    await picture(page, ['--set', `p=${value}`]);
    assert.equal(editor.text, before);
    await page.mouse.up();
    await untilTrue('the number is not in the document', () => editor.text.includes(`p = ${value} % range`));
    await picture(page);
  },
  'keys turn the light and reset it': async (page) => {
    const before = await page.locator('#picture').getAttribute('src');
    await page.locator('#stage').focus();
    for (let presses = 0; presses < 6; ++presses) await page.keyboard.press('ArrowRight');
    await untilTrue('the light did not turn', async () => await difference(page, before.split(',')[1]) > 20);
    await page.keyboard.press('0');
    await picture(page);
  },
  'a name leads to its place in the editor': async (page) => {
    await page.locator('.row button.link').click();
    await untilTrue('the editor was not led', () => editor.shown.length > 0);
    assert.equal(editor.shown[0].selection.start.line, 1);
  },
  'a second tab shows the same': async () => {
    const other = await openedTab(await editor.url);
    await picture(other);
    await other.close();
  },
  'an error keeps the last picture, paler, and says why': async (page) => {
    const before = editor.text;
    editor.replaceAll(before.replace('^p', '^q'));
    await page.locator('#stage[data-state="errors"]').waitFor();
    assert.match(await page.locator('#notice').textContent(), /last good picture/);
    await shot(page, 'error');
    editor.replaceAll(before);
    await page.locator('#stage[data-state="good"]').waitFor();
    await picture(page);
  },
  'the picture can be saved': async (page) => {
    const download = page.waitForEvent('download');
    await page.locator('#saveImage').click();
    assert.equal((await download).suggestedFilename(), 'paper.png');
  },
  'a closed document is told of': async (page) => {
    editor.notify('textDocument/didClose', { textDocument: { uri: editor.uri } });
    await page.locator('#notice', { hasText: 'was closed' }).waitFor();
  },
};

let failed = 0;
try {
  const page = await openedTab(await editor.start());
  for (const [index, [name, run]] of Object.entries(steps).entries()) {
    await run(page).then(() => { console.log(`ok      ${name}`); }, (error) => {
      failed += 1;
      console.log(`FAILED  ${name}: ${error.message}`);
    });
    await shot(page, `${index + 1}-${name.replace(/\W+/g, '-')}`);
  }
  assert.deepEqual(faults, [], 'the page reported errors');
  assert.equal(await editor.end(), 0);
  await page.locator('#notice', { hasText: 'texbrdf is gone' }).waitFor();
} catch (error) {
  failed += 1;
  console.log(`FAILED  ${error.message}`);
} finally {
  editor.process.kill();
  await browser.close();
}
process.exit(failed === 0 ? 0 : 1);
