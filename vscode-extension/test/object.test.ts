import assert from 'node:assert/strict';
import { test } from 'node:test';
import { memoryFrom } from '../src/preview/memory';
import { isPlain, orbited, plainObject, withStandardOrbit } from '../src/preview/object_look';
import { statusText } from '../src/preview/webview/status_line';
import { frame, look, opened } from './fake_server';

const teapot = { ...plainObject, shape: 'teapot', light: 'sky' };

test('the sphere in the directional light is what the pane shows without an object', () => {
  assert.ok(isPlain(plainObject));
  assert.ok(!isPlain({ ...plainObject, light: 'furnace' }));
  assert.ok(!isPlain({ ...plainObject, shape: 'models/cup.obj' }));
});

test('what is dragged turns all around, and tips no further than upright', () => {
  const { yaw, pitch } = orbited({ ...teapot, yaw: 170, pitch: 80 }, 30, 30);
  assert.deepEqual({ yaw, pitch }, { yaw: -160, pitch: 90 });
  assert.equal(orbited({ ...teapot, yaw: -170 }, -30, 0).yaw, 160);
});

test('the teapot is seen from a little above', () => {
  assert.deepEqual([withStandardOrbit(teapot).yaw, withStandardOrbit(teapot).pitch], [-30, 20]);
  assert.equal(withStandardOrbit({ ...teapot, shape: 'a.obj' }).pitch, 0);
});

test('a choice is sent as it is, and again with a preview that is opened anew', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'look', change: { object: teapot } });
  assert.deepEqual(fake.toldOf('texbrdf/updatePreview'), [{ preview: 1, object: teapot }]);
  await fake.session.reopen();
  const asked = fake.asked.filter(([method]) => method === 'texbrdf/openPreview').at(-1)?.[1];
  assert.deepEqual((asked as { object?: unknown }).object, teapot);
});

test('the samples of a picture are shown', async () => {
  const fake = await opened();
  fake.session.frameArrived({ ...frame(1), samples: { drawn: 16, all: 64 } });
  const picture = fake.ofType('picture').at(-1)?.picture;
  assert.ok(picture !== undefined && statusText(picture).includes('16 of 64 samples'));
});

test('what was kept comes back if it is an object', () => {
  const memory = { uri: 'file:///a.tex', look: { ...look, object: teapot } };
  assert.deepEqual(memoryFrom(JSON.parse(JSON.stringify(memory))), memory);
  for (const object of [3, null, {}, { ...teapot, shape: 1 }, { ...teapot, sun: { elevation: 'high' } }]) {
    assert.equal(memoryFrom({ uri: 'file:///a.tex', look: { ...look, object } }), undefined, JSON.stringify(object));
  }
});
