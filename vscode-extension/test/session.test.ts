import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Fake, frame, look, nowhere, opened, real, somePlot } from './fake_server';

test('a preview is opened with the size and the look of the page', async () => {
  const fake = new Fake();
  await fake.show('a.tex');
  assert.deepEqual(fake.asked, []);
  await fake.session.pageSays({ type: 'size', side: 300.4 });
  assert.deepEqual(fake.asked[0], ['texbrdf/openPreview', { uri: 'file:///a.tex', view: 'sphere', width: 300, height: 300, ...look }]);
});

test('sizes stay within what the server draws', async () => {
  const fake = await opened();
  for (const side of [1, 5000, 5000]) await fake.session.pageSays({ type: 'size', side });
  assert.deepEqual(fake.toldOf('texbrdf/updatePreview'),
    [{ preview: 1, width: 16, height: 16 }, { preview: 1, width: 2048, height: 2048 }]);
});

test('a frame is acknowledged when it was shown, once', async () => {
  const fake = await opened();
  fake.session.frameArrived(frame(1));
  assert.equal(fake.ofType('picture').length, 1);
  assert.deepEqual(fake.toldOf('texbrdf/frameShown'), []);
  await fake.session.pageSays({ type: 'shown' });
  await fake.session.pageSays({ type: 'shown' });
  assert.deepEqual(fake.toldOf('texbrdf/frameShown'), [{ preview: 1 }]);
});

test('what a hidden page missed is shown when it is back', async () => {
  const fake = await opened();
  fake.session.pageLost();
  fake.session.frameArrived(frame(1, 5));
  assert.equal(fake.ofType('picture').length, 0);
  await fake.session.pageSays({ type: 'ready' });
  assert.equal(fake.ofType('picture')[0]?.picture.version, 5);
});

test('what is pinned is there again when the page is', async () => {
  const fake = await opened();
  const pin = { png: 'BBBB', plot: somePlot };
  await fake.session.pageSays({ type: 'pin', pin });
  assert.deepEqual(fake.posted.at(-1), { type: 'pinned', pin });
  fake.session.pageLost();
  await fake.session.pageSays({ type: 'ready' });
  assert.deepEqual(fake.ofType('pinned').at(-1), { type: 'pinned', pin });
  await fake.session.reopen();
  assert.deepEqual(fake.ofType('pinned').at(-1), { type: 'pinned', pin });
  await fake.session.pageSays({ type: 'pin', pin: null });
  await fake.session.pageSays({ type: 'ready' });
  assert.deepEqual(fake.ofType('pinned').at(-1), { type: 'pinned', pin: null });
});

test('what is pinned is of its document', async () => {
  const fake = await opened();
  const pin = { png: 'BBBB', plot: null };
  await fake.session.pageSays({ type: 'pin', pin });
  await fake.show('b.tex');
  assert.equal(fake.ofType('pinned').at(-1)?.pin, null);
  await fake.show('a.tex');
  assert.deepEqual(fake.ofType('pinned').at(-1)?.pin, pin);
});

test('frames of another preview are not shown', async () => {
  const fake = await opened();
  await fake.show('b.tex');
  fake.session.frameArrived(frame(1));
  assert.equal(fake.ofType('picture').length, 0);
  assert.deepEqual(fake.toldOf('texbrdf/closePreview'), [{ preview: 1 }]);
});

test('a preview that is overtaken while it opens is closed', async () => {
  const fake = new Fake();
  await fake.session.pageSays({ type: 'size', side: 512 });
  await Promise.all([fake.show('a.tex'), fake.show('b.tex')]);
  assert.deepEqual(fake.toldOf('texbrdf/closePreview'), [{ preview: 1 }]);
  fake.session.frameArrived(frame(2));
  await fake.session.pageSays({ type: 'ready' });
  assert.equal(fake.ofType('picture').length, 1);
});

