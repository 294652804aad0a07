// The unit tests of the extension.
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';

function run(...command) {
  if (spawnSync(process.execPath, command, { stdio: 'inherit' }).status !== 0) process.exit(1);
}

run('esbuild.mjs', '--tests');
// Each by its name: what `node --test` makes of a folder differs between versions.
run('--test', '--test-reporter=spec', ...readdirSync('dist/test').map((name) => `dist/test/${name}`));
