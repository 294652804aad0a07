// The plots beside the curves in the plane of incidence: lobe, slice, tables, what the session asks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { direction, facesOf, projection, sampleUnder } from '../src/preview/webview/lobe';
import { axisTriangles, lobeTriangles, vertexFloats } from '../src/preview/webview/lobe_mesh';
import { cartesianFrame, quarterAxis } from '../src/preview/webview/plot_frame';
import { scaleFor } from '../src/preview/webview/plot_scale';
import { cartesianShapes, curvesOf, luminances } from '../src/preview/webview/plot_shapes';
import { curveTable, surfaceTable } from '../src/preview/webview/plot_table';
import { valuesAt } from '../src/preview/webview/plot_words';
import { cellUnder, colourOf, heat, pixelsOf, shownPart, sliceFrame } from '../src/preview/webview/slice';
import type { Plot, Surface, Value } from '../src/protocol';
import { opened } from './fake_server';

const size = { width: 300, height: 240 };
const rows = [0, 30, 60, 90];
const columns = [0, 90, 180, 270, 360];
const ball: Surface = { light: { theta: 45, phi: 0 }, rows, columns, values: [rows.flatMap(() => columns.map(() => 1))], cosine: false };
const unit = scaleFor('linear', [1]);
const facesSeen = (surface: Surface, elevation: number, numbers = surface.values[0] ?? []) =>
  facesOf([{ surface, numbers, isPinned: false }], unit, projection({ azimuth: 0, elevation }, 0, size));

test('a lobe has a face between each four samples that are numbers', () => {
  assert.equal(facesSeen(ball, 30).length, (rows.length - 1) * (columns.length - 1));
  const holes = (ball.values[0] ?? []).map((value, index): Value | null => [6, 7].includes(index) ? [null, 'nan' as const][index - 6] ?? null : value);
  assert.equal(facesSeen(ball, 30, holes).length, (rows.length - 1) * (columns.length - 1) - 6);
});

test('from above a lobe of one length is a disk of that radius', () => {
  const view = projection({ azimuth: 0, elevation: 90 }, 0, size);
  const centre = view.at([0, 0, 1], 1);
  for (const phi of columns) {
    const { x, y } = view.at(direction(90, phi), 1);
    assert.ok(Math.abs(Math.hypot(x - centre.x, y - centre.y) - Math.hypot(view.at(direction(90, 45), 1).x - centre.x, view.at(direction(90, 45), 1).y - centre.y)) < 1e-9);
  }
});

test('what is nearer is drawn later, and the pointer finds it', () => {
  const faces = facesSeen(ball, 30);
  const view = projection({ azimuth: 0, elevation: 30 }, 0, size);
  const towards = view.at(direction(60, 180 + 45), 1); // The eye is at phi 180.
  const sample = sampleUnder(faces, towards) ?? -1;
  assert.ok([180, 270].includes(columns[sample % columns.length] ?? -1), String(sample));
  assert.equal(sampleUnder(faces, { x: 0, y: 0 }), undefined);
});

test('light comes from the eye, and never goes out', () => {
  for (const { light } of facesSeen(ball, 20)) assert.ok(light >= 0.4 && light <= 1);
});

const white = [1, 1, 1, 1] as const;
const vertices = (floats: readonly number[]) => Array.from({ length: floats.length / vertexFloats }, (_, i) => floats.slice(i * vertexFloats, (i + 1) * vertexFloats));

test('the triangles of a ball have normals along its radii and the nearness of their places', () => {
  const rows = [0, 10, 20, 30];
  const cap: Surface = { ...ball, rows, columns: [0, 10, 20, 30], values: [Array<number>(16).fill(1)] };
  const view = projection({ azimuth: 0, elevation: 40 }, 0, size);
  const found = vertices(lobeTriangles({ surface: cap, numbers: cap.values[0] ?? [], isPinned: false }, unit, view, white));
  assert.equal(found.length, 6 * 9);
  const way = direction(10, 10); // An inner sample: its normal is the mean of all around it.
  const place = view.at(way, 1);
  const there = found.filter(([x = 0, y = 0]) => Math.hypot(x - place.x, y - place.y) < 1e-9);
  assert.equal(there.length, 6);
  for (const [, , nearness = 0, x = 0, y = 0, z = 0] of there) {
    assert.ok(Math.abs(nearness - view.nearness(way)) < 1e-12);
    assert.ok(Math.abs(x * way[0] + y * way[1] + z * way[2]) / Math.hypot(x, y, z) > Math.cos(5 * Math.PI / 180));
  }
});

test('an axis is a strip of its width, lit from nowhere', () => {
  const view = projection({ azimuth: 30, elevation: 20 }, 0, size);
  const end = direction(90, 60);
  const found = vertices(axisTriangles({ end, length: 1.05, paint: white, width: 3 }, view));
  const [a, b, c] = found.map(([x = 0, y = 0]) => ({ x, y }));
  assert.ok(a !== undefined && b !== undefined && c !== undefined);
  assert.ok(Math.abs(Math.hypot(a.x - b.x, a.y - b.y) - 3) < 1e-9);
  assert.equal(found[2]?.[2], 1.05 * view.nearness(end));
  for (const [, , , ...normal] of found) assert.deepEqual(normal.slice(0, 3), [0, 0, 0]);
});

