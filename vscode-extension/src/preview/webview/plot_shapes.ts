// What a plot is drawn of: grid, labels, light, curves, cursor.
import type { Plot, Point, Value } from '../messages';
import { cartesianFrame, polarFrame, viewerAxis } from './plot_frame';
import type { AngleAxis, PlotFrame, PlotSize } from './plot_frame';
import { fractionOf, tickText, withoutNegative } from './plot_scale';
import type { Scale } from './plot_scale';

export type Channel = 'red' | 'green' | 'blue' | 'grey';

export interface Curve {
  channel: Channel;
  isPinned: boolean;
  values: readonly (Value | null)[];
  errors?: readonly (Value | null)[];
}

export interface Drawing {
  curves: readonly Curve[];
  angles: readonly number[];
  /** The light's angle from the normal; it is not shown where the plot is over another angle. */
  light?: number;
  cursor: number;
  scale: Scale;
  /** What the values are. */
  label: string;
}

export interface Shape {
  tag: 'path' | 'circle' | 'text';
  className: string;
  attributes: Record<string, number | string>;
  text?: string;
}

const letterWidth = 6; // of labels, at most

export function curvesOf(plot: Plot, isPinned: boolean, isShown: (channel: Channel) => boolean, hasLuminance = false): Curve[] {
  const { values, errors } = plot;
  const channels: Channel[] = values.length === 1 ? ['grey'] : ['red', 'green', 'blue'];
  const curves = channels.flatMap((channel, index): Curve[] => {
    const bounds = errors?.[index];
    return isShown(channel) ? [{ channel, isPinned, values: values[index] ?? [], ...bounds === undefined ? {} : { errors: bounds } }] : [];
  });
  return hasLuminance && values.length === 3 ? [...curves, { channel: 'grey', isPinned, values: luminances(values) }] : curves;
}

/** Of linear sRGB (ITU-R BT.709). */
export function luminances(values: readonly (readonly (Value | null)[])[]): (Value | null)[] {
  const [red = [], green = [], blue = []] = values;
  return red.map((r, index) => {
    const [g, b] = [green[index] ?? null, blue[index] ?? null];
    if (r === null || g === null || b === null) return null;
    return typeof r === 'number' && typeof g === 'number' && typeof b === 'number' ? 0.2126 * r + 0.7152 * g + 0.0722 * b : 'nan';
  });
}

export function cartesianShapes(drawing: Drawing, size: PlotSize, axis: AngleAxis = viewerAxis): Shape[] {
  const frame = cartesianFrame(size, axis);
  const { left, right, top, bottom } = frame;
  const grid = drawing.scale.ticks.flatMap((tick) => {
    const { y } = frame.at(axis.low, fractionOf(drawing.scale, tick) ?? 0);
    return [path('grid', `M${left} ${y}H${right}`), label(left - 4, y + 3, 'end', tickText(drawing.scale, tick))];
  });
  const angles = axis.ticks.flatMap((angle) => {
    const { x } = frame.at(angle, 0);
    return [path('axis', `M${x} ${bottom}v4`), label(x, bottom + 14, 'middle', angleText(angle))];
  });
  return [
    ...grid, ...angles, path('axis', `M${left} ${top}V${bottom}H${right}`),
    label((left + right) / 2, bottom + 26, 'middle', axis.label), label(left, top - 8, 'start', drawing.label),
    ...content(drawing, frame),
  ];
}

export function polarShapes(given: Drawing, size: PlotSize): Shape[] {
  const drawing = { ...given, scale: withoutNegative(given.scale) };
  const frame = polarFrame(size);
  const { centre, radius } = frame;
  const rings = ringsOf(drawing.scale, radius).flatMap(({ r, text }) => [
    path('grid', `M${centre.x - r} ${centre.y}A${r} ${r} 0 0 1 ${centre.x + r} ${centre.y}`),
    ...text === undefined ? [] : [label(centre.x + r, centre.y + 13, 'middle', text)],
  ]);
  const spokes = viewerAxis.ticks.flatMap((angle) => {
    const [end, beyond] = [frame.at(angle, 1), frame.at(angle, 1 + 10 / radius)];
    const anchor = angle === 0 ? 'middle' : angle < 0 ? 'end' : 'start';
    return [path('grid', `M${centre.x} ${centre.y}L${end.x} ${end.y}`), label(beyond.x, beyond.y + 3, anchor, angleText(angle))];
  });
  return [
    ...rings, ...spokes, path('axis', `M${centre.x - radius} ${centre.y}H${centre.x + radius}`),
    label(centre.x, centre.y + 26, 'middle', `${drawing.label} over θₒ`),
    ...content(drawing, frame),
  ];
}

