// session.mjs PROGRAM OUT: the preview in a browser, as somebody uses it with an editor that has no webviews. Screenshots are left in OUT.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { Editor } from './editor.mjs';
import { sceneSteps } from './scene_steps.mjs';

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
const browser = await chromium.launch({ executablePath, headless: true, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
const faults = [];

async function openedTab(url, prepared = () => {}) {
  const page = await browser.newPage({ viewport: { width: 900, height: 800 } });
  await page.addInitScript(prepared);
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

/** Moves the pointer over the further plot until what is told of it is as it should be. */
async function pointUntil(page, output, text) {
  const box = await page.locator('#furtherSurface').boundingBox();
  for (let y = 0.3; y < 0.9; y += 0.05) {
    for (let x = 0.2; x < 0.8; x += 0.05) {
      await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
      await page.waitForTimeout(30);
      if (text.test(await page.locator(output).textContent())) return;
    }
  }
  assert.fail(`${output} is never ${text}`);
}

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
  'a teapot in a furnace becomes better until all samples are drawn, and turns where it is dragged': async (page) => {
    await page.locator('#shape').selectOption('teapot');
    await picture(page, ['--object', 'teapot']);
    await shot(page, 'teapot');
    await page.locator('#lightSource').selectOption('furnace');
    await page.locator('#samples').fill('12');
    await page.locator('#samples').blur();
    await page.locator('#status', { hasText: '12 of 12 samples' }).waitFor();
    await picture(page, ['--object', 'teapot', '--light', 'furnace', '--samples', '12']);
    await shot(page, 'teapot-furnace');
    await page.locator('#lightSource').selectOption('sky');
    await page.locator('#status', { hasText: '12 of 12 samples' }).waitFor();
    const before = await page.locator('#picture').getAttribute('src');
    await page.locator('#stage').focus();
    for (let presses = 0; presses < 6; ++presses) await page.keyboard.press('ArrowRight');
    await untilTrue('the teapot did not turn', async () => await difference(page, before.split(',')[1]) > 20);
    await page.locator('#status', { hasText: '12 of 12 samples' }).waitFor();
    await picture(page, ['--object', 'teapot', '--light', 'sky', '--samples', '12', '--yaw', '0', '--pitch', '20']);
    await shot(page, 'teapot-sky');
  },
  'a file that may not be read is told of': async (page) => {
    await page.locator('#shape').selectOption('file');
    await page.locator('#shapePath').fill('/etc/cup.obj');
    await page.locator('#shapePath').blur();
    await page.locator('#notice', { hasText: 'in no folder that is open' }).waitFor();
    await page.locator('#shape').selectOption('sphere');
    await page.locator('#lightSource').selectOption('directional');
    await page.locator('#stage[data-state="good"]').waitFor();
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
  'curves beside the plane of incidence follow their angles, and tell values under the pointer': async (page) => {
    for (const [kind, angle] of [['theta-h', 'θ_h'], ['theta-d', 'θ_d'], ['albedo', 'θᵢ']]) {
      await page.locator('#furtherKind').selectOption(kind);
      const curves = page.locator('#furtherCurve .curve');
      await untilTrue(`no curves over ${angle}`, async () => await curves.count() === 3);
      await page.locator('#furtherCurve text', { hasText: angle }).first().waitFor();
      await page.locator('#furtherCurve').hover();
      await page.locator('#furtherValue', { hasText: /^4\d\.\d°: R [\d.]+ · G [\d.]+ · B [\d.]+/ }).waitFor();
      await shot(page, `plot-${kind}`);
    }
    await page.locator('#furtherValue', { hasText: ' ± ' }).waitFor();
    await page.locator('#furtherKind').selectOption('theta-h');
    await page.locator('#furtherCurve text', { hasText: 'θ_h' }).first().waitFor();
    const before = await page.locator('#furtherCurve .curve').first().getAttribute('d');
    await page.locator('#furtherPhi').fill('0');
    await page.locator('#furtherFixed').fill('60');
    await page.locator('#furtherFixed').blur();
    await untilTrue('the curve stays', async () => await page.locator('#furtherCurve .curve').first().getAttribute('d') !== before);
  },
  'a lobe turns with the pointer, a slice tells its cells': async (page) => {
    const drawn = () => page.locator('#furtherSurface').evaluate((canvas) => canvas.toDataURL());
    await page.locator('#furtherKind').selectOption('lobe');
    await page.locator('#furtherSurface').scrollIntoViewIfNeeded();
    await untilTrue('no lobe', async () => (await drawn()).length > 5000);
    await pointUntil(page, '#furtherValue', /^θₒ [\d.]+°, φₒ -?[\d.]+°: R [\d.]+ · G [\d.]+ · B [\d.]+$/);
    assert.equal(await page.locator('#furtherSurface').getAttribute('data-painter'), 'webgl');
    await shot(page, 'plot-lobe');
    const before = await drawn();
    const box = await page.locator('#furtherSurface').boundingBox();
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    await untilTrue('the lobe did not turn', async () => await drawn() !== before);
    await page.locator('#pin').click();
    await page.locator('#plotScale').selectOption('log');
    await pointUntil(page, '#furtherPinned', /^pinned: θₒ/);
    await shot(page, 'plot-lobe-pinned');
    await page.locator('#pin').click();
    await page.locator('#furtherKind').selectOption('slice');
    await page.locator('#furtherSurface').hover();
    await page.locator('#furtherValue', { hasText: /^θ_d [\d.]+°, θ_h [\d.]+°: / }).waitFor();
    await shot(page, 'plot-slice');
    await page.locator('#plotScale').selectOption('linear');
  },
  'without WebGL a lobe is drawn as well': async () => {
    const other = await openedTab(await editor.url, () => {
      const context = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : context.call(this, kind, ...rest); };
    });
    await picture(other);
    await other.locator('#furtherKind').selectOption('lobe');
    await other.locator('#furtherSurface[data-painter="canvas"]').scrollIntoViewIfNeeded();
    await pointUntil(other, '#furtherValue', /^θₒ [\d.]+°, φₒ -?[\d.]+°: R [\d.]+/);
    await shot(other, 'plot-lobe-without-webgl');
    await other.close();
  },
  'the numbers of plots can be saved': async (page) => {
    for (const [button, name, head] of [['#saveCurve', 'paper-theta-o.csv', 'theta_o,red,green,blue'], ['#saveFurther', 'paper-slice.csv', 'theta_d,theta_h,red,green,blue']]) {
      const download = page.waitForEvent('download');
      await page.locator(button).click();
      assert.equal((await download).suggestedFilename(), name);
      assert.equal(readFileSync(await (await download).path(), 'utf8').split('\n')[0], head);
    }
    await page.locator('#furtherKind').selectOption('');
  },
  'the picture can be saved': async (page) => {
    const download = page.waitForEvent('download');
    await page.locator('#saveImage').click();
    assert.equal((await download).suggestedFilename(), 'paper.png');
  },
  ...sceneSteps({ program, editor, untilTrue, difference, shot, most }),
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