test('the colours of a slice get lighter all the way', () => {
  const lightness = ([r, g, b]: readonly [number, number, number]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
  for (let i = 1; i <= 100; ++i) assert.ok(lightness(heat(i / 100)) > lightness(heat((i - 1) / 100)) - 0.5, String(i));
  assert.deepEqual(heat(0), [0, 0, 4]);
  assert.deepEqual(heat(1), [255, 255, 215]);
});

test('no number and below the surface have colours of their own', () => {
  assert.notDeepEqual(colourOf(null, unit), colourOf('nan', unit));
  assert.deepEqual(colourOf(7, unit), heat(1));
  assert.deepEqual(colourOf(-7, unit), heat(0));
});

test('a slice has its largest difference angle on top', () => {
  const slice: Surface = { light: { theta: 0 }, rows: [22.5, 67.5], columns: [22.5, 67.5], values: [[0, 0, 1, 0]], cosine: false };
  const pixels = pixelsOf(slice, slice.values[0] ?? [], unit);
  assert.deepEqual([...pixels.slice(0, 4)], [...heat(1), 255]);
  const frame = sliceFrame(size);
  const { left, top, side } = frame;
  assert.equal(cellUnder(slice, frame, { x: left + side / 4, y: top + side / 4 }), 2);
  assert.equal(cellUnder(slice, frame, { x: left + side * 3 / 4, y: top + side * 3 / 4 }), 1);
  assert.equal(cellUnder(slice, frame, { x: left - 1, y: top }), undefined);
});

test('a few values far above all others do not darken a slice', () => {
  assert.deepEqual(shownPart([...Array.from({ length: 99 }, () => 1), 1e6, 'inf', null]), Array.from({ length: 98 }, () => 1));
});

test('an axis of a quarter turn begins at 0', () => {
  const frame = cartesianFrame(size, quarterAxis('θ_h'));
  assert.equal(frame.at(0, 0).x, frame.left);
  assert.equal(frame.at(90, 0).x, frame.right);
  assert.equal(frame.angleAt(frame.at(33, 0.2)), 33);
});

const albedo: Plot = { light: { theta: 0 }, angles: [0, 45, 89], values: [[0.5, 0.6, 'nan']], errors: [[0.01, 0.02, 'nan']], cosine: false };

test('the error of an albedo is a band about its curve', () => {
  const curves = curvesOf(albedo, false, () => true);
  const drawing = { curves, angles: albedo.angles, cursor: 0, scale: scaleFor('linear', [1]), label: 'ρ' };
  const shapes = cartesianShapes(drawing, size, quarterAxis('θᵢ'));
  const band = shapes.find(({ className }) => className === 'band grey');
  assert.equal(String(band?.attributes.d).match(/[ML]/g)?.length, 5);
  assert.ok(shapes.every(({ className }) => className !== 'lamp'));
});

test('the luminance is that of linear sRGB', () => {
  assert.deepEqual(luminances([[1, 0, 'nan', null], [0, 1, 1, 1], [0, 0, 1, 1]]), [0.2126, 0.7152, 'nan', null]);
  const colour: Plot = { light: { theta: 0 }, angles: [0], values: [[1], [1], [1]], cosine: false };
  assert.deepEqual(curvesOf(colour, false, () => false, true).map(({ channel }) => channel), ['grey']);
});

test('a direction below the surface has no value', () => {
  assert.equal(valuesAt({ light: { theta: 0 }, angles: [0, 90], values: [[1, null]], cosine: false }, 90), 'below the surface');
});

test('tables have all digits, and empty cells below the surface', () => {
  assert.equal(curveTable(albedo, 'theta_i'), 'theta_i,value,value_error\n0,0.5,0.01\n45,0.6,0.02\n89,nan,nan\n');
  const surface: Surface = { light: { theta: 0 }, rows: [10], columns: [20, 30], values: [[1 / 3, null], [0, null], [2e-7, null]], cosine: false };
  assert.equal(surfaceTable(surface, ['theta_d', 'theta_h']), 'theta_d,theta_h,red,green,blue\n10,20,0.3333333333333333,0,2e-7\n10,30,,,\n');
});

test('a further plot is asked for with its angles, and again with each picture', async () => {
  const fake = await opened();
  const question = { kind: 'theta-h' as const, thetaD: 30, phiD: 90 };
  fake.plot = albedo;
  await fake.session.pageSays({ type: 'furtherPlot', question });
  await new Promise(setImmediate);
  const asked = () => fake.asked.filter(([method]) => method === 'texbrdf/plot');
  assert.deepEqual(asked().at(-1), ['texbrdf/plot', { preview: 1, ...question }]);
  assert.deepEqual(fake.ofType('furtherPlot').at(-1), { type: 'furtherPlot', further: { question, plot: albedo } });
  const before = asked().length;
  await fake.session.pageSays({ type: 'furtherPlot', question: null });
  await new Promise(setImmediate);
  assert.equal(asked().length, before);
});

test('tables are saved under the name of the document', async () => {
  const fake = await opened();
  await fake.session.pageSays({ type: 'saveTable', table: 'a\n1\n', kind: 'albedo' });
  assert.deepEqual(fake.tables, [['a\n1\n', 'a-albedo.csv']]);
});
