import assert from 'node:assert/strict';
import { test } from 'node:test';
import { glfwName } from '../src/preview/webview/key_names';
import { SceneHands } from '../src/preview/webview/scene_input';
import { isSceneFile } from '../src/scene_files';
import { Fake, frame } from './fake_server';

async function openedScene(): Promise<Fake> {
  const fake = new Fake();
  await fake.show('ball.scene.json');
  await fake.session.pageSays({ type: 'ready' });
  await fake.session.pageSays({ type: 'size', side: 512 });
  return fake;
}

const input = { held: ['W'], seconds: 0.02, pressed: [], drag: { right: 0, down: 0 }, wheel: 0 };

test('a scene is opened as one, and asked for nothing that equations have', async () => {
  const fake = await openedScene();
  assert.deepEqual(fake.asked, [['texbrdf/openScene', { uri: 'file:///ball.scene.json', width: 512, height: 512 }]]);
  assert.equal(fake.ofType('document').at(-1)?.isScene, true);
  assert.deepEqual(fake.ofType('scene').at(-1), {
    type: 'scene', view: 'shaded', keys: [], views: [{ name: 'shaded', meaning: 'lit' }, { name: 'normals', meaning: '' }],
  });
});

test('what is done in the page goes to the server, a new size too', async () => {
  const fake = await openedScene();
  await fake.session.pageSays({ type: 'sceneInput', input });
  await fake.session.pageSays({ type: 'sceneView', view: 'normals' });
  await fake.session.pageSays({ type: 'size', side: 300 });
  assert.deepEqual(fake.told, [
    ['texbrdf/sceneInput', { preview: 1, ...input }],
    ['texbrdf/updateScene', { preview: 1, view: 'normals' }],
    ['texbrdf/updateScene', { preview: 1, width: 300, height: 300 }],
  ]);
});

test('frames of a scene are shown and acknowledged; one may bring another view', async () => {
  const fake = await openedScene();
  fake.session.frameArrived({ ...frame(1), view: 'normals', samples: { drawn: 4, all: 64 } });
  assert.deepEqual(fake.ofType('picture')[0]?.picture.samples, { drawn: 4, all: 64 });
  assert.equal(fake.ofType('scene').at(-1)?.view, 'normals');
  await fake.session.pageSays({ type: 'shown' });
  assert.deepEqual(fake.toldOf('texbrdf/frameShown'), [{ preview: 1 }]);
  assert.equal(fake.asked.length, 1, 'no plot and no value is asked for');
});

test('the keys of the scene are told to the page', async () => {
  const fake = await openedScene();
  const keys = [{ object: 'ball', keys: ['J', 'L'] }];
  fake.session.stateArrived({ preview: 1, uri: 'file:///ball.scene.json', version: 1, state: 'errors', message: 'line 1: no', keys });
  assert.deepEqual(fake.ofType('scene').at(-1)?.keys, keys);
  assert.deepEqual(fake.ofType('state').at(-1), { type: 'state', state: 'errors', message: 'line 1: no' });
});

test('after a scene a document has its sphere again', async () => {
  const fake = await openedScene();
  await fake.show('a.tex');
  assert.deepEqual(fake.toldOf('texbrdf/closePreview'), [{ preview: 1 }]);
  assert.equal(fake.askedOf('texbrdf/openPreview').length, 1);
  assert.equal(fake.ofType('document').at(-1)?.isScene, false);
});

test('a view that was chosen is there again after a restart of the server', async () => {
  const fake = await openedScene();
  await fake.session.pageSays({ type: 'sceneView', view: 'normals' });
  await fake.session.reopen();
  assert.deepEqual(fake.askedOf('texbrdf/openScene').at(-1), { uri: 'file:///ball.scene.json', width: 512, height: 512, view: 'normals' });
});

test('scenes and their parts are told by their names', () => {
  for (const name of ['a.scene.json', 'a.model.json', 'a.material.json', 'a.shader.json', 'a.primitive.json']) assert.ok(isSceneFile(`file:///${name}`), name);
  for (const name of ['scene.json', 'a.json', 'a.scene.json.tex', 'ascene.json']) assert.ok(!isSceneFile(`file:///${name}`), name);
});

test('keys are called as GLFW calls them', () => {
  const known: [string, string | undefined][] = [
    ['KeyA', 'A'], ['Digit1', '1'], ['Numpad1', 'KP_1'], ['NumpadAdd', 'KP_ADD'], ['F11', 'F11'], ['ArrowLeft', 'LEFT'],
    ['ShiftRight', 'RIGHT_SHIFT'], ['Space', 'SPACE'], ['Tab', undefined], ['MediaPlay', undefined], ['toString', undefined],
  ];
  for (const [code, name] of known) assert.equal(glfwName(code), name, code);
});

test('what hands do is gathered and sent once', () => {
  const hands = new SceneHands();
  assert.equal(hands.take(1), undefined);
  assert.ok(hands.keyDown('KeyW', false));
  assert.ok(hands.keyDown('KeyW', true));
  assert.ok(!hands.keyDown('Tab', false));
  hands.dragBy(0.1, 0.2);
  hands.dragBy(0.1, 0);
  hands.turnWheel(-200);
  assert.deepEqual(hands.take(0.5), { held: ['W'], seconds: 0.5, pressed: ['W'], drag: { right: 0.2, down: 0.2 }, wheel: 2 });
  assert.deepEqual(hands.take(0.5), { held: ['W'], seconds: 0.5, pressed: [], drag: { right: 0, down: 0 }, wheel: 0 });
  hands.keyUp('KeyW');
  assert.equal(hands.take(0.5), undefined);
});

test('a key that is up again before anything is sent counts', () => {
  const hands = new SceneHands();
  hands.keyDown('Digit2', false);
  hands.keyUp('Digit2');
  assert.deepEqual(hands.take(0.02)?.held, ['2']);
  assert.equal(hands.isHolding, false);
});

test('keys are let go where the keyboard is lost', () => {
  const hands = new SceneHands();
  hands.keyDown('KeyW', false);
  hands.release();
  hands.take(0.1);
  assert.equal(hands.take(0.1), undefined);
});
