// What the preview's page and the extension tell each other.
import type { BadPixels, Light, Look, Parameter } from '../protocol';

export type { BadPixels, Light, Look, Parameter };

export interface Picture {
  version: number;
  source: 'cpu' | 'gpu';
  width: number;
  height: number;
  png: string;
  milliseconds: number;
  badPixels: BadPixels;
  current: boolean;
}

export type ToPage =
  | { type: 'document'; name: string; version: number; roots: string[]; root: string | null }
  | { type: 'version'; version: number }
  | { type: 'look'; look: Look; standard: Look }
  | { type: 'picture'; picture: Picture }
  | { type: 'state'; state: 'good' | 'errors' | 'none'; message: string }
  | { type: 'parameters'; parameters: Parameter[] };

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
  | { type: 'saveImage' };
