// How the sphere looks: light and zoom by pointer and keys, the rest by controls.
import type { Look } from '../messages';
import { isPlain, orbited, plainObject, withStandardOrbit } from '../object_look';
import { unmarkBadPixel } from './bad_pixels';
import { element, oncePerFrame, tell } from './host';
import { nudged, onSphere, turned } from './light';
import type { Vector } from './light';
import { clamped } from './numbers';
import { showObject, watchObject } from './object';
import { pictureBox } from './picture_box';

const sphereOfPicture = 0.9;
const smallestZoom = 0.25;
const largestZoom = 16;
const zoomPerKey = 1.1;
const zoomPerPixel = 0.0015;
const degreesPerKey = 5;
const degreesPerFineKey = 1;
const degreesPerPicture = 180;

const stage = element('stage');
const sliders = { exposure: element<HTMLInputElement>('exposure'), gamma: element<HTMLInputElement>('gamma') };
const cosine = element<HTMLInputElement>('cosine');

let look: Look | undefined;
let standard: Look | undefined;
const waiting: Partial<Look> = {};

const send = oncePerFrame(() => {
  tell({ type: 'look', change: { ...waiting } });
  for (const key of Object.keys(waiting) as (keyof Look)[]) delete waiting[key];
});

export function showLook(given: Look, standardLook: Look): void {
  look = given;
  standard = standardLook;
  refreshControls();
}

export function watchLook(): void {
  watchPointer();
  watchObject((object) => { change({ object }); });
  stage.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY * zoomPerPixel));
  }, { passive: false });
  stage.addEventListener('dblclick', resetView);
  stage.addEventListener('keydown', (event) => { if (pressed(event)) event.preventDefault(); });
  for (const name of ['exposure', 'gamma'] as const) {
    sliders[name].addEventListener('input', () => { change({ [name]: sliders[name].valueAsNumber }); });
  }
  cosine.addEventListener('change', () => { change({ cosine: cosine.checked }); });
  element('resetLook').addEventListener('click', () => { if (standard !== undefined) change(standard); });
}

function change(part: Partial<Look>): void {
  if (look === undefined) return;
  look = { ...look, ...part };
  Object.assign(waiting, part);
  unmarkBadPixel();
  refreshControls();
  send(undefined);
}

function refreshControls(): void {
  if (look === undefined) return;
  for (const name of ['exposure', 'gamma'] as const) {
    sliders[name].valueAsNumber = look[name];
    element<HTMLOutputElement>(`${name}Value`).textContent = look[name].toFixed(2);
  }
  cosine.checked = look.cosine;
  showObject(look.object ?? plainObject);
}

function resetView(): void {
  if (standard === undefined) return;
  const object = look?.object === undefined ? {} : { object: withStandardOrbit(look.object) };
  change({ light: standard.light, zoom: standard.zoom, ...object });
}

/** Whether what is dragged is an object, and not its light. */
function turnsObject(event: MouseEvent | KeyboardEvent): boolean {
  return look?.object !== undefined && !isPlain(look.object) && !event.shiftKey;
}

function orbit(right: number, down: number): void {
  if (look?.object !== undefined) change({ object: orbited(look.object, right, down) });
}

function zoomBy(factor: number): void {
  if (look !== undefined) change({ zoom: clamped(look.zoom * factor, smallestZoom, largestZoom) });
}

/** The point of the sphere below the pointer. */
function pointOf(event: PointerEvent): Vector {
  const { centre, side } = pictureBox();
  const radius = side / 2 * sphereOfPicture * (look?.zoom ?? 1);
  return onSphere((event.clientX - centre.x) / radius, (centre.y - event.clientY) / radius);
}

function watchPointer(): void {
  let from: Vector | undefined;
  stage.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    stage.setPointerCapture(event.pointerId);
    from = pointOf(event);
  });
  stage.addEventListener('pointermove', (event) => {
    if (from === undefined || look === undefined) return;
    if (turnsObject(event)) {
      const degrees = degreesPerPicture / pictureBox().side;
      orbit(event.movementX * degrees, event.movementY * degrees);
      from = pointOf(event);
      return;
    }
    const to = pointOf(event);
    change({ light: turned(look.light, from, to) });
    from = to;
  });
  const release = () => { from = undefined; };
  stage.addEventListener('pointerup', release);
  stage.addEventListener('pointercancel', release);
}

/** Whether the key meant something. */
function pressed(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.altKey || event.metaKey) return false;
  const by = event.shiftKey ? degreesPerFineKey : degreesPerKey;
  const nudge = turnsObject(event) ? orbitUp : nudgeLight;
  switch (event.key) {
    case 'ArrowLeft': nudge(-by, 0); return true;
    case 'ArrowRight': nudge(by, 0); return true;
    case 'ArrowUp': nudge(0, by); return true;
    case 'ArrowDown': nudge(0, -by); return true;
    case '+':
    case '=': zoomBy(zoomPerKey); return true;
    case '-': zoomBy(1 / zoomPerKey); return true;
    case '0': resetView(); return true;
    default: return false;
  }
}

function orbitUp(right: number, up: number): void {
  orbit(right, -up);
}

function nudgeLight(right: number, up: number): void {
  if (look !== undefined) change({ light: nudged(look.light, right, up) });
}
