// A scene in the place of the sphere: drags, wheel and keys go to the server; the view can be chosen.
import type { SceneKeys, ToPage } from '../messages';
import { element, tell } from './host';
import { SceneHands } from './scene_input';

const layer = element('sceneLayer');
const choice = element<HTMLSelectElement>('sceneView');
const hands = new SceneHands();
const firstStep = 1 / 60; // s: what a key counts that went down just now

let lastSent: number | undefined;
let isWaiting = false;

export function showScene({ views, view, keys }: ToPage & { type: 'scene' }): void {
  choice.replaceChildren(...views.map(({ name, meaning }) => {
    const option = new Option(name, name, false, name === view);
    option.title = meaning;
    return option;
  }));
  element('sceneKeys').textContent = keysText(keys);
}

export function showKind(isScene: boolean): void {
  document.body.dataset.kind = isScene ? 'scene' : 'brdf';
  layer.hidden = !isScene;
}

export function watchScene(): void {
  layer.addEventListener('pointerdown', (event) => {
    layer.setPointerCapture(event.pointerId);
    layer.focus();
  });
  layer.addEventListener('pointermove', (event) => {
    if (event.buttons === 0 || !layer.hasPointerCapture(event.pointerId)) return;
    const height = Math.max(1, Math.min(layer.clientWidth, layer.clientHeight));
    hands.dragBy(event.movementX / height, event.movementY / height);
    sendSoon();
  });
  layer.addEventListener('wheel', (event) => {
    event.preventDefault();
    hands.turnWheel(event.deltaY);
    sendSoon();
  }, { passive: false });
  layer.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !hands.keyDown(event.code, event.repeat)) return;
    event.preventDefault();
    sendSoon();
  });
  layer.addEventListener('keyup', (event) => { hands.keyUp(event.code); });
  layer.addEventListener('blur', () => { hands.release(); });
  // What is below belongs to the sphere.
  for (const type of ['pointerdown', 'pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'dblclick', 'pointerleave', 'click']) {
    layer.addEventListener(type, (event) => { event.stopPropagation(); });
  }
  choice.addEventListener('change', () => { tell({ type: 'sceneView', view: choice.value }); });
}

function sendSoon(): void {
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(send);
}

function send(now: number): void {
  isWaiting = false;
  const input = hands.take(lastSent === undefined ? firstStep : (now - lastSent) / 1000);
  lastSent = hands.isHolding ? now : undefined;
  if (input !== undefined) tell({ type: 'sceneInput', input });
  if (hands.isHolding) sendSoon();
}

function keysText(keys: SceneKeys[]): string {
  return keys.map(({ object, keys: names }) => `${object}: ${names.join(' ')}`).join(' · ');
}
