// The extensions of the protocol that `texbrdf lsp` speaks (docs/lsp.md). No other file names a method.
import type { Range, WorkspaceEdit } from 'vscode-languageserver-protocol';
import type { OpenSceneParams, OpenSceneResult, SceneInputParams, SceneKeys, UpdateSceneParams } from './scene_protocol';
import type { Plot, PlotParams, Surface } from './plot_protocol';
import type { ObjectLook } from './preview/object_look';

export type * from './plot_protocol';
export type * from './scene_protocol';

export interface Light {
  /** Degrees from the view axis. */
  theta: number;
  /** Degrees around the view axis, from the right. */
  phi: number;
}

/** How a preview looks. */
export interface Look {
  light: Light;
  zoom: number;
  /** Stops. */
  exposure: number;
  gamma: number;
  /** Whether the value is multiplied by N·L. */
  cosine: boolean;
  /** Left out: the sphere in the directional light. */
  object?: ObjectLook;
}

/** Device pixels. */
export interface Size {
  width: number;
  height: number;
}

export const smallestSide = 16;
export const largestSide = 2048;

export interface OpenPreviewParams extends Size, Partial<Look> {
  uri: string;
  view: 'sphere';
  root?: string;
}

export interface OpenPreviewResult {
  preview: number;
  root: string | null;
}

export interface UpdatePreviewParams extends Partial<Size>, Partial<Look> {
  preview: number;
  root?: string;
}

export interface PreviewParams {
  preview: number;
}

export interface BadPixels {
  nan: number;
  infinite: number;
  negative: number;
}

export interface Samples {
  drawn: number;
  all: number;
}

export interface FrameParams extends Size {
  preview: number;
  uri: string;
  version: number;
  source: 'cpu' | 'gpu';
  /** Base64. */
  png: string;
  milliseconds: number;
  badPixels: BadPixels;
  /** False where the document has errors: the picture is the last good one. */
  current: boolean;
  /** Of a scene. */
  view?: string;
  /** Of each pixel, where a picture becomes better with more. */
  samples?: Samples;
}

export interface PreviewStateParams {
  preview: number;
  uri: string;
  version: number;
  state: 'good' | 'errors' | 'none';
  message: string;
  /** Of a scene. */
  keys?: SceneKeys[];
}

export interface RootParams {
  uri: string;
  root?: string;
}

export interface Location {
  uri: string;
  range: Range;
}

export interface Parameter {
  /** Canonical: what requests call it. */
  name: string;
  /** As the document writes it. */
  label: string;
  type: 'real' | 'colour';
  /** One number, or red, green and blue. */
  value: number[];
  low: number;
  high: number;
  /** Of the number, which may stand in another file of the project. */
  location: Location;
}

export interface SetParameterParams {
  preview: number;
  name: string;
  /** Null: the document's value again. */
  value: number[] | null;
}

export interface ParameterEditParams {
  uri: string;
  name: string;
  value: number[];
}

export interface Roots {
  root: string | null;
  candidates: string[];
}

/** A number; as a word where JSON has none. */
export type Value = number | 'nan' | 'inf' | '-inf';

/** What a value of the drawn BRDF is made of: has no arguments. */
export interface Definition {
  /** Canonical: what requests call it. */
  name: string;
  /** As the document writes it. */
  label: string;
  type: 'real' | 'colour' | 'vector';
}

/** Of the picture: 0 to 1, from the top left. */
export interface Point {
  x: number;
  y: number;
}

export interface ProbeParams extends Point {
  preview: number;
  /** Whose value is asked for too. */
  definition?: string;
}

/** Degrees in the tangent frame of a point. */
export interface Direction {
  theta: number;
  phi: number;
}

export interface Probed {
  light: Direction;
  view: Direction;
  /** Null where the point is not lit. */
  value: Value[] | null;
  definition?: { name: string; type: Definition['type']; value: Value[] };
  /** Why there are no values, as where they would have to be waited for. */
  problem?: string;
}

export interface FirstBadPixel extends Point {
  kind: keyof BadPixels;
  definition: string;
  label: string;
  /** Null where the document has it no more. */
  location: Location | null;
}

