// Bundles the extension and the page of its preview into dist/; with --tests, its unit tests into dist/test/.
import { copyFileSync, readdirSync } from 'node:fs';
import { build } from 'esbuild';

const common = { bundle: true, target: 'es2022', logLevel: 'warning', legalComments: 'none' };
const node = { ...common, platform: 'node', format: 'cjs' };

async function buildExtension() {
  await build({ ...node, entryPoints: ['src/extension.ts'], outdir: 'dist', external: ['vscode'], minify: true });
  await build({ ...common, entryPoints: ['src/preview/webview/main.ts'], outfile: 'dist/preview.js', format: 'iife', minify: true });
  copyFileSync('../docs/examples/plastic.tex', 'dist/example.tex');
}

async function buildTests() {
  const tests = readdirSync('test').filter((name) => name.endsWith('.test.ts'));
  await build({ ...node, entryPoints: tests.map((name) => `test/${name}`), outdir: 'dist/test', sourcemap: 'inline' });
}

await (process.argv.includes('--tests') ? buildTests() : buildExtension());
