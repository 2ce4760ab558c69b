import type { DragMeasures, RulerMeasures } from 'karcher/peers';
import type { MadeSource } from '../../model/meshes';

/** What a figure shows, as data: the page draws it, the report and the tests read its numbers. */

export type Vector = [number, number, number];

/** How a mesh is made. */
export type MeshSpec = MadeSource;

/** What is made of a panel's points. A circle has its center and a point that it passes through. */
export type CurveSpec =
  | { kind: 'center'; weights: number[] }
  | { kind: 'bspline' }
  | { kind: 'bezier' }
  | { kind: 'rational'; weights: number[] }
  | { kind: 'barycentric'; betas: number[] }
  | { kind: 'circle'; arcs: number };

/** What can be drawn, each with a color and a name (lines.ts). */
export type LineId =
  | 'truth'
  | 'exactPath'
  | 'exactLogs'
  | 'spokes'
  | 'descent'
  | 'bSurf'
  | 'gradients'
  | 'vectorHeat'
  | 'vectorHeatDelaunay'
  | 'affineHeat'
  | 'weightedAverages'
  | 'paper'
  | 'paperRing'
  | 'paperOurSeeds'
  | 'paperGraph2'
  | 'paperGraph6'
  | 'karcher'
  | 'karcherExact'
  | 'bridged'
  | 'leveled'
  | 'circleArcs'
  | 'circleDefault'
  | 'isolineLinear'
  | 'isolineExact';

export interface Panel {
  id: string;
  title: string;
  mesh: MeshSpec;
  /** The key of its points in the figure: panels may share them. */
  points: string;
  curve: CurveSpec;
  /** In the order of the legend. */
  lines: readonly LineId[];
  /** Samples a segment. */
  samples: number;
  /** Lines that are not shown, nor computed, until they are asked for. */
  off?: readonly LineId[];
  view?: {
    /** From where the whole is seen. */
    from?: Vector;
    /** The number of a point to look at from near by, and from how far, in diagonals / 2. */
    at?: number;
    distance?: number;
    edges?: boolean;
  };
}

export interface Figure {
  id: string;
  /** The figure of the paper that it reproduces. */
  name: string;
  title: string;
  caption: string;
  /** In space: each panel takes the nearest points of its mesh. */
  points: Record<string, Vector[]>;
  panels: readonly Panel[];
}

/** The numbers of a line; null is what was not measured, or has no meaning for it. */
export interface LineNumbers {
  id: LineId;
  ok: boolean;
  /** Why it failed. */
  reason: string | null;
  prepareMs: number | null;
  traceMs: number | null;
  samples: number | null;
  lost: number | null;
  /** Samples that its own authors would not have accepted either. */
  lostByOwnRule: number | null;
  /** From the reference, in mean edges, and over how many samples: those that are lost are left out. */
  deviation: { median: number; max: number; samples: number } | null;
  turningNoise: number | null;
  /** Where the curve leaps from one sample to the next. */
  breaks: number | null;
  /** The largest angle by which it turns at a sample. */
  sharpestTurn: { degrees: number; t: number } | null;
  /** By exact shortest paths, the same for all methods; it comes after the line. */
  ruler: RulerMeasures | null;
  /** How the curve follows a hand, where that was asked for. */
  drag: DragMeasures | null;
}

export interface LineResult extends LineNumbers {
  /** x, y, z each, on the surface. */
  polylines: Float32Array[];
  /** Per polyline and vertex 1 where the curve is lost; empty where nothing can be. */
  status: Uint8Array[];
  marker: Vector | null;
}
