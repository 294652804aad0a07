import assert from 'node:assert/strict';
import { homedir } from 'node:os';
import { test } from 'node:test';
import { serverPath } from '../src/server_path';
import type { Surroundings } from '../src/server_path';

const around = (change: Partial<Surroundings>): Surroundings =>
  ({ setting: '', extensionFolder: '/ext', workspaceFolder: '/papers', isTrusted: true, platform: 'linux', isFile: () => false, ...change });

test('the setting comes first', () => {
  assert.deepEqual(serverPath(around({ setting: ' /opt/texbrdf ', isFile: () => true })), { program: '/opt/texbrdf', from: 'setting' });
});

test('home and workspace are expanded in the setting', () => {
  assert.equal(serverPath(around({ setting: '~/bin/texbrdf' })).program, `${homedir()}/bin/texbrdf`);
  assert.equal(serverPath(around({ setting: '~other/texbrdf' })).program, '~other/texbrdf');
  assert.equal(serverPath(around({ setting: '${workspaceFolder}/texbrdf' })).program, '/papers/texbrdf');
});

test('the program of a workspace that is not trusted is not run', () => {
  const setting = '${workspaceFolder}/texbrdf';
  assert.deepEqual(serverPath(around({ setting, isTrusted: false })), { program: setting, from: 'setting' });
});

test('then the program that came with the extension', () => {
  const isFile = (file: string) => file === '/ext/bin/texbrdf';
  assert.deepEqual(serverPath(around({ isFile })), { program: '/ext/bin/texbrdf', from: 'extension' });
});

test('then PATH', () => {
  assert.deepEqual(serverPath(around({})), { program: 'texbrdf', from: 'PATH' });
  assert.equal(serverPath(around({ platform: 'win32' })).program, 'texbrdf.exe');
});
