// The unit tests of the extension.
import { spawnSync } from 'node:child_process';

for (const step of [['esbuild.mjs', '--tests'], ['--test', '--test-reporter=spec', 'dist/test/']]) {
  const { status } = spawnSync(process.execPath, step, { stdio: 'inherit' });
  if (status !== 0) process.exit(1);
}
