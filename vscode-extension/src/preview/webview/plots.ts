// The two plots: what is shown of them, the cursor that both share, and the curves of a pinned state.
import type { Plot } from '../messages';
import { element, keep, kept, oncePerFrame, tell } from './host';
import { cartesianFrame, polarFrame } from './plot_frame';
import type { PlotFrame, PlotSize } from './plot_frame';
import { scaleFor } from './plot_scale';
import type { ScaleKind } from './plot_scale';
import { cartesianShapes, curvesOf, polarShapes } from './plot_shapes';
import type { Channel, Curve, Drawing, Shape } from './plot_shapes';
import { plotDescription, quantity, valuesAt } from './plot_words';
import { drawShapes } from './svg';
import { curveTable } from './plot_table';

interface Figure {
  svg: SVGElement;
  kind: string;
  frame: (size: PlotSize) => PlotFrame;
  shapes: (drawing: Drawing, size: PlotSize) => Shape[];
}

const svgOf = (id: string) => document.getElementById(id) as unknown as SVGElement;
const figures: Figure[] = [
  { svg: svgOf('polar'), kind: 'Polar', frame: polarFrame, shapes: polarShapes },
  { svg: svgOf('cartesian'), kind: 'Cartesian', frame: cartesianFrame, shapes: cartesianShapes },
];
const section = element<HTMLDetailsElement>('plots');
const scale = element<HTMLSelectElement>('plotScale');
const cursor = element<HTMLInputElement>('cursor');
const channels: Channel[] = ['red', 'green', 'blue', 'grey'];

let current: Plot | undefined;
let pinned: Plot | undefined;
let root = 'f';

const draw = oncePerFrame(() => { drawAll(); });
/** Only once the extension listens. */
const tellShown = oncePerFrame(() => { tell({ type: 'plots', shown: section.open }); });

export function watchPlots(): void {
  recall();
  tellShown(undefined);
  section.addEventListener('toggle', () => {
    keep({ plots: section.open });
    tellShown(undefined);
    draw(undefined);
  });
  scale.addEventListener('change', () => {
    keep({ scale: scale.value });
    draw(undefined);
  });
  for (const channel of channels) element(channel).addEventListener('change', () => { draw(undefined); });
  element('saveCurve').addEventListener('click', () => {
    if (current !== undefined) tell({ type: 'saveTable', table: curveTable(current, 'theta_o'), kind: 'theta-o' });
  });
  cursor.addEventListener('input', () => { draw(undefined); });
  const resized = new ResizeObserver(() => { draw(undefined); });
  for (const figure of figures) {
    resized.observe(figure.svg);
    figure.svg.addEventListener('pointermove', (event) => { follow(figure, event); });
  }
}

export function showPlot(plot: Plot): void {
  current = plot;
  draw(undefined);
}

export function forgetPlot(): void {
  current = undefined;
  draw(undefined);
}

export function nameRoot(name: string | null): void {
  root = name ?? 'f';
  draw(undefined);
}

export function shownPlot(): Plot | undefined {
  return current;
}

export function showPinnedPlot(plot: Plot | undefined): void {
  pinned = plot;
  draw(undefined);
}

function recall(): void {
  const { plots, scale: chosen } = kept();
  section.open = plots !== false;
  if (chosen === 'log') scale.value = chosen;
}

function follow({ svg, frame }: Figure, event: PointerEvent): void {
  const { left, top } = svg.getBoundingClientRect();
  cursor.valueAsNumber = frame(sizeOf(svg)).angleAt({ x: event.clientX - left, y: event.clientY - top });
  draw(undefined);
}

function drawAll(): void {
  if (!section.open) return;
  element('channels').hidden = [current, pinned].every((plot) => plot === undefined || plot.values.length === 1);
  figures.forEach(drawFigure);
  showValues('cursorValue', current, '');
  cursor.setAttribute('aria-valuetext', element('cursorValue').textContent ?? '');
  showValues('pinnedValue', pinned, 'pinned: ');
}

function drawFigure({ svg, kind, shapes }: Figure): void {
  const size = sizeOf(svg);
  svg.setAttribute('viewBox', `0 0 ${size.width} ${size.height}`);
  svg.setAttribute('aria-label', current === undefined ? `${kind} plot: nothing to draw` : plotDescription(kind, root, current));
  drawShapes(svg, current === undefined ? [] : shapes(drawingOf(current), size));
}

function drawingOf(plot: Plot): Drawing {
  const curves = [...pinned === undefined ? [] : chosenCurves(pinned, true), ...chosenCurves(plot, false)];
  return {
    curves, angles: plot.angles, light: plot.light.theta, cursor: cursor.valueAsNumber,
    scale: scaleFor(scale.value as ScaleKind, curves.flatMap(({ values }) => values)), label: quantity(root, plot),
  };
}

/** Those that the boxes of the channels say; of a real one there is nothing to choose. */
export function chosenCurves(plot: Plot, isPinned: boolean): Curve[] {
  const isChecked = (channel: Channel) => element<HTMLInputElement>(channel).checked;
  return curvesOf(plot, isPinned, (channel) => channel === 'grey' || isChecked(channel), isChecked('grey'));
}

export function chosenScale(): ScaleKind {
  return scale.value as ScaleKind;
}

/** Calls the action when other channels or another scale are chosen. */
export function onChoice(action: () => void): void {
  for (const control of [scale, ...channels.map((channel) => element(channel))]) control.addEventListener('change', action);
}

function showValues(id: string, plot: Plot | undefined, prefix: string): void {
  const angle = cursor.valueAsNumber;
  const output = element<HTMLOutputElement>(id);
  output.textContent = plot === undefined ? '' : prefix + (plot.problem ?? `${angle.toFixed(1).replace('-', '−')}°: ${valuesAt(plot, angle)}`);
  output.hidden = plot === undefined;
}

function sizeOf(svg: SVGElement): PlotSize {
  return { width: svg.clientWidth, height: svg.clientHeight };
}
