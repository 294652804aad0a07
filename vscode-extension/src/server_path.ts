// Where the server is: what the setting says, else the one that came with the extension, else PATH.
import { homedir } from 'node:os';
import * as path from 'node:path';

export interface Surroundings {
  setting: string;
  extensionFolder: string;
  workspaceFolder: string | undefined;
  /** Whether programs of the workspace may be run. */
  isTrusted: boolean;
  platform: NodeJS.Platform;
  isFile: (file: string) => boolean;
}

export interface ServerPath {
  program: string;
  from: 'setting' | 'extension' | 'PATH';
}

export function serverPath(around: Surroundings): ServerPath {
  const setting = around.setting.trim();
  if (setting !== '') return { program: expand(setting, around), from: 'setting' };
  const bundled = path.join(around.extensionFolder, 'bin', executable('texbrdf', around.platform));
  if (around.isFile(bundled)) return { program: bundled, from: 'extension' };
  return { program: executable('texbrdf', around.platform), from: 'PATH' };
}

function expand(setting: string, around: Surroundings): string {
  const inHome = /^~(?=\/|$)/.test(setting) ? homedir() + setting.slice(1) : setting;
  return around.workspaceFolder === undefined || !around.isTrusted ? inHome : inHome.replaceAll('${workspaceFolder}', around.workspaceFolder);
}

function executable(name: string, platform: NodeJS.Platform): string {
  return platform === 'win32' ? `${name}.exe` : name;
}