/** From the outermost inwards; those that are too close to it have no label. */
function ringsOf(scale: Scale, radius: number): { r: number; text?: string }[] {
  let free = Infinity;
  return [...scale.ticks].reverse().flatMap((tick) => {
    const r = (fractionOf(scale, tick) ?? 0) * radius;
    if (r === 0) return [];
    const text = tickText(scale, tick);
    const half = text.length * letterWidth / 2;
    if (r + half > free) return [{ r }];
    free = r - half - letterWidth;
    return [{ r, text }];
  });
}

/** Through the points that are there; a gap where one is not. One that stands alone is a dot. */
export function pathThrough(points: readonly (Point | undefined)[]): string {
  return points.map((point, index) => {
    if (point === undefined) return '';
    const place = `${rounded(point.x)} ${rounded(point.y)}`;
    return points[index - 1] === undefined ? `M${place}L${place}` : `L${place}`;
  }).join('');
}

/** The sample that is nearest to an angle. */
export function sampleAt(angles: readonly number[], angle: number): number {
  return angles.reduce((best, candidate, index) => Math.abs(candidate - angle) < Math.abs((angles[best] ?? Infinity) - angle) ? index : best, 0);
}

function content(drawing: Drawing, frame: PlotFrame): Shape[] {
  const { angles, curves, scale } = drawing;
  const place = (values: readonly (Value | null)[], index: number) => {
    const fraction = fractionOf(scale, values[index] ?? 'nan');
    return fraction === undefined ? undefined : frame.at(angles[index] ?? 0, fraction);
  };
  const cursor = sampleAt(angles, drawing.cursor);
  const lines = curves.map(({ channel, isPinned, values }) =>
    path(`curve ${channel}${isPinned ? ' pinned' : ''}`, pathThrough(angles.map((_, index) => place(values, index)))));
  const dots = curves.flatMap(({ channel, values }) => {
    const at = place(values, cursor);
    return at === undefined ? [] : [circle(`dot ${channel}`, at, 2.5)];
  });
  const bands = curves.map((curve) => band(curve, drawing, frame));
  return [...lightShapes(drawing.light, frame), ...bands.flat(), ...lines, missing(drawing, frame), ray('cursor', drawing.cursor, frame), ...dots];
}

/** Between what each value may be at least and at most. */
function band({ channel, values, errors }: Curve, { angles, scale }: Drawing, frame: PlotFrame): Shape[] {
  if (errors === undefined) return [];
  const edge = (sign: number) => angles.flatMap((angle, index) => {
    const [value, error] = [values[index], errors[index]];
    if (typeof value !== 'number' || typeof error !== 'number') return [];
    return [frame.at(angle, fractionOf(scale, value + sign * error) ?? 0)];
  });
  const outline = [...edge(1), ...edge(-1).reverse()];
  return outline.length === 0 ? [] : [path(`band ${channel}`, `${pathThrough(outline)}Z`)];
}

/** At the far edge, over the angles where a value is no number. */
function missing({ angles, curves }: Drawing, frame: PlotFrame): Shape {
  const isMissing = (index: number) => curves.some(({ isPinned, values }) => !isPinned && typeof values[index] === 'string');
  const line = path('missing', pathThrough(angles.map((angle, index) => isMissing(index) ? frame.at(angle, 1) : undefined)));
  return { ...line, text: 'not a number, or infinite' };
}

/** The light comes from the negative side; from below the surface there is none. */
function lightShapes(theta: number | undefined, frame: PlotFrame): Shape[] {
  return theta === undefined || theta > 90 ? [] : [ray('light', -theta, frame), { ...circle('lamp', frame.at(-theta, 1), 4), text: 'light' }];
}

function ray(className: string, angle: number, frame: PlotFrame): Shape {
  return path(className, pathThrough([frame.at(angle, 0), frame.at(angle, 1)]));
}

function path(className: string, d: string): Shape {
  return { tag: 'path', className, attributes: { d } };
}

function circle(className: string, { x, y }: Point, r: number): Shape {
  return { tag: 'circle', className, attributes: { cx: rounded(x), cy: rounded(y), r } };
}

function label(x: number, y: number, anchor: string, text: string): Shape {
  return { tag: 'text', className: 'label', attributes: { x: rounded(x), y: rounded(y), 'text-anchor': anchor }, text };
}

function rounded(coordinate: number): number {
  return Math.round(coordinate * 100) / 100;
}

function angleText(angle: number): string {
  return `${angle}°`.replace('-', '−');
}
