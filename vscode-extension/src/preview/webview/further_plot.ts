// The plot beside the curves in the plane of incidence: which one is chosen, and what is told of it under the pointer.
import type { FurtherPlot, FurtherQuestion, Plot, PlotKind, Point, Surface, Value } from '../messages';
import { element, keep, kept, oncePerFrame, tell } from './host';
import { clamped } from './numbers';
import { cartesianFrame, quarterAxis } from './plot_frame';
import type { AngleAxis } from './plot_frame';
import { scaleFor } from './plot_scale';
import { cartesianShapes, luminances, sampleAt } from './plot_shapes';
import { curveTable, surfaceTable } from './plot_table';
import { valuesAt } from './plot_words';
import { chosenCurves, chosenScale, onChoice } from './plots';
import { valueText } from './readout_words';
import { prepare } from './canvas';
import { drawLobe } from './lobe_canvas';
import { drawSlice } from './slice_canvas';
import { sampleUnder } from './lobe';
import type { Eye, Face } from './lobe';
import { cellUnder, sliceFrame } from './slice';
import { drawShapes } from './svg';

interface Kind {
  /** How the angles are told; the first goes down the table. */
  angles: [string, string?];
  /** The angle that stays where it is, and its name. */
  fixed?: 'thetaH' | 'thetaD';
  hasPhi?: boolean;
  label: string;
  columns: [string, string?];
}

const kinds: Partial<Record<PlotKind, Kind>> = {
  'theta-h': { angles: ['θ_h'], columns: ['theta_h'], fixed: 'thetaD', hasPhi: true, label: 'f' },
  'theta-d': { angles: ['θ_d'], columns: ['theta_d'], fixed: 'thetaH', hasPhi: true, label: 'f' },
  'albedo': { angles: ['θᵢ'], columns: ['theta_i'], label: 'ρ' },
  'slice': { angles: ['θ_d', 'θ_h'], columns: ['theta_d', 'theta_h'], hasPhi: true, label: 'f' },
  'lobe': { angles: ['θₒ', 'φₒ'], columns: ['theta_o', 'phi_o'], label: 'f' },
};
const fixedNames = { thetaH: 'θ_h', thetaD: 'θ_d' };

const choice = element<HTMLSelectElement>('furtherKind');
const fixedAngle = element<HTMLInputElement>('furtherFixed');
const phi = element<HTMLInputElement>('furtherPhi');
const channel = element<HTMLSelectElement>('furtherChannel');
const curve = document.getElementById('furtherCurve') as unknown as SVGElement;
const canvas = element<HTMLCanvasElement>('furtherSurface');
const section = element<HTMLDetailsElement>('plots');

let current: FurtherPlot | undefined;
let pinned: FurtherPlot | undefined;
let pointer: Point | undefined;
let cursor = 45;
let faces: Face[] = [];
const eye: Eye = { azimuth: 65, elevation: 25 };

const draw = oncePerFrame(() => { drawAll(); });
/** Only once the extension listens. */
const ask = oncePerFrame(() => { tell({ type: 'furtherPlot', question: section.open ? question() ?? null : null }); });

export function watchFurther(): void {
  const { further } = kept();
  if (typeof further === 'string' && further in kinds) choice.value = further;
  choice.addEventListener('change', () => {
    keep({ further: choice.value });
    current = undefined;
    changed();
  });
  for (const input of [fixedAngle, phi]) input.addEventListener('change', changed);
  section.addEventListener('toggle', changed);
  channel.addEventListener('change', () => { draw(undefined); });
  onChoice(() => { draw(undefined); });
  element('saveFurther').addEventListener('click', save);
  const resized = new ResizeObserver(() => { draw(undefined); });
  for (const figure of [curve, canvas]) resized.observe(figure);
  curve.addEventListener('pointermove', followCurve);
  watchSurface();
  changed();
}

export function showFurther(further: FurtherPlot): void {
  if (further.question.kind !== choice.value) return;
  current = further;
  draw(undefined);
}

export function forgetFurther(): void {
  current = undefined;
  draw(undefined);
}

export function shownFurther(): FurtherPlot | undefined {
  return current;
}

export function showPinnedFurther(further: FurtherPlot | undefined): void {
  pinned = further;
  draw(undefined);
}

