// Readout, plots and bad pixels, against a server that answers when it is told to.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { areNumbers, directionText, isBadBrdf, valueText, valuesText } from '../src/preview/webview/readout_words';
import type { Probed } from '../src/protocol';
import { definition, frame, look, nowhere, opened, somePlot } from './fake_server';

const readout = (value: number): Probed => ({ light: { theta: 1, phi: 2 }, view: { theta: 3, phi: 4 }, value: [value] });
const settled = () => new Promise((resolve) => setImmediate(resolve));

test('one question is in flight; of those that come meanwhile the last is asked', async () => {
  const fake = await opened();
  const answer = fake.holdProbes();
  for (const x of [0.1, 0.2, 0.3]) void fake.session.pageSays({ type: 'probe', point: { x, y: 0.5 } });
  assert.deepEqual(fake.askedOf('texbrdf/probe'), [{ preview: 1, x: 0.1, y: 0.5 }]);
  answer(readout(1));
  await settled();
  assert.deepEqual(fake.askedOf('texbrdf/probe').slice(1), [{ preview: 1, x: 0.3, y: 0.5 }]);
  answer(readout(2));
  await settled();
  assert.deepEqual(fake.ofType('probed').map((message) => message.readout?.value), [[1], [2]]);
  assert.equal(fake.askedOf('texbrdf/probe').length, 2);
});

test('an answer that comes after the pointer left is dropped, and the next question is asked', async () => {
  const fake = await opened();
  const answer = fake.holdProbes();
  await fake.session.pageSays({ type: 'probe', point: { x: 0.1, y: 0.5 } });
  await fake.session.pageSays({ type: 'probe', point: null });
  answer(readout(1));
  await settled();
  assert.deepEqual(fake.ofType('probed'), []);
  await fake.session.pageSays({ type: 'probe', point: { x: 0.4, y: 0.5 } });
  answer(readout(2));
  await settled();
  assert.equal(fake.ofType('probed').length, 1);
});

test('a question that fails is no end of questions', async () => {
  const fake = await opened();
  fake.probed = () => Promise.reject(new Error('too old'));
  await fake.session.pageSays({ type: 'probe', point: { x: 0.1, y: 0.5 } });
  await settled();
  fake.probed = () => Promise.resolve(null);
  await fake.session.pageSays({ type: 'probe', point: { x: 0, y: 0 } });
  await settled();
  assert.deepEqual(fake.ofType('probed').map((message) => message.readout), [null]);
});

test('the readout follows the picture while the pointer rests', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'probe', point: { x: 0.1, y: 0.5 } });
  await settled();
  fake.session.frameArrived(frame(1, 2));
  assert.equal(fake.askedOf('texbrdf/probe').length, 2);
  fake.session.pageLost();
  await fake.session.pageSays({ type: 'ready' });
  fake.session.frameArrived(frame(1, 3));
  assert.equal(fake.askedOf('texbrdf/probe').length, 2);
});

test('a chosen definition is read out as long as the BRDF needs it', async () => {
  const fake = await opened({ definitions: [definition('f'), definition('D')] });
  await fake.session.pageSays({ type: 'definition', name: 'D' });
  await fake.session.pageSays({ type: 'probe', point: { x: 0.5, y: 0.5 } });
  await settled();
  assert.deepEqual(fake.askedOf('texbrdf/probe').at(-1), { preview: 1, x: 0.5, y: 0.5, definition: 'D' });
  assert.equal(fake.ofType('definitions').at(-1)?.chosen, 'D');
  fake.definitions = [definition('f')];
  fake.session.documentChanged('file:///a.tex', 2);
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.equal(fake.ofType('definitions').at(-1)?.chosen, null);
  await fake.session.pageSays({ type: 'probe', point: { x: 0.5, y: 0.5 } });
  await settled();
  assert.deepEqual(fake.askedOf('texbrdf/probe').at(-1), { preview: 1, x: 0.5, y: 0.5 });
});

test('definitions that stay the same are not told again', async () => {
  const fake = await opened({ definitions: [definition('f')] });
  const before = fake.ofType('definitions').length;
  fake.session.documentChanged('file:///a.tex', 2);
  await new Promise((resolve) => setTimeout(resolve, 100));
  assert.equal(fake.ofType('definitions').length, before);
});

