// The line below the sphere: directions and values at the point below the pointer, or where keys have put it.
import type { Definition, Point, Probed } from '../messages';
import { element, oncePerFrame, tell } from './host';
import { clamped } from './numbers';
import { pictureFraction, placeMark } from './picture_box';
import { areNumbers, directionText, isBadBrdf, valuesText } from './readout_words';

const stage = element('stage');
const directions = element<HTMLOutputElement>('readoutDirections');
const value = element<HTMLOutputElement>('readoutValue');
const choice = element<HTMLSelectElement>('definition');
const definitionValue = element<HTMLOutputElement>('readoutDefinition');
const fractionPerKey = 0.02;
const fractionPerFineKey = 0.004;
const moves: Record<string, [number, number]> = { KeyA: [-1, 0], KeyD: [1, 0], KeyW: [0, -1], KeyS: [0, 1] };

let point: Point | undefined;
/** By the pointer, not by keys: it goes when the pointer does. */
let isPointed = false;
let root = 'f';

const send = oncePerFrame((at: Point | null) => { tell({ type: 'probe', point: at }); });

export function watchReadout(): void {
  stage.addEventListener('pointermove', (event) => {
    placeMark('probeMark', undefined);
    choose(pictureFraction(event), true);
  });
  stage.addEventListener('pointerleave', () => { if (isPointed) read(undefined); });
  stage.addEventListener('keydown', (event) => {
    const move = moves[event.code];
    if (move === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    moveBy(move, event.shiftKey ? fractionPerFineKey : fractionPerKey);
  });
  choice.addEventListener('change', () => { tell({ type: 'definition', name: choice.value === '' ? null : choice.value }); });
  clear();
}

export function showRoot(name: string | null): void {
  root = name ?? 'f';
}

export function showDefinitions(definitions: Definition[], chosen: string | null): void {
  element('definitionChoice').hidden = definitions.length === 0;
  const options = definitions.map(({ name, label }) => new Option(label, name, false, name === chosen));
  choice.replaceChildren(new Option('—', '', false, chosen === null), ...options);
  if (chosen === null) definitionValue.textContent = '';
}

export function showReadout(readout: Probed | null): void {
  if (point === undefined) return; // The pointer has left since.
  if (readout === null) {
    clear();
    return;
  }
  directions.textContent = `${directionText('light', readout.light)} · ${directionText('view', readout.view)}`;
  showValue(value, readout.value === null ? readout.problem ?? 'not lit' : `${root} = ${valuesText(readout.value)}`, isBadBrdf(readout.value ?? []));
  const { definition } = readout;
  showValue(definitionValue, definition === undefined ? '' : `= ${valuesText(definition.value)}`, !areNumbers(definition?.value ?? []));
}

export function clearReadout(): void {
  placeMark('probeMark', undefined);
  read(undefined);
}

function read(at: Point | undefined): void {
  if (at === undefined && point === undefined) return;
  point = at;
  if (at === undefined) clear();
  send(at ?? null);
}

function moveBy([right, down]: [number, number], by: number): void {
  const { x, y } = point ?? { x: 0.5, y: 0.5 };
  const moved = { x: clamped(x + right * by, 0, 1), y: clamped(y + down * by, 0, 1) };
  placeMark('probeMark', moved);
  choose(moved, false);
}

/** Screen readers say what keys have asked for, not what the pointer passes. */
function choose(at: Point | undefined, byPointer: boolean): void {
  isPointed = byPointer;
  for (const output of [value, definitionValue]) output.setAttribute('aria-live', byPointer ? 'off' : 'polite');
  read(at);
}

function clear(): void {
  directions.textContent = 'Point at the sphere to read its values';
  showValue(value, '', false);
  showValue(definitionValue, '', false);
}

function showValue(output: HTMLOutputElement, text: string, bad: boolean): void {
  output.textContent = text;
  output.classList.toggle('bad', bad);
}
