// Triangles with WebGL: with a depth for each pixel, so that what goes through another is cut where it does.
import { ambient } from './lobe';
import type { Vector } from './lobe';
import { vertexFloats } from './lobe_mesh';

const vertexShader = `#version 300 es
uniform vec2 size;
in vec3 place;
in vec3 normal;
in vec4 paint;
out vec3 way;
out vec4 colour;
void main() {
  gl_Position = vec4(place.xy / size * vec2(2.0, -2.0) + vec2(-1.0, 1.0), place.z / -1.5, 1.0);
  way = normal;
  colour = paint;
}`;

const fragmentShader = `#version 300 es
precision highp float;
uniform vec3 lamp;
in vec3 way;
in vec4 colour;
out vec4 seen;
void main() {
  float light = way == vec3(0.0) ? 1.0 : mix(abs(dot(normalize(way), normalize(lamp))), 1.0, ${ambient});
  seen = vec4(colour.rgb * light * colour.a, colour.a);
}`;

export interface Triangles {
  /** Lists of vertices, as lobe_mesh.ts has them. What is translucent hides nothing. */
  opaque: readonly number[];
  translucent: readonly number[];
  lamp: Vector;
}

interface Painter {
  canvas: HTMLCanvasElement;
  gl: WebGL2RenderingContext;
  program: WebGLProgram;
}

let painter: Painter | undefined;

/** Of the size of the other canvas, transparent where there is nothing; or nothing where there is no WebGL. */
export function paintTriangles(triangles: Triangles, { width, height, clientWidth, clientHeight }: HTMLCanvasElement): HTMLCanvasElement | undefined {
  if (painter?.gl.isContextLost() === true) painter = undefined;
  painter ??= newPainter();
  if (painter === undefined) return undefined;
  const { canvas, gl, program } = painter;
  [canvas.width, canvas.height] = [width, height];
  gl.viewport(0, 0, width, height);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.useProgram(program);
  gl.uniform2f(gl.getUniformLocation(program, 'size'), clientWidth, clientHeight);
  gl.uniform3f(gl.getUniformLocation(program, 'lamp'), ...triangles.lamp);
  gl.depthMask(true);
  paint(painter, triangles.opaque);
  gl.depthMask(false);
  paint(painter, triangles.translucent);
  gl.depthMask(true);
  return gl.isContextLost() ? undefined : canvas;
}

function paint({ gl }: Painter, vertices: readonly number[]): void {
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(vertices), gl.STREAM_DRAW);
  gl.drawArrays(gl.TRIANGLES, 0, vertices.length / vertexFloats);
}

function newPainter(): Painter | undefined {
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { antialias: true, premultipliedAlpha: true, preserveDrawingBuffer: true });
  const program = gl === null ? undefined : link(gl);
  if (gl === null || program === undefined) return undefined;
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  let offset = 0;
  for (const [name, floats] of [['place', 3], ['normal', 3], ['paint', 4]] as const) {
    const at = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, floats, gl.FLOAT, false, 4 * vertexFloats, 4 * offset);
    offset += floats;
  }
  return { canvas, gl, program };
}

function link(gl: WebGL2RenderingContext): WebGLProgram | undefined {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]] as const) {
    const shader = gl.createShader(kind);
    if (shader === null) return undefined;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return gl.getProgramParameter(program, gl.LINK_STATUS) === true ? program : undefined;
}