test('plots are asked for with each picture, while they are shown, and told when they are others', async () => {
  const fake = await opened();
  fake.session.frameArrived(frame(1, 1));
  assert.deepEqual(fake.askedOf('texbrdf/plot'), []);
  await fake.session.pageSays({ type: 'plots', shown: true });
  await settled();
  fake.session.frameArrived(frame(1, 2));
  await settled();
  assert.equal(fake.askedOf('texbrdf/plot').length, 2);
  assert.equal(fake.ofType('plot').length, 1);
  fake.plot = { ...somePlot, values: [[3, 2, 1]] };
  fake.session.frameArrived(frame(1, 3));
  await settled();
  assert.deepEqual(fake.ofType('plot').at(-1)?.plot.values, [[3, 2, 1]]);
  await fake.session.pageSays({ type: 'plots', shown: false });
  fake.session.frameArrived(frame(1, 4));
  await settled();
  assert.equal(fake.askedOf('texbrdf/plot').length, 3);
});

test('a page that is back gets its plot at once', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'plots', shown: true });
  await settled();
  fake.session.pageLost();
  const before = fake.ofType('plot').length;
  await fake.session.pageSays({ type: 'ready' });
  await fake.session.pageSays({ type: 'plots', shown: true });
  assert.equal(fake.ofType('plot').length, before + 1);
});

test('a bad pixel is marked, and its definition revealed', async () => {
  const fake = await opened();
  const location = { uri: 'file:///part.tex', range: nowhere };
  fake.bad = { nan: 3, infinite: 0, negative: 0, first: { x: 0.1, y: 0.2, kind: 'nan', definition: 'D', label: 'D', location } };
  await fake.session.pageSays({ type: 'showBad' });
  assert.deepEqual(fake.revealed, [location]);
  assert.equal(fake.ofType('badPixel')[0]?.pixel.x, 0.1);
});

test('where no pixel is bad in double precision, that is said', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'showBad' });
  assert.deepEqual(fake.revealed, []);
  assert.match(fake.reports.join(), /double precision/);
});

test('where the search ended early or found nothing to search, that is said', async () => {
  const fake = await opened();
  fake.bad = { nan: 0, infinite: 0, negative: 0, first: null, problem: 'too slow to be searched' };
  await fake.session.pageSays({ type: 'showBad' });
  fake.bad = null;
  await fake.session.pageSays({ type: 'showBad' });
  assert.deepEqual(fake.reports, ['too slow to be searched', 'Nothing that can be drawn was searched.']);
});

test('a bad pixel whose definition is gone is marked all the same', async () => {
  const fake = await opened();
  fake.bad = { nan: 3, infinite: 0, negative: 0, first: { x: 0.1, y: 0.2, kind: 'nan', definition: 'D', label: 'D', location: null } };
  await fake.session.pageSays({ type: 'showBad' });
  assert.equal(fake.ofType('badPixel').length, 1);
  assert.match(fake.reports.join(), /no definition of D any more/);
});

test('a preview that nothing was drawn for has no plot', async () => {
  const fake = await opened();
  fake.plot = null;
  await fake.session.pageSays({ type: 'plots', shown: true });
  assert.deepEqual(fake.ofType('plot'), []);
});

test('document, root and look are remembered', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'root', root: 'g' });
  await fake.session.pageSays({ type: 'look', change: { zoom: 2 } });
  await new Promise((resolve) => setTimeout(resolve, 300));
  assert.deepEqual(fake.ofType('remember').map(({ memory }) => memory), [{ uri: 'file:///a.tex', root: 'g', look: { ...look, zoom: 2 } }]);
});

test('values are written short, and what is no number in words', () => {
  assert.deepEqual([0.123456, -2, 1e-9, 'nan', 'inf', '-inf'].map((value) => valueText(value as number)), ['0.1235', '−2', '1e−9', 'NaN', '∞', '−∞']);
  assert.equal(valuesText([1, 'nan', 0.5]), '(1, NaN, 0.5)');
  assert.equal(directionText('light', { theta: 33.94, phi: 0 }), 'light θ 33.9° φ 0.0°');
});

test('of a BRDF negative values are bad too', () => {
  assert.deepEqual([[0, 1], [0, -1], ['inf']].map((values) => isBadBrdf(values as number[])), [false, true, true]);
  assert.deepEqual([[0, -1], ['nan', 1]].map((values) => areNumbers(values as number[])), [true, false]);
});