test('a new server gets the preview again', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'look', change: { exposure: 2 } });
  await fake.session.reopen();
  const last = fake.asked.filter(([method]) => method === 'texbrdf/openPreview').at(-1);
  assert.deepEqual(last?.[1], { uri: 'file:///a.tex', view: 'sphere', width: 512, height: 512, ...look, exposure: 2 });
});

test('moving a slider sets a uniform and leaves the document alone', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'set', name: 'm', value: [0.5] });
  assert.deepEqual(fake.toldOf('texbrdf/setParameter'), [{ preview: 1, name: 'm', value: [0.5] }]);
  assert.deepEqual(fake.applied, []);
});

test('letting it go writes the document, then the uniform follows the document again', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'write', name: 'm', value: [0.5] });
  assert.equal(fake.applied.length, 1);
  assert.deepEqual(fake.toldOf('texbrdf/setParameter'), [{ preview: 1, name: 'm', value: null }]);
  assert.deepEqual(fake.reports, []);
});

test('a document that changes meanwhile is asked again, once', async () => {
  const fake = await opened();
  fake.applies = [false, true];
  await fake.session.pageSays({ type: 'write', name: 'm', value: [0.5] });
  assert.equal(fake.applied.length, 2);
  assert.deepEqual(fake.reports, []);
  fake.applies = [false, false];
  await fake.session.pageSays({ type: 'write', name: 'm', value: [0.5] });
  assert.equal(fake.reports.length, 1);
});

test('a value that the document has already is not written, and no problem', async () => {
  const fake = await opened();
  fake.edit = { documentChanges: [] };
  await fake.session.pageSays({ type: 'write', name: 'm', value: [0.25] });
  assert.deepEqual(fake.applied, []);
  assert.deepEqual(fake.reports, []);
  assert.deepEqual(fake.toldOf('texbrdf/setParameter'), [{ preview: 1, name: 'm', value: null }]);
});

test('a good frame that is newer than the errors ends them, an older one does not', async () => {
  const fake = await opened();
  fake.session.stateArrived({ preview: 1, uri: 'file:///a.tex', version: 5, state: 'errors', message: 'no' });
  fake.session.frameArrived(frame(1, 4));
  assert.equal(fake.ofType('state').at(-1)?.state, 'errors');
  fake.session.frameArrived({ ...frame(1, 6), current: false });
  assert.equal(fake.ofType('state').at(-1)?.state, 'errors');
  fake.session.frameArrived(frame(1, 6));
  assert.equal(fake.ofType('state').at(-1)?.state, 'good');
});

test('an edit of the text moves the sliders', async () => {
  const fake = await opened();
  fake.parameters = [real('m', 0.75)];
  fake.session.documentChanged('file:///other.tex', 9);
  fake.session.documentChanged('file:///a.tex', 2);
  assert.deepEqual(fake.posted.at(-1), { type: 'version', version: 2 });
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(fake.ofType('parameters').at(-1)?.parameters, [real('m', 0.75)]);
});

test('an edit of another file of the project moves the sliders', async () => {
  const fake = await opened({ parameters: [real('m', 0.25, 'file:///terms.tex')] });
  fake.parameters = [real('m', 0.75, 'file:///terms.tex')];
  fake.session.stateArrived({ preview: 2, uri: 'file:///b.tex', version: 1, state: 'good', message: '' });
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(fake.ofType('parameters').at(-1)?.parameters[0]?.value, [0.25]);
  fake.session.stateArrived({ preview: 1, uri: 'file:///a.tex', version: 1, state: 'good', message: '' });
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(fake.ofType('parameters').at(-1)?.parameters, fake.parameters);
});

test('a parameter is shown and written in the file that it stands in', async () => {
  const fake = await opened({ parameters: [real('m', 0.25, 'file:///terms.tex')] });
  await fake.session.pageSays({ type: 'reveal', name: 'm' });
  await fake.session.pageSays({ type: 'reveal', name: 'gone' });
  assert.deepEqual(fake.revealed, [{ uri: 'file:///terms.tex', range: nowhere }]);
  fake.edit = { documentChanges: [{ textDocument: { uri: 'file:///terms.tex', version: null }, edits: [{ range: nowhere, newText: '0.5' }] }] };
  await fake.session.pageSays({ type: 'write', name: 'm', value: [0.5] });
  assert.deepEqual(fake.applied, [[{ uri: 'file:///terms.tex', version: null, range: nowhere, newText: '0.5' }]]);
});