function question(): FurtherQuestion | undefined {
  const kind = kinds[choice.value as PlotKind];
  if (kind === undefined) return undefined;
  return {
    kind: choice.value as PlotKind,
    ...kind.fixed === undefined ? {} : { [kind.fixed]: clamped(numberIn(fixedAngle, 0), 0, 90) },
    ...kind.hasPhi === true ? { phiD: clamped(numberIn(phi, 90), -180, 180) } : {},
  };
}

function numberIn(input: HTMLInputElement, otherwise: number): number {
  return Number.isFinite(input.valueAsNumber) ? input.valueAsNumber : otherwise;
}

function changed(): void {
  const kind = kinds[choice.value as PlotKind];
  element('furtherFixedLabel').hidden = kind?.fixed === undefined;
  if (kind?.fixed !== undefined) element('furtherFixedName').textContent = fixedNames[kind.fixed];
  element('furtherPhiLabel').hidden = kind?.hasPhi !== true;
  element('saveFurther').hidden = kind === undefined;
  curve.toggleAttribute('hidden', kind === undefined || kind.angles.length === 2);
  canvas.hidden = kind === undefined || kind.angles.length === 1;
  element('furtherValue').hidden = kind === undefined;
  element('furtherPinned').hidden = true;
  ask(undefined);
  draw(undefined);
}

