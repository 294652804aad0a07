// What the preview's page and the extension tell each other.
import type { BadPixels, Definition, Direction, FirstBadPixel, Light, Look, Parameter, Plot, PlotAngles, PlotKind, Point, Probed, Samples, SceneInput, SceneKeys, SceneView, Surface, Value } from '../protocol';
import type { Memory } from './memory';

export type { BadPixels, Definition, Direction, FirstBadPixel, Light, Look, Memory, Parameter, Plot, PlotAngles, PlotKind, Point, Probed, SceneInput, SceneKeys, SceneView, Surface, Value };

/** What the page asks for beside the curves in the plane of incidence. */
export interface FurtherQuestion extends PlotAngles {
  kind: PlotKind;
}

export interface FurtherPlot {
  question: FurtherQuestion;
  plot: Plot | Surface;
}

export interface Picture {
  version: number;
  source: 'cpu' | 'gpu';
  width: number;
  height: number;
  png: string;
  milliseconds: number;
  badPixels: BadPixels;
  current: boolean;
  samples?: Samples;
}

/** What is kept to be compared with what comes later. */
export interface Pin {
  png: string;
  /** Null where no plots were shown. */
  plot: Plot | null;
  further?: FurtherPlot;
}

export type ToPage =
  | { type: 'document'; uri: string; name: string; version: number; roots: string[]; root: string | null; isScene: boolean }
  | { type: 'scene'; views: SceneView[]; view: string | null; keys: SceneKeys[] }
  | { type: 'version'; version: number }
  | { type: 'look'; look: Look; standard: Look }
  | { type: 'picture'; picture: Picture }
  | { type: 'state'; state: 'good' | 'errors' | 'none'; message: string }
  | { type: 'parameters'; parameters: Parameter[] }
  | { type: 'definitions'; definitions: Definition[]; chosen: string | null }
  | { type: 'probed'; readout: Probed | null }
  | { type: 'plot'; plot: Plot }
  | { type: 'furtherPlot'; further: FurtherPlot }
  | { type: 'badPixel'; pixel: FirstBadPixel }
  | { type: 'pinned'; pin: Pin | null }
  | { type: 'remember'; memory: Memory };

export type FromPage =
  | { type: 'ready' }
  | { type: 'shown' }
  | { type: 'size'; side: number }
  | { type: 'look'; change: Partial<Look> }
  | { type: 'root'; root: string }
  | { type: 'set'; name: string; value: number[] | null }
  | { type: 'write'; name: string; value: number[] }
  | { type: 'reset'; names: string[] }
  | { type: 'reveal'; name: string }
  | { type: 'probe'; point: Point | null }
  | { type: 'definition'; name: string | null }
  | { type: 'plots'; shown: boolean }
  | { type: 'furtherPlot'; question: FurtherQuestion | null }
  | { type: 'saveTable'; table: string; kind: string }
  | { type: 'sceneInput'; input: SceneInput }
  | { type: 'sceneView'; view: string }
  | { type: 'showBad' }
  | { type: 'pin'; pin: Pin | null }
  | { type: 'saveImage' };
