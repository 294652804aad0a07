// What requests about plots carry (docs/lsp.md); protocol.ts names their methods.
import type { Value } from './protocol';

export type PlotKind = 'polar' | 'cartesian' | 'theta-o' | 'theta-h' | 'theta-d' | 'albedo' | 'slice' | 'lobe';

/** Degrees that a plot over half vector and difference angle leaves where they are. */
export interface PlotAngles {
  thetaH?: number;
  thetaD?: number;
  phiD?: number;
}

export interface PlotParams extends PlotAngles {
  preview: number;
  kind: PlotKind;
}

export interface Plot {
  light: { theta: number };
  /** Degrees that the plot is over; of the viewer in the plane of incidence they are positive on the side away from the light. */
  angles: number[];
  /** A list for each channel, one or three; null where a direction is below the surface. */
  values: (Value | null)[][];
  /** Of the albedo: how far values may be off. */
  errors?: (Value | null)[][];
  /** Whether values are times the cosine that the view has. */
  cosine: boolean;
  /** Why there are no values, as where the light is below the surface. */
  problem?: string;
}

/** Values over two angles. */
export interface Surface {
  light: { theta: number; phi?: number };
  /** Degrees: θ_o of a lobe, θ_d of a slice. */
  rows: number[];
  /** Degrees: φ_o of a lobe, θ_h of a slice. */
  columns: number[];
  /** A list for each channel, row by row. */
  values: (Value | null)[][];
  cosine: boolean;
  problem?: string;
}
