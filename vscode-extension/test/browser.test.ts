import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import type { BrowserEvents, FollowedDocument } from '../src/browser_protocol';
import { Editor } from '../src/preview/browser/editor';
import { Follower } from '../src/preview/browser/follower';
import type { Link } from '../src/preview/browser/link';
import { Outgoing } from '../src/preview/browser/outgoing';
import type { Roots } from '../src/protocol';

/** A server that takes posts when it is told to. */
class Posts {
  readonly bodies: string[] = [];
  private answers: ((status: number) => void)[] = [];

  readonly outgoing = new Outgoing((address, body) => {
    this.bodies.push(`${address}: ${body}`);
    return new Promise((resolve) => { this.answers.push(resolve); });
  });

  async answer(status: number): Promise<void> {
    this.answers.shift()?.(status);
    await pause(1);
  }
}

test('messages are posted one after the other, those that wait together', async () => {
  const posts = new Posts();
  posts.outgoing.open('a');
  for (const id of [1, 2, 3]) posts.outgoing.add({ id });
  assert.deepEqual(posts.bodies, ['a: {"id":1}']);
  await posts.answer(202);
  assert.deepEqual(posts.bodies, ['a: {"id":1}', 'a: {"id":2}\n{"id":3}']);
  await posts.answer(202);
  assert.equal(posts.bodies.length, 2);
});

test('what a busy server refuses is posted again', async () => {
  const posts = new Posts();
  posts.outgoing.open('a');
  posts.outgoing.add({ id: 1 });
  await posts.answer(503);
  await pause(200);
  assert.deepEqual(posts.bodies, ['a: {"id":1}', 'a: {"id":1}']);
});

test('what the server does not understand is not posted again, and who sent it is told', async () => {
  const posts = new Posts();
  const refused: number[] = [];
  posts.outgoing.open('a');
  posts.outgoing.add({ id: 1 }, () => refused.push(1));
  await posts.answer(400);
  await pause(200);
  assert.deepEqual(refused, [1]);
  assert.deepEqual(posts.bodies, ['a: {"id":1}']);
});

test('messages for a server that is gone are not posted to the next', async () => {
  const posts = new Posts();
  posts.outgoing.open('a');
  posts.outgoing.add({ id: 1 });
  posts.outgoing.add({ id: 2 });
  posts.outgoing.close();
  posts.outgoing.add({ id: 3 });
  posts.outgoing.open('b');
  posts.outgoing.add({ id: 4 });
  await posts.answer(202);
  assert.deepEqual(posts.bodies, ['a: {"id":1}', 'b: {"id":4}']);
});

class Shown {
  uri: string | undefined;
  readonly calls: unknown[] = [];
  roots: Record<string, Roots> = {};

  readonly follower = new Follower(this, (uri) => {
    const roots = this.roots[uri];
    return roots === undefined ? Promise.reject(new Error('not open')) : Promise.resolve(roots);
  });

  show = (subject: { uri: string }) => {
    this.uri = subject.uri;
    this.calls.push(['show', subject.uri]);
    return Promise.resolve();
  };
  documentChanged = (uri: string, version: number) => { this.calls.push(['changed', uri, version]); };
  documentClosed = (uri: string) => { this.calls.push(['closed', uri]); };
}

const drawable: Roots = { root: 'f', candidates: ['f'] };
const empty: Roots = { root: null, candidates: [] };
const document = (uri: string, version = 1): FollowedDocument => ({ uri, name: uri, version });

test('the document that was edited last is shown, and its versions are told', async () => {
  const shown = new Shown();
  shown.roots = { a: drawable, b: drawable };
  await shown.follower.follow({ uri: null });
  await shown.follower.follow(document('a'));
  await shown.follower.follow(document('a', 2));
  await shown.follower.follow(document('b'));
  await shown.follower.follow({ uri: null });
  assert.deepEqual(shown.calls, [['show', 'a'], ['changed', 'a', 2], ['show', 'b'], ['closed', 'b']]);
});

test('a document without a BRDF takes the place of none', async () => {
  const shown = new Shown();
  shown.roots = { a: drawable, empty };
  await shown.follower.follow(document('empty'));
  await shown.follower.follow(document('a'));
  await shown.follower.follow(document('empty', 2));
  assert.deepEqual(shown.calls, [['show', 'empty'], ['show', 'a']]);
});

test('that the shown document was closed is said where the next has no BRDF', async () => {
  const shown = new Shown();
  shown.roots = { a: drawable, empty };
  await shown.follower.follow(document('a'));
  shown.roots = { empty };
  await shown.follower.follow(document('empty'));
  assert.deepEqual(shown.calls, [['show', 'a'], ['closed', 'a']]);
});

test('of two documents that follow each other quickly the last is shown', async () => {
  const shown = new Shown();
  shown.roots = { a: drawable, b: drawable };
  await Promise.all([shown.follower.follow(document('a')), shown.follower.follow(document('b'))]);
  assert.deepEqual(shown.calls, [['show', 'b']]);
});

class FakeLink {
  readonly listeners = new Map<keyof BrowserEvents, (params: never) => void>();
  on = (event: keyof BrowserEvents, listener: (params: never) => void) => { this.listeners.set(event, listener); };
  request = () => Promise.resolve({ edit: 7 });
  readonly editor = new Editor(this as unknown as Link);
  tell<E extends keyof BrowserEvents>(event: E, params: BrowserEvents[E]): void {
    this.listeners.get(event)?.(params as never);
  }
}

test('an edit is done when the editor made it and the server has the text', async () => {
  const link = new FakeLink();
  const seen: string[] = [];
  const applied = link.editor.apply([]).then((value) => { seen.push(`applied: ${value}`); });
  await pause(5);
  link.tell('texbrdf/edited', { edit: 7, applied: true });
  await pause(5);
  assert.deepEqual(seen, []);
  link.tell('texbrdf/document', { uri: 'a', name: 'a', version: 2 });
  await applied;
  assert.deepEqual(seen, ['applied: true']);
});

test('an edit that the editor refuses was not made', async () => {
  const link = new FakeLink();
  const applied = link.editor.apply([]);
  await pause(5);
  link.tell('texbrdf/edited', { edit: 7, applied: false });
  assert.equal(await applied, false);
});

test('that an edit was made may be heard before its number', async () => {
  const link = new FakeLink();
  link.request = async () => {
    link.tell('texbrdf/document', { uri: 'a', name: 'a', version: 2 });
    link.tell('texbrdf/edited', { edit: 7, applied: true });
    return Promise.resolve({ edit: 7 });
  };
  assert.equal(await link.editor.apply([]), true);
});