test('errors leave the sliders where they are', async () => {
  const fake = await opened();
  fake.session.stateArrived({ preview: 1, uri: 'file:///a.tex', version: 2, state: 'errors', message: 'no' });
  fake.parameters = [];
  fake.session.documentChanged('file:///a.tex', 2);
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(fake.ofType('parameters').at(-1)?.parameters, [real('m', 0.25)]);
  fake.session.stateArrived({ preview: 1, uri: 'file:///a.tex', version: 2, state: 'good', message: '' });
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(fake.ofType('parameters').at(-1)?.parameters, []);
});

test('reset brings back the values that were seen first, all in one step', async () => {
  const fake = await opened({ parameters: [real('m', 0.25), real('k', 0.5)] });
  fake.parameters = [real('m', 0.75), real('k', 1)];
  fake.session.documentChanged('file:///a.tex', 2);
  await new Promise((resolve) => setTimeout(resolve, 100));
  await fake.session.pageSays({ type: 'reset', names: ['m', 'k', 'unheard'] });
  const written = fake.applied.map((changes) => changes.map(({ newText }) => JSON.parse(newText) as { value: number[] }));
  assert.deepEqual(written.map((step) => step.map(({ value }) => value)), [[[0.25], [0.5]]]);
});

test('of a document that was closed nothing is drawn, until it is shown again', async () => {
  const fake = await opened();
  fake.session.documentClosed('file:///other.tex');
  assert.equal(fake.session.uri, 'file:///a.tex');
  fake.session.documentClosed('file:///a.tex');
  assert.equal(fake.session.uri, undefined);
  assert.deepEqual(fake.toldOf('texbrdf/closePreview'), [{ preview: 1 }]);
  await fake.session.reopen();
  assert.equal(fake.asked.filter(([method]) => method === 'texbrdf/openPreview').length, 1);
});

test('another root is drawn, and its parameters are asked for', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'root', root: 'g' });
  assert.deepEqual(fake.toldOf('texbrdf/updatePreview'), [{ preview: 1, root: 'g' }]);
  for (const method of ['texbrdf/parameters', 'texbrdf/definitions'] as const) {
    assert.deepEqual(fake.askedOf(method).at(-1), { uri: 'file:///a.tex', root: 'g' });
  }
  assert.equal(fake.ofType('document').at(-1)?.root, 'g');
});

test('what changes while a preview is opened is told when it is there', async () => {
  const fake = await opened();
  const opening = fake.show('b.tex');
  const said = [
    fake.session.pageSays({ type: 'size', side: 256 }),
    fake.session.pageSays({ type: 'look', change: { exposure: 3 } }),
    fake.session.pageSays({ type: 'root', root: 'g' }),
  ];
  await Promise.all([opening, ...said]);
  assert.deepEqual(fake.toldOf('texbrdf/updatePreview'), [{ preview: 2, width: 256, height: 256, ...look, exposure: 3, root: 'g' }]);
});

test('documents of one name are told apart', async () => {
  const fake = await opened();
  await fake.show('other/a.tex');
  assert.deepEqual(new Set(fake.ofType('document').map(({ uri }) => uri)), new Set(['file:///a.tex', 'file:///other/a.tex']));
});

test('a parameter that is moved while an earlier value is written keeps its place', async () => {
  const fake = await opened();
  const written = fake.session.pageSays({ type: 'write', name: 'm', value: [0.5] });
  await fake.session.pageSays({ type: 'set', name: 'm', value: [0.75] });
  await written;
  assert.deepEqual(fake.toldOf('texbrdf/setParameter'), [{ preview: 1, name: 'm', value: [0.75] }]);
});
