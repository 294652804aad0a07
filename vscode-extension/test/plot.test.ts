// The plots: axes, curves, words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cartesianFrame, polarFrame } from '../src/preview/webview/plot_frame';
import { fractionOf, scaleFor, tickText } from '../src/preview/webview/plot_scale';
import { cartesianShapes, curvesOf, pathThrough, polarShapes, sampleAt } from '../src/preview/webview/plot_shapes';
import type { Shape } from '../src/preview/webview/plot_shapes';
import { plotDescription, quantity, valuesAt } from '../src/preview/webview/plot_words';
import type { Plot, Value } from '../src/protocol';

const angles = [-90, -45, 0, 45, 90];
const size = { width: 250, height: 200 };
const plot = (values: Value[][], cosine = false): Plot => ({ light: { theta: 30 }, angles, values, cosine });
const grey = plot([[0, 1, 2, 'nan', 1]]);
const colour = plot([[0, 1, 2, 3, 4], [0, 1, 'inf', 1, 0], [0, 0, 0, 0, 0]]);
const drawing = (shown: Plot, kind: 'linear' | 'log' = 'linear') => {
  const curves = curvesOf(shown, false, () => true);
  return { curves, angles, light: 30, cursor: 0, scale: scaleFor(kind, curves.flatMap(({ values }) => values)), label: 'f' };
};
const ofClass = (shapes: Shape[], name: string) => shapes.filter(({ className }) => className.split(' ').includes(name));

test('a linear axis begins at 0, or below what is negative, and ends above all', () => {
  assert.deepEqual(scaleFor('linear', [0.1, 0.87]), { kind: 'linear', low: 0, high: 1, ticks: [0, 0.5, 1] });
  assert.deepEqual(scaleFor('linear', [-1, 3]), { kind: 'linear', low: -1, high: 3, ticks: [-1, 0, 1, 2, 3] });
  assert.deepEqual(scaleFor('linear', [0.3]).ticks, [0, 0.1, 0.2, 0.3]);
});

test('an axis stands for any values', () => {
  const odd: Value[][] = [[], [0], ['nan', 'inf', '-inf'], [5e-324], [1e308, -1e308], [1e-308]];
  for (const kind of ['linear', 'log'] as const) {
    for (const values of odd) {
      const { low, high, ticks } = scaleFor(kind, values);
      assert.ok(low < high && Number.isFinite(high - low), `${kind} ${values.join()}`);
      assert.ok(ticks.length >= 2 && ticks.length <= 8 && ticks.every(Number.isFinite), `${kind} ${values.join()}: ${ticks.join()}`);
    }
  }
});

test('a logarithmic axis has whole decades, and not too many', () => {
  assert.deepEqual(scaleFor('log', [0.02, 3]), { kind: 'log', low: -2, high: 1, ticks: [0.01, 0.1, 1, 10] });
  assert.deepEqual(scaleFor('log', [1e-200, 0, -3, 7]), { kind: 'log', low: -7, high: 1, ticks: [1e-7, 1e-5, 1e-3, 0.1, 10] });
  assert.deepEqual(scaleFor('log', [1]).ticks, [0.1, 1]);
});

test('what has no place on an axis is not drawn', () => {
  const linear = scaleFor('linear', [2]);
  assert.deepEqual([0, 1, 2, -1, 'nan', 'inf'].map((value) => fractionOf(linear, value as Value)), [0, 0.5, 1, undefined, undefined, undefined]);
  const log = scaleFor('log', [0.1, 10]);
  assert.deepEqual([0.1, 1, 10, 0, -1].map((value) => fractionOf(log, value)), [0, 0.5, 1, undefined, undefined]);
});

test('ticks are written as people would', () => {
  const [linear, log] = [scaleFor('linear', [1]), scaleFor('log', [1])];
  assert.deepEqual([0, 0.5, -2, 20000].map((tick) => tickText(linear, tick)), ['0', '0.5', '−2', '20000']);
  assert.equal(tickText(linear, 2e7), '2.0e+7');
  assert.deepEqual([1e-12, 0.001, 0.01, 1, 100, 1000].map((tick) => tickText(log, tick)), ['10⁻¹²', '10⁻³', '0.01', '1', '100', '10³']);
});

test('a curve has a gap where it has no value', () => {
  assert.equal(pathThrough([{ x: 0, y: 1 }, { x: 2, y: 3.001 }, undefined, { x: 5, y: 6 }]), 'M0 1L0 1L2 3M5 6L5 6');
  assert.equal(pathThrough([undefined]), '');
});

