// Lobes onto a canvas, in the colours of the page: with WebGL, and where there is none, the faces from behind to the front.
import type { Point, Surface, Value } from '../messages';
import { coloursOf, partsOf, prepare, rgb, write } from './canvas';
import type { Colours } from './canvas';
import { direction, facesOf, projection } from './lobe';
import type { Eye, Face, Projection, Vector } from './lobe';
import { axisTriangles, lobeTriangles } from './lobe_mesh';
import type { Paint } from './lobe_mesh';
import { fractionOf, scaleFor, tickText, withoutNegative } from './plot_scale';
import type { Scale, ScaleKind } from './plot_scale';
import { paintTriangles } from './triangles_gl';

const pinnedOpacity = 0.12;
const axisLength = 1.05;

export interface LobePicture {
  surface: Surface;
  numbers: readonly (Value | null)[];
  earlier: Surface | undefined;
  earlierNumbers: readonly (Value | null)[];
  eye: Eye;
  scaleKind: ScaleKind;
  label: string;
}

/** Returns what is drawn of the surface, from behind to the front. */
export function drawLobe(canvas: HTMLCanvasElement, picture: LobePicture): Face[] {
  const context = prepare(canvas);
  if (context === null) return [];
  const { surface, numbers, earlier, earlierNumbers, eye, label } = picture;
  const colours = coloursOf(canvas);
  const scale = withoutNegative(scaleFor(picture.scaleKind, [...numbers, ...earlierNumbers]));
  const view = projection(eye, surface.light.phi ?? 0, { width: canvas.clientWidth, height: canvas.clientHeight });
  drawGround(context, view, scale, colours);
  const axes = axesOf(surface, colours);
  const lobe = { surface, numbers, isPinned: false };
  const pinned = earlier === undefined ? [] : [{ surface: earlier, numbers: earlierNumbers, isPinned: true }];
  const faces = facesOf([lobe, ...pinned], scale, view);
  const painted = paintTriangles({
    opaque: [...lobeTriangles(lobe, scale, view, paintOf(colours.surface)), ...axes.flatMap((axis) => axisPart(axis, view))],
    translucent: pinned.flatMap((other) => lobeTriangles(other, scale, view, paintOf(partsOf(colours.text), pinnedOpacity))),
    lamp: view.lamp,
  }, canvas);
  canvas.dataset.painter = painted === undefined ? 'canvas' : 'webgl';
  if (painted === undefined) {
    for (const axis of axes) drawAxis(context, view, axis);
    for (const face of faces) drawFace(context, face, colours);
  } else {
    context.drawImage(painted, 0, 0, canvas.clientWidth, canvas.clientHeight);
  }
  for (const { way, name } of axes) write(context, name, view.at(way, 1.12), colours, 'center');
  write(context, label, { x: 4, y: 12 }, colours, 'left');
  return faces;
}

/** A line from the origin. */
interface Axis {
  way: Vector;
  name: string;
  colour: string;
}

function axesOf({ light }: Surface, { text, light: lightColour }: Colours): Axis[] {
  const frame = [[90, 0, 'X'], [90, 90, 'Y'], [0, 0, 'n']] as const;
  const axes = frame.map(([theta, phi, name]) => ({ way: direction(theta, phi), name, colour: text }));
  return [...axes, { way: direction(light.theta, light.phi ?? 0), name: 'ωᵢ', colour: lightColour }];
}

function axisPart({ way, colour }: Axis, view: Projection): number[] {
  return axisTriangles({ end: way, length: axisLength, paint: paintOf(partsOf(colour)), width: 1.5 }, view);
}

function drawAxis(context: CanvasRenderingContext2D, view: Projection, { way, colour }: Axis): void {
  outline(context, [view.at(way, 0), view.at(way, axisLength)]);
  context.strokeStyle = colour;
  context.stroke();
}

function paintOf([red, green, blue]: readonly [number, number, number], opacity = 1): Paint {
  return [red / 255, green / 255, blue / 255, opacity];
}

function drawGround(context: CanvasRenderingContext2D, view: Projection, scale: Scale, colours: Colours): void {
  for (const radius of [1, ...scale.ticks.map((tick) => fractionOf(scale, tick) ?? 0)]) {
    if (radius <= 0) continue;
    outline(context, Array.from({ length: 91 }, (_, i) => view.at(direction(90, 4 * i), radius)));
    context.globalAlpha = radius === 1 ? 0.7 : 0.35;
    context.strokeStyle = colours.grid;
    context.stroke();
    context.globalAlpha = 1;
  }
  const along = direction(90, 45);
  for (const tick of scale.ticks) {
    const radius = fractionOf(scale, tick) ?? 0;
    if (radius > 0) write(context, tickText(scale, tick), view.at(along, radius), colours, 'center');
  }
}

function drawFace(context: CanvasRenderingContext2D, { points, light, isPinned }: Face, { surface, text }: Colours): void {
  outline(context, points);
  context.closePath();
  if (isPinned) {
    context.globalAlpha = pinnedOpacity;
    context.fillStyle = text;
    context.fill();
    context.globalAlpha = 1;
    return;
  }
  const shade = rgb([surface[0] * light, surface[1] * light, surface[2] * light]);
  context.fillStyle = shade;
  context.fill();
  context.strokeStyle = shade;
  context.lineWidth = 0.5;
  context.stroke();
  context.lineWidth = 1;
}

function outline(context: CanvasRenderingContext2D, points: readonly Point[]): void {
  context.beginPath();
  points.forEach(({ x, y }, index) => {
    if (index === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
}

