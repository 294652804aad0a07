// The choice of an object and its light.
import { isPlain, plainObject, withStandardOrbit } from '../object_look';
import type { ObjectLook } from '../object_look';
import { element } from './host';

const shape = element<HTMLSelectElement>('shape');
const shapePath = element<HTMLInputElement>('shapePath');
const light = element<HTMLSelectElement>('lightSource');
const lightPath = element<HTMLInputElement>('lightPath');
const samples = element<HTMLInputElement>('samples');
const sun = { elevation: element<HTMLInputElement>('sunElevation'), azimuth: element<HTMLInputElement>('sunAzimuth') };
const turbidity = element<HTMLInputElement>('turbidity');
const keys = element('keys');
const plainHint = keys.textContent;
const file = 'file';

let object = plainObject;

/** `change` is told what somebody has chosen. */
export function watchObject(change: (object: ObjectLook) => void): void {
  const choose = (part: Partial<ObjectLook>) => { change({ ...object, ...part }); };
  const chooseShape = (name: string) => { if (name !== '') change(withStandardOrbit({ ...object, shape: name })); };
  const chooseLight = (name: string) => { if (name !== '') choose({ light: name }); };
  shape.addEventListener('change', () => { choosePath(shape, shapePath, chooseShape); });
  light.addEventListener('change', () => { choosePath(light, lightPath, chooseLight); });
  shapePath.addEventListener('change', () => { chooseShape(shapePath.value.trim()); });
  lightPath.addEventListener('change', () => { chooseLight(lightPath.value.trim()); });
  samples.addEventListener('change', () => { if (samples.validity.valid) choose({ samples: samples.valueAsNumber }); });
  for (const name of ['elevation', 'azimuth'] as const) {
    sun[name].addEventListener('input', () => { choose({ sun: { ...object.sun, [name]: sun[name].valueAsNumber } }); });
  }
  turbidity.addEventListener('input', () => { choose({ turbidity: turbidity.valueAsNumber }); });
}

function labelOf(path: HTMLInputElement): HTMLElement {
  return element(`${path.id}Label`);
}

/** A file is chosen once its path is typed. */
function choosePath(select: HTMLSelectElement, path: HTMLInputElement, choose: (name: string) => void): void {
  labelOf(path).hidden = select.value !== file;
  if (select.value !== file) choose(select.value);
  else if (path.value !== '') choose(path.value.trim());
  else path.focus();
}

export function showObject(given: ObjectLook): void {
  object = given;
  showChoice(shape, shapePath, given.shape);
  showChoice(light, lightPath, given.light);
  element('samplesLabel').hidden = given.light === 'directional';
  element('sky').hidden = given.light !== 'sky';
  samples.valueAsNumber = given.samples;
  for (const name of ['elevation', 'azimuth'] as const) sun[name].valueAsNumber = given.sun[name];
  turbidity.valueAsNumber = given.turbidity;
  element('readout').hidden = !isPlain(given);
  keys.textContent = isPlain(given) ? plainHint : 'Drag, arrow keys: turn · with Shift: the directional light · wheel, + −: zoom · double click, 0: reset';
}

function showChoice(select: HTMLSelectElement, path: HTMLInputElement, name: string): void {
  const isOwn = [...select.options].some((option) => option.value === name);
  select.value = isOwn ? name : file;
  labelOf(path).hidden = isOwn;
  if (!isOwn) path.value = name;
}
