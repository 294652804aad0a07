import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CrashPolicy, mostCrashes, withinMilliseconds } from '../src/crash_policy';

const pauses = (policy: CrashPolicy, times: number[]) => times.map((time) => policy.crashed(time));

test('the first crash costs no pause, the next ever longer ones, the fifth is the last', () => {
  assert.deepEqual(pauses(new CrashPolicy(), [0, 1000, 2000, 3000, 4000]), [0, 500, 1000, 2000, undefined]);
});

test('crashes long ago do not count', () => {
  const rare = Array.from({ length: 3 * mostCrashes }, (_, index) => index * withinMilliseconds);
  assert.deepEqual(new Set(pauses(new CrashPolicy(), rare)), new Set([0]));
});

test('a restart on purpose begins anew', () => {
  const policy = new CrashPolicy();
  pauses(policy, [0, 1, 2, 3]);
  policy.forget();
  assert.equal(policy.crashed(4), 0);
});