test('both frames lead from an angle to a point and back', () => {
  for (const frame of [cartesianFrame(size), polarFrame(size)]) {
    for (const angle of [-90, -30, 0, 61.5, 90]) assert.ok(Math.abs(frame.angleAt(frame.at(angle, 0.7)) - angle) < 1e-9);
  }
  assert.equal(cartesianFrame(size).angleAt({ x: -100, y: 0 }), -90);
  assert.equal(polarFrame(size).angleAt({ x: 250, y: 500 }), 90);
});

test('frames stay in order in a pane of no size', () => {
  const none = { width: 0, height: 0 };
  assert.ok(polarFrame(none).radius > 0 && cartesianFrame(none).right > cartesianFrame(none).left);
});

test('the polar plot has the normal above, the light on the left', () => {
  const shapes = polarShapes(drawing(grey), size);
  const frame = polarFrame(size);
  const { centre, radius } = frame;
  const [lamp] = ofClass(shapes, 'lamp');
  assert.ok(Number(lamp?.attributes.cx) < centre.x);
  assert.deepEqual(frame.at(0, 1), { x: centre.x, y: centre.y - radius });
});

test('the centre of the polar plot is 0, whatever is negative', () => {
  const [curve] = ofClass(polarShapes(drawing(plot([[0, 1, 0, -1, 0]])), size), 'curve');
  const { x, y } = polarFrame(size).centre;
  assert.equal(curve?.attributes.d, pathThrough([{ x, y }, polarFrame(size).at(-45, 1), { x, y }, undefined, { x, y }]));
});

test('labels of rings keep apart, the outermost stays', () => {
  const labels = (width: number) => polarShapes(drawing(plot([[1e-4, 1e-3, 0.01, 0.1, 1]]), 'log'), { width, height: 400 })
    .filter(({ tag, attributes }) => tag === 'text' && attributes['text-anchor'] === 'middle').map(({ text }) => text);
  assert.deepEqual(labels(500).slice(0, 4), ['1', '0.1', '0.01', '10⁻³']);
  assert.deepEqual(labels(180).slice(0, 2), ['1', '0.01']);
});

test('a light below the surface is not shown', () => {
  assert.deepEqual(ofClass(cartesianShapes({ ...drawing(grey), light: 120 }, size), 'lamp'), []);
});

test('each channel has its curve, a real one', () => {
  for (const shapes of [polarShapes, cartesianShapes]) {
    assert.deepEqual(ofClass(shapes(drawing(grey), size), 'curve').map(({ className }) => className), ['curve grey']);
    assert.deepEqual(ofClass(shapes(drawing(colour), size), 'curve').map(({ className }) => className), ['curve red', 'curve green', 'curve blue']);
  }
});

test('channels that are switched off are left out, pinned ones are dashed', () => {
  const curves = curvesOf(colour, true, (channel) => channel === 'green');
  assert.deepEqual(curves, [{ channel: 'green', isPinned: true, values: colour.values[1] }]);
  assert.equal(ofClass(cartesianShapes({ ...drawing(colour), curves }, size), 'pinned').length, 1);
});

test('where a value is no number there is a mark in place of the curve', () => {
  const marks = (shown: Plot) => ofClass(cartesianShapes(drawing(shown), size), 'missing').map(({ attributes }) => attributes.d);
  assert.match(String(marks(grey)[0]), /^M[\d.]+ 20L[\d.]+ 20$/);
  assert.deepEqual(marks(plot([[1, 1, 1, 1, 1]])), ['']);
});

test('the cursor reads the nearest sample', () => {
  assert.equal(sampleAt(angles, 20), 2);
  assert.equal(sampleAt(angles, 1000), 4);
  assert.equal(valuesAt(colour, 3), 'R 2 · G ∞ · B 0');
  assert.equal(valuesAt(grey, 45), 'NaN');
});

test('a plot without values says why', () => {
  const none: Plot = { light: { theta: 120 }, angles: [], values: [], cosine: true, problem: 'the light is behind the surface' };
  assert.match(plotDescription('Polar', 'f', none), /; the light is behind the surface$/);
  for (const shapes of [polarShapes, cartesianShapes]) {
    assert.deepEqual(ofClass(shapes(drawing(none), size), 'dot'), []);
  }
});

test('a plot has words for those who do not see it', () => {
  assert.equal(plotDescription('Polar', 'f', grey), 'Polar plot of f over the viewer\'s angle, light at 30°; largest 2 at 0°');
  assert.match(plotDescription('Polar', 'f', plot([['nan', 'nan', 'nan', 'nan', 'nan']])), /no values$/);
  assert.equal(quantity('f', plot([[1]], true)), 'f · cos θₒ');
});
