// session.mjs PROGRAM OUT: what a user does with the extension, in VS Code itself. Screenshots of each step are left in OUT.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { choiceSteps } from './choice_steps.mjs';
import { codeSteps } from './code_steps.mjs';
import { Editor, serverMain } from './editor.mjs';
import { exportSteps } from './export_steps.mjs';
import { neighbourSteps } from './neighbour_steps.mjs';
import { paneSteps } from './pane_steps.mjs';
import { previewSteps } from './preview_steps.mjs';
import { projectSteps } from './project_steps.mjs';
import { sceneSteps } from './scene_steps.mjs';
import { serverSteps } from './server_steps.mjs';
import { textSteps } from './text_steps.mjs';
import { valueSteps } from './values_steps.mjs';
import { windowSteps } from './window_steps.mjs';

const [program, out] = process.argv.slice(2).map((argument) => path.resolve(argument));
const notRun = 77;
// Most build on those before.
const steps = [textSteps, previewSteps, valueSteps, projectSteps, sceneSteps, paneSteps, serverSteps, codeSteps, exportSteps, choiceSteps, neighbourSteps, windowSteps].flat();

if (!existsSync(serverMain) || !existsSync(process.env.CHROMIUM ?? '/usr/bin/chromium')) {
  console.log('left out: VS Code or chromium is not installed; ./dev test installs them');
  process.exit(process.env.CI ? 1 : notRun);
}

/** Ours, and the one that stands for another. */
async function packaged() {
  const [ours, neighbour] = ['texbrdf', 'neighbour'].map((name) => path.join(out, `${name}.vsix`));
  execFileSync(process.execPath, ['esbuild.mjs']);
  execFileSync(process.execPath, ['package.mjs', ours, program], { stdio: ['ignore', 'ignore', 'inherit'] });
  const { createVSIX } = createRequire(path.resolve('package.json'))('@vscode/vsce');
  await createVSIX({ cwd: path.join(import.meta.dirname, 'neighbour'), packagePath: neighbour, dependencies: false, allowMissingRepository: true, skipLicense: true });
  return [ours, neighbour];
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const started = Date.now();
const say = (line) => console.log(`${((Date.now() - started) / 1000).toFixed(1).padStart(5)} s  ${line}`);
const editor = await Editor.start({ extensions: await packaged(), workspace: path.join(import.meta.dirname, 'workspace'), out });
say('VS Code is there');

let failed = 0;
let number = 0;
const only = process.env.STEPS === undefined ? undefined : new RegExp(process.env.STEPS);
try {
  for (const { name, run } of steps) {
    if (only !== undefined && !only.test(name)) continue;
    const shot = `${String(++number).padStart(2, '0')}-${name.replace(/\W+/g, '-')}`;
    try {
      await run(editor, { program, say });
      await editor.screenshot(shot);
      say(`ok      ${name}`);
    } catch (error) {
      failed += 1;
      await editor.screenshot(`${shot}-FAILED`);
      await editor.page.keyboard.press('Escape');
      say(`FAILED  ${name}: ${error.message.split('\n').slice(0, 12).join('\n        ')}`);
    }
  }
  assert.deepEqual([...editor.hosts].filter((host) => host !== '127.0.0.1' && !host.endsWith('.vscode-cdn.net')), [], 'pages asked other hosts');
  assert.deepEqual(editor.violations, [], 'violations of a content security policy');
} catch (error) {
  failed += 1;
  say(`FAILED  ${error.message}`);
} finally {
  if (failed > 0) console.log(readFileSync(path.join(out, 'server.log'), 'utf8').slice(-4000));
  await editor.end();
}
process.exit(failed === 0 ? 0 : 1);