function watchSurface(): void {
  let from: Point | undefined;
  canvas.addEventListener('pointerdown', (event) => {
    from = placeOf(event, canvas);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointerup', () => { from = undefined; });
  canvas.addEventListener('pointermove', (event) => {
    const place = placeOf(event, canvas);
    if (from !== undefined) turn((from.x - place.x) / 2, (place.y - from.y) / 2);
    if (from !== undefined) from = place;
    pointer = place;
    draw(undefined);
  });
  canvas.addEventListener('pointerleave', () => {
    pointer = undefined;
    draw(undefined);
  });
  canvas.addEventListener('keydown', ({ key }) => {
    const step = 5;
    if (key === 'ArrowLeft' || key === 'ArrowRight') turn(key === 'ArrowLeft' ? step : -step, 0);
    if (key === 'ArrowUp' || key === 'ArrowDown') turn(0, key === 'ArrowUp' ? step : -step);
  });
}

function turn(azimuth: number, elevation: number): void {
  eye.azimuth = (eye.azimuth + azimuth) % 360;
  eye.elevation = clamped(eye.elevation + elevation, 0, 90);
  draw(undefined);
}

function placeOf(event: PointerEvent, figure: Element): Point {
  const { left, top } = figure.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

function followCurve(event: PointerEvent): void {
  cursor = cartesianFrame(sizeOf(curve), axisOf(choice.value as PlotKind)).angleAt(placeOf(event, curve));
  draw(undefined);
}

function axisOf(kind: PlotKind): AngleAxis {
  return quarterAxis(kinds[kind]?.angles[0] ?? '');
}

function sizeOf({ clientWidth, clientHeight }: Element): { width: number; height: number } {
  return { width: clientWidth, height: clientHeight };
}

function isSurface(plot: Plot | Surface): plot is Surface {
  return 'rows' in plot;
}

/** What is pinned is shown where it is of the same kind. */
function pinnedPlot(): Plot | Surface | undefined {
  return pinned?.question.kind === current?.question.kind ? pinned?.plot : undefined;
}

function drawAll(): void {
  if (!section.open) return;
  const output = element<HTMLOutputElement>('furtherValue');
  element('furtherChannelLabel').hidden = current === undefined || !isSurface(current.plot) || current.plot.values.length === 1;
  if (current === undefined) {
    drawShapes(curve, []);
    prepare(canvas);
    output.textContent = '';
    return;
  }
  const { plot, question: { kind } } = current;
  if (isSurface(plot)) drawSurface(plot, kind, output);
  else drawCurve(plot, kind, output);
  if (plot.problem !== undefined) output.textContent = plot.problem;
}

function quantityOf(plot: Plot | Surface, kind: PlotKind): string {
  const cosine = kind === 'lobe' ? 'cos θₒ' : 'cos θᵢ';
  return `${kinds[kind]?.label ?? 'f'}${plot.cosine ? ` · ${cosine}` : ''}`;
}

function drawCurve(plot: Plot, kind: PlotKind, output: HTMLOutputElement): void {
  const before = pinnedPlot();
  const earlier = before === undefined || isSurface(before) ? undefined : before;
  const curves = [...earlier === undefined ? [] : chosenCurves(earlier, true), ...chosenCurves(plot, false)];
  const size = sizeOf(curve);
  curve.setAttribute('viewBox', `0 0 ${size.width} ${size.height}`);
  curve.setAttribute('aria-label', `${quantityOf(plot, kind)} over ${kinds[kind]?.angles[0] ?? ''}`);
  const scale = scaleFor(chosenScale(), curves.flatMap(({ values }) => values));
  drawShapes(curve, cartesianShapes({ curves, angles: plot.angles, cursor, scale, label: quantityOf(plot, kind) }, size, axisOf(kind)));
  output.textContent = `${cursor.toFixed(1)}°: ${valuesAt(plot, cursor)}${errorText(plot)}`;
  const other = element<HTMLOutputElement>('furtherPinned');
  other.hidden = earlier === undefined;
  other.textContent = earlier === undefined ? '' : `pinned: ${valuesAt(earlier, cursor)}`;
}

function errorText({ angles, errors }: Plot): string {
  const index = sampleAt(angles, cursor);
  const largest = (errors ?? []).reduce((most, list) => Math.max(most, Number(list[index] ?? 0)), 0);
  return errors === undefined ? '' : ` ± ${valueText(Number(largest.toPrecision(2)))}`;
}

function drawSurface(surface: Surface, kind: PlotKind, output: HTMLOutputElement): void {
  const before = pinnedPlot();
  const earlier = before !== undefined && isSurface(before) ? before : undefined;
  const label = quantityOf(surface, kind);
  canvas.setAttribute('aria-label', kind === 'lobe' ? `Lobe of ${label}; arrow keys turn it` : `Slice of ${label}`);
  const numbers = numbersOf(surface);
  let sample: number | undefined;
  if (kind === 'lobe') {
    faces = drawLobe(canvas, { surface, numbers, earlier, earlierNumbers: earlier === undefined ? [] : numbersOf(earlier), eye, scaleKind: chosenScale(), label });
    sample = pointer === undefined ? undefined : sampleUnder(faces, pointer);
  } else {
    drawSlice(canvas, { surface, numbers, scaleKind: chosenScale(), label });
    sample = pointer === undefined ? undefined : cellUnder(surface, sliceFrame(sizeOf(canvas)), pointer);
  }
  output.textContent = sample === undefined ? '' : wordsAt(surface, kind, sample);
  const other = element<HTMLOutputElement>('furtherPinned');
  const isSame = earlier !== undefined && sample !== undefined && earlier.values[0]?.length === surface.values[0]?.length;
  other.hidden = !isSame;
  other.textContent = isSame && earlier !== undefined && sample !== undefined ? `pinned: ${wordsAt(earlier, kind, sample)}` : '';
}

/** One number for each sample: of a colour the one that is chosen. */
function numbersOf({ values }: Surface): (Value | null)[] {
  const [red = [], green = [], blue = []] = values;
  if (values.length === 1) return red;
  const channels: Record<string, (Value | null)[]> = { red, green, blue };
  return channels[channel.value] ?? luminances(values);
}

function wordsAt({ rows, columns, values }: Surface, kind: PlotKind, sample: number): string {
  const [down = '', across = ''] = kinds[kind]?.angles ?? [];
  const row = rows[Math.floor(sample / columns.length)] ?? 0;
  const column = columns[sample % columns.length] ?? 0;
  const at = { angles: [0], values: values.map((list) => [list[sample] ?? null]), light: { theta: 0 }, cosine: false };
  return `${down} ${row.toFixed(1)}°, ${across} ${column.toFixed(1)}°: ${valuesAt(at, 0)}`;
}

function save(): void {
  if (current === undefined) return;
  const { plot, question: { kind } } = current;
  const [first = '', second = ''] = kinds[kind]?.columns ?? [];
  tell({ type: 'saveTable', table: isSurface(plot) ? surfaceTable(plot, [first, second]) : curveTable(plot, first), kind });
}
