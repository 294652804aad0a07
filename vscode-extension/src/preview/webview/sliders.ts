// A control for each parameter. Moving it changes the picture only; letting it go writes the document.
import type { Parameter } from '../messages';
import { unmarkBadPixel } from './bad_pixels';
import { pickedColour, pickerColour } from './colour';
import { element, oncePerFrame, tell } from './host';
import { clamped, rounded, shown, sliderStep } from './numbers';

const section = element('parameters');
const list = element('sliders');

interface Row {
  parameter: Parameter;
  node: HTMLElement;
  show: (value: number[]) => void;
  held: boolean;
}

let rows: Row[] = [];

export function watchSliders(): void {
  element('resetAll').addEventListener('click', () => { tell({ type: 'reset', names: rows.map(({ parameter }) => parameter.name) }); });
}

/** Where only values changed, the controls stay: one that is being moved must not be taken away. */
export function showParameters(parameters: Parameter[]): void {
  if (!sameControls(parameters)) {
    rows = parameters.map(makeRow);
    list.replaceChildren(...rows.map(({ node }) => node));
  }
  parameters.forEach((parameter, index) => {
    const row = rows[index];
    if (row === undefined) return;
    row.parameter = parameter;
    if (!row.held) row.show(parameter.value);
  });
  section.hidden = parameters.length === 0;
}

function sameControls(parameters: Parameter[]): boolean {
  const shape = ({ name, label, type, low, high }: Parameter) => JSON.stringify([name, label, type, low, high]);
  return parameters.length === rows.length && parameters.every((parameter, index) => {
    const row = rows[index];
    return row !== undefined && shape(parameter) === shape(row.parameter);
  });
}

function makeRow(parameter: Parameter): Row {
  const node = document.createElement('div');
  node.className = 'row';
  const row: Row = { parameter, node, show: () => undefined, held: false };
  const label = document.createElement('button');
  label.className = 'link';
  label.textContent = parameter.label;
  label.title = 'Show where it is defined';
  label.addEventListener('click', () => { tell({ type: 'reveal', name: parameter.name }); });
  const reset = document.createElement('button');
  reset.textContent = '↺';
  reset.title = `Reset ${parameter.label}`;
  reset.setAttribute('aria-label', reset.title);
  reset.addEventListener('click', () => { tell({ type: 'reset', names: [parameter.name] }); });
  const controls = parameter.type === 'colour' ? colourControls(row) : realControls(row);
  node.append(label, ...controls, reset);
  return row;
}

/** What moving and letting go do. */
function hold(row: Row): { move: (value: number[]) => void; release: (value: number[]) => void } {
  const set = oncePerFrame((value: number[]) => {
    if (row.held) tell({ type: 'set', name: row.parameter.name, value });
  });
  return {
    move: (value) => {
      row.held = true;
      unmarkBadPixel();
      row.show(value);
      set(value);
    },
    release: (value) => {
      row.held = false;
      row.show(value);
      tell({ type: 'write', name: row.parameter.name, value });
    },
  };
}

function realControls(row: Row): HTMLElement[] {
  const { label, low, high } = row.parameter;
  const step = sliderStep(low, high);
  const slider = input('range', label, { min: String(low), max: String(high), step: 'any' });
  const number = input('number', `${label}, as a number`, { step: 'any' });
  const { move, release } = hold(row);
  const slid = () => [clamped(rounded(slider.valueAsNumber, step), low, high)];
  slider.addEventListener('input', () => { move(slid()); });
  slider.addEventListener('change', () => { release(slid()); });
  slider.addEventListener('keydown', (event) => {
    const steps = keySteps[event.key];
    if (steps === undefined) return;
    event.preventDefault();
    move([clamped(rounded(slider.valueAsNumber + steps * step, step), low, high)]);
  });
  slider.addEventListener('keyup', (event) => { if (event.key in keySteps) release(slid()); });
  slider.addEventListener('blur', () => { if (row.held) release(slid()); });
  number.addEventListener('change', () => { if (Number.isFinite(number.valueAsNumber)) release([number.valueAsNumber]); });
  row.show = ([value = 0]) => {
    slider.valueAsNumber = value;
    slider.setAttribute('aria-valuetext', shown(value));
    if (document.activeElement !== number) number.value = shown(value);
  };
  return [slider, number];
}

const keySteps: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -20, PageUp: 20 };

function colourControls(row: Row): HTMLElement[] {
  const picker = input('color', row.parameter.label, {});
  const text = document.createElement('span');
  text.className = 'colour';
  const { move, release } = hold(row);
  const picked = () => pickedColour(picker.value, row.parameter.value);
  picker.addEventListener('input', () => { move(picked()); });
  picker.addEventListener('change', () => { release(picked()); });
  row.show = (value) => {
    picker.value = pickerColour(value);
    text.textContent = value.map(shown).join(', ');
  };
  return [picker, text];
}

function input(type: string, label: string, attributes: Record<string, string>): HTMLInputElement {
  const node = document.createElement('input');
  node.type = type;
  node.setAttribute('aria-label', label);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}
