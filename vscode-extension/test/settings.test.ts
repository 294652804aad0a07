// The settings of package.json, against what the server knows (server/lsp/settings.def).
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { serverSettings } from '../src/server_settings';

interface Setting { type: string; default: unknown; description?: string; markdownDescription?: string; enum?: string[] }
interface Manifest {
  contributes: { configuration: { properties: Record<string, Setting> }[]; commands: { command: string }[] };
  capabilities: { untrustedWorkspaces: { supported: string; restrictedConfigurations: string[] } };
}

const manifest = JSON.parse(readFileSync('package.json', 'utf8')) as Manifest;
const settings = Object.assign({}, ...manifest.contributes.configuration.map(({ properties }) => properties)) as Record<string, Setting>;
const table = readFileSync('../server/lsp/settings.def', 'utf8');
const written = (pattern: RegExp) => [...table.matchAll(pattern)];

test('there are fewer than 25, each described', () => {
  assert.ok(Object.keys(settings).length < 25);
  for (const [name, { description, markdownDescription }] of Object.entries(settings)) assert.ok(description ?? markdownDescription, name);
});

test('each feature of the server can be switched off', () => {
  const features = written(/^FEATURE\(\w+, "(\w+)"/gm).map(([, key]) => `texbrdf.features.${key}`);
  assert.ok(features.length > 10);
  assert.deepEqual(Object.keys(settings).filter((name) => name.startsWith('texbrdf.features.')).sort(), features.sort());
});

test('choices are the words of the server', () => {
  const choices = new Map(written(/^CHOICE\(\w+, "([\w.]+)", \w+, \w+, "([\w ]+)"/gm).map(([, key, words]) => [key, words?.split(' ')]));
  for (const name of ['diagnostics.hints', 'hover.picture', 'log.level']) assert.deepEqual(settings[`texbrdf.${name}`]?.enum, choices.get(name));
});

/** Settings of the server that hold in settings.json without being listed: with them there would be too many. */
const notListed = [
  // Parts of features that can be switched off as a whole.
  'inlayHint.definitionTypes', 'inlayHint.parameterTypes', 'inlayHint.constantValues', 'codeLens.preview', 'codeLens.uses',
  // Both ways look the same to a user of VS Code.
  'diagnostics.delivery',
];
const keysOfServer = written(/^(FEATURE|FLAG|CHOICE)\(\w+, "([\w.]+)"/gm).map(([, kind, key = '']) => kind === 'FEATURE' ? `features.${key}` : key);
const listed = Object.keys(settings).map((name) => name.replace(/^texbrdf\./, ''));

/** The keys with which a file of ours asks for a part of the configuration, all in the same section. */
function keysReadBy(file: string): string[] {
  const text = readFileSync(file, 'utf8');
  const section = /getConfiguration\('texbrdf\.?([\w.]*)'\)/.exec(text)?.[1];
  if (section === undefined) return [];
  return [...text.matchAll(/\.get(?:<\w+>)?\('([\w.]+)'/g)].map(([, key = '']) => section === '' ? key : `${section}.${key}`);
}

test('each setting of the server is listed or known not to be', () => {
  assert.ok(keysOfServer.length > 20);
  assert.deepEqual(keysOfServer.filter((key) => !listed.includes(key)).sort(), [...notListed].sort());
});

test('each listed setting is read by somebody', () => {
  const sources = readdirSync('src', { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.ts'));
  const ours = sources.flatMap((name) => keysReadBy(`src/${name}`));
  const theLanguageClients = ['trace.server'];
  assert.deepEqual(listed.filter((key) => !keysOfServer.includes(key)).sort(), [...ours, ...theLanguageClients].sort());
});

test('the server is told of each section that it knows', () => {
  const sections = [...new Set(keysOfServer.map((key) => key.replace(/\..*/, '')))];
  const all = Object.fromEntries(sections.map((section) => [section, {}]));
  assert.deepEqual(serverSettings(all), all);
});

test('a workspace that is not trusted cannot name a program', () => {
  assert.equal(manifest.capabilities.untrustedWorkspaces.supported, 'limited');
  assert.deepEqual(manifest.capabilities.untrustedWorkspaces.restrictedConfigurations, ['texbrdf.server.path']);
});

test('the server is told only of what it knows', () => {
  const all = { server: { path: 'x' }, trace: { server: 'off' }, preview: { gamma: 2 }, features: { hover: false }, diagnostics: { hints: 'off' } };
  assert.deepEqual(serverSettings(all), { features: { hover: false }, diagnostics: { hints: 'off' } });
  assert.deepEqual(serverSettings(null), {});
});