export interface BadPixelsFound extends BadPixels {
  first: FirstBadPixel | null;
  /** Why the search ended early. */
  problem?: string;
}

export type Target = 'glsl' | 'disney';

export interface EmitParams extends RootParams {
  target: Target;
}

/** A definition with lines of its own in generated code. */
export interface Place extends Location {
  name: string;
  /** The first and the last, counted from 0. */
  lines: [number, number];
}

export interface Emitted {
  text: string | null;
  problem?: string;
  places?: Place[];
}

/** What a request carries and what answers it, by its method. */
export interface Requests {
  'texbrdf/openPreview': [OpenPreviewParams, OpenPreviewResult];
  'texbrdf/openScene': [OpenSceneParams, OpenSceneResult];
  'texbrdf/parameters': [RootParams, Parameter[]];
  'texbrdf/parameterEdit': [ParameterEditParams, WorkspaceEdit];
  'texbrdf/roots': [{ uri: string }, Roots];
  'texbrdf/definitions': [RootParams, Definition[]];
  'texbrdf/probe': [ProbeParams, Probed | null];
  'texbrdf/badPixels': [PreviewParams, BadPixelsFound | null];
  'texbrdf/plot': [PlotParams, Plot | Surface | null];
  'texbrdf/emit': [EmitParams, Emitted | null];
}

/** Notifications to the server. */
export interface Notifications {
  'texbrdf/updatePreview': UpdatePreviewParams;
  'texbrdf/updateScene': UpdateSceneParams;
  'texbrdf/sceneInput': SceneInputParams;
  'texbrdf/closePreview': PreviewParams;
  'texbrdf/frameShown': PreviewParams;
  'texbrdf/setParameter': SetParameterParams;
}

/** Notifications from the server. */
export interface Events {
  'texbrdf/frame': FrameParams;
  'texbrdf/previewState': PreviewStateParams;
}

/** The methods of the server, as functions: the only way to call them. */
export interface Connection {
  request<M extends keyof Requests>(method: M, params: Requests[M][0]): Promise<Requests[M][1]>;
  notify<M extends keyof Notifications>(method: M, params: Notifications[M]): void;
}

export class Api {
  constructor(private readonly connection: Connection) {}

  openPreview = (params: OpenPreviewParams) => this.connection.request('texbrdf/openPreview', params);
  openScene = (params: OpenSceneParams) => this.connection.request('texbrdf/openScene', params);
  parameters = (params: RootParams) => this.connection.request('texbrdf/parameters', params);
  parameterEdit = (params: ParameterEditParams) => this.connection.request('texbrdf/parameterEdit', params);
  roots = (uri: string) => this.connection.request('texbrdf/roots', { uri });
  definitions = (params: RootParams) => this.connection.request('texbrdf/definitions', params);
  probe = (params: ProbeParams) => this.connection.request('texbrdf/probe', params);
  badPixels = (preview: number) => this.connection.request('texbrdf/badPixels', { preview });
  plot = (params: PlotParams) => this.connection.request('texbrdf/plot', params);
  emit = (params: EmitParams) => this.connection.request('texbrdf/emit', params);

  updatePreview = (params: UpdatePreviewParams) => { this.connection.notify('texbrdf/updatePreview', params); };
  updateScene = (params: UpdateSceneParams) => { this.connection.notify('texbrdf/updateScene', params); };
  sceneInput = (params: SceneInputParams) => { this.connection.notify('texbrdf/sceneInput', params); };
  closePreview = (preview: number) => { this.connection.notify('texbrdf/closePreview', { preview }); };
  frameShown = (preview: number) => { this.connection.notify('texbrdf/frameShown', { preview }); };
  setParameter = (params: SetParameterParams) => { this.connection.notify('texbrdf/setParameter', params); };
}

export const frameEvent: keyof Events = 'texbrdf/frame';
export const stateEvent: keyof Events = 'texbrdf/previewState';

/** `capabilities.experimental.texbrdf` of the server. */
export interface ServerCapabilities {
  preview?: boolean;
}

/** `capabilities.experimental.texbrdf` of this client: what code lenses may run, and is therefore no free choice. */
export const lensCommands = { preview: 'texbrdf.preview', showReferences: 'texbrdf.showReferences' } as const;
