// Numbers, colours and words of the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pickedColour, pickerColour } from '../src/preview/webview/colour';
import { rounded, shown, sliderStep } from '../src/preview/webview/numbers';
import { freshness, statusText } from '../src/preview/webview/status_line';

test('a slider has some hundred steps that people would choose', () => {
  assert.equal(sliderStep(0, 1), 0.002);
  assert.equal(sliderStep(1, 500), 0.5);
  assert.equal(sliderStep(0, 1000), 2);
  assert.equal(sliderStep(0.01, 0.02), 0.00002);
  for (const [low, high] of [[1, 1], [2, 1], [0, Infinity], [NaN, 1]] as const) assert.equal(sliderStep(low, high), 1e-3);
});

test('values have no tail of digits', () => {
  assert.equal(rounded(0.30000000000000004, 0.002), 0.3);
  assert.equal(rounded(0.1234, 0.002), 0.124);
  assert.equal(rounded(60.3, 0.5), 60.5);
  assert.equal(rounded(-77.2, 2), -78);
  assert.equal(shown(0.1 + 0.2), '0.3');
  assert.equal(shown(1e-9), '1e-9');
});

test('the picker shows linear colours as sRGB', () => {
  assert.equal(pickerColour([0, 0.5, 1]), '#00bcff');
  assert.equal(pickerColour([-1, 2, 0.002]), '#00ff07');
});

test('channels that were left alone keep their digits', () => {
  assert.deepEqual(pickedColour(pickerColour([0.3, 0.05, 0.0512]), [0.3, 0.05, 0.0512]), [0.3, 0.05, 0.0512]);
  assert.deepEqual(pickedColour('#ff3f41', [0.3, 0.05, 0.0512]), [1, 0.05, 0.053]);
});

test('picked colours come back', () => {
  for (const picked of ['#000000', '#ffffff', '#336699', '#0a141e']) assert.equal(pickerColour(pickedColour(picked, [0.5, 0.5, 0.5])), picked);
});

const picture = {
  version: 7, source: 'cpu' as const, width: 256, height: 256, png: '', milliseconds: 0.84, current: true,
  badPixels: { nan: 0, infinite: 0, negative: 0 },
};

test('the status line says where a picture comes from', () => {
  assert.equal(statusText(picture), 'CPU · 256 × 256 · 0.8 ms · version 7');
  assert.equal(statusText({ ...picture, source: 'gpu', badPixels: { nan: 3, infinite: 0, negative: 12 } }),
    'GPU · 256 × 256 · 0.8 ms · version 7 · bad pixels: 3 NaN, 12 negative');
});

test('a picture is marked unless it is of the present text', () => {
  assert.equal(freshness(picture, 7), 'current');
  assert.equal(freshness(picture, 8), 'outdated');
  assert.equal(freshness({ ...picture, current: false }, 7), 'errors');
});
