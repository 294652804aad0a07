// package.mjs OUT.vsix [PROGRAM]: the extension as it is built in dist/, with a server, stripped, for this platform; or without one for all.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { createVSIX } from '@vscode/vsce';

const here = import.meta.dirname;
const [out, program] = process.argv.slice(2);
const stage = mkdtempSync(path.join(tmpdir(), 'texbrdf-vsix-'));
try {
  for (const part of ['dist', 'media', 'walkthrough', 'package.json', 'README.md', '.vscodeignore', '../CHANGELOG.md', '../LICENSE']) {
    cpSync(path.join(here, part), path.join(stage, path.basename(part)), { recursive: true });
  }
  cpSync(path.join(here, '../docs/schemas'), path.join(stage, 'schemas'), { recursive: true });
  if (program !== undefined) {
    mkdirSync(path.join(stage, 'bin'));
    execFileSync('strip', ['-o', path.join(stage, 'bin', 'texbrdf'), program]);
  }
  const target = program === undefined ? {} : { target: `${process.platform}-${process.arch}` };
  await createVSIX({ cwd: stage, packagePath: path.resolve(out), dependencies: false, ...target });
} finally {
  rmSync(stage, { recursive: true });
}
