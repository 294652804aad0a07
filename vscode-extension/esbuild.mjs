// Bundles the extension and the page of its preview into dist/; with --tests, its unit tests into dist/test/; with --browser FOLDER,
// the preview for browsers, which `texbrdf lsp --preview-port` serves.
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { build } from 'esbuild';

const common = { bundle: true, target: 'es2022', logLevel: 'warning', legalComments: 'none' };
const node = { ...common, platform: 'node', format: 'cjs' };

async function buildExtension() {
  await build({ ...node, entryPoints: ['src/extension.ts'], outdir: 'dist', external: ['vscode'], minify: true });
  await build({ ...common, entryPoints: ['src/preview/webview/main.ts'], outfile: 'dist/preview.js', format: 'iife', minify: true });
  copyFileSync('../docs/examples/plastic.tex', 'dist/example.tex');
}

async function buildTests() {
  rmSync('dist/test', { recursive: true, force: true });
  const tests = readdirSync('test').filter((name) => name.endsWith('.test.ts'));
  await build({ ...node, entryPoints: tests.map((name) => `test/${name}`), outdir: 'dist/test', sourcemap: 'inline' });
}

/** Of a source without imports. */
async function imported(source) {
  const { outputFiles: [{ text }] } = await build({ ...common, entryPoints: [source], format: 'esm', write: false });
  return import(`data:text/javascript,${encodeURIComponent(text)}`);
}

async function buildForBrowsers(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const write = (name, text) => { writeFileSync(path.join(folder, name), text); };
  await build({ ...common, entryPoints: ['src/preview/browser/main.ts'], outfile: path.join(folder, 'preview.js'), format: 'iife', minify: true });
  write('preview.css', ['src/preview/browser/theme.css', 'media/preview.css'].map((name) => readFileSync(name, 'utf8')).join('\n'));
  const { browserPage } = await imported('src/preview/page.ts');
  write('index.html', browserPage({ scriptUri: 'preview.js', styleUri: 'preview.css' }));
}

async function buildAsAsked([option, folder]) {
  switch (option) {
    case '--tests': return buildTests();
    case '--browser': return buildForBrowsers(path.resolve(folder));
    case undefined: return buildExtension();
    default: throw new Error(`no option ${option}`);
  }
}

await buildAsAsked(process.argv.slice(2));
