import assert from 'node:assert/strict';
import { test } from 'node:test';
import { direction, lightFrom, nudged, onSphere, turned } from '../src/preview/webview/light';
import type { Light } from '../src/protocol';

const near = (given: Light, wanted: Light) => {
  const [a, b] = [direction(given), direction(wanted)];
  assert.ok(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1e-9, `${JSON.stringify(given)} is not ${JSON.stringify(wanted)}`);
};

test('directions and angles are the same thing', () => {
  for (const light of [{ theta: 33.8941, phi: 145.826 }, { theta: 90, phi: 0 }, { theta: 120, phi: 300 }]) near(lightFrom(direction(light)), light);
  assert.deepEqual(lightFrom([0, 0, 1]), { theta: 0, phi: 0 });
});

test('the light follows the point that is dragged', () => {
  near(turned({ theta: 0, phi: 0 }, onSphere(0, 0), onSphere(0.5, 0)), { theta: 30, phi: 0 });
  near(turned({ theta: 0, phi: 0 }, onSphere(0, 0), onSphere(0, -0.5)), { theta: 30, phi: 270 });
  near(turned({ theta: 50, phi: 20 }, onSphere(0.3, 0.3), onSphere(0.3, 0.3)), { theta: 50, phi: 20 });
});

test('beside the sphere its edge is dragged', () => {
  near(turned({ theta: 90, phi: 0 }, onSphere(5, 0), onSphere(0, 2)), { theta: 90, phi: 90 });
});

test('keys move the light to the right and up', () => {
  near(nudged({ theta: 0, phi: 0 }, 10, 0), { theta: 10, phi: 0 });
  near(nudged({ theta: 0, phi: 0 }, 0, 10), { theta: 10, phi: 90 });
  near(nudged(nudged({ theta: 40, phi: 0 }, 5, 0), -5, 0), { theta: 40, phi: 0 });
});
