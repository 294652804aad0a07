// The settings of package.json, against what the server knows (server/lsp/settings.def).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
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
  for (const name of ['diagnostics.hints', 'hover.picture']) assert.deepEqual(settings[`texbrdf.${name}`]?.enum, choices.get(name));
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
