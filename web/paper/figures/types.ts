import type { DragMeasures, RulerMeasures } from 'karcher/peers';
import type { MadeSource } from '../../model/meshes';

/** A figure's content as data: the page draws it, the report and the tests read its numbers. */

export type Vector = [number, number, number];

/** The source of a mesh. */
export type MeshSpec = MadeSource;

/** The curve of a panel's points. A circle has its center and a point that it passes through. */
export type CurveSpec =
  | { kind: 'center'; weights: number[] }
  | { kind: 'bspline' }
  | { kind: 'bezier' }
  | { kind: 'rational'; weights: number[] }
  | { kind: 'barycentric'; betas: number[] }
  | { kind: 'circle'; arcs: number };

/** The lines of the figures, each with a color and a name (lines.ts). */
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
  /** The key of the panel's points in the figure. Panels with the same key share their points. */
  points: string;
  curve: CurveSpec;
  /** The lines, in the order of the legend. */
  lines: readonly LineId[];
  /** The number of samples a segment. */
  samples: number;
  /** Lines that the panel computes only when the reader shows them. */
  off?: readonly LineId[];
  view?: {
    /** The direction to the camera for the whole surface. */
    from?: Vector;
    /**
     * The index of a point for a close view, and the camera's distance from it, in half diagonals.
     */
    at?: number;
    distance?: number;
    edges?: boolean;
  };
}

export interface Figure {
  id: string;
  /** The name of the paper's figure. */
  name: string;
  title: string;
  caption: string;
  /** Places in space; each panel takes the nearest points of its mesh. */
  points: Record<string, Vector[]>;
  panels: readonly Panel[];
}

/** The numbers of a line. A number is null if it is missing or has no meaning for the line. */
export interface LineNumbers {
  id: LineId;
  ok: boolean;
  /** The reason why the method failed or why numbers are missing; null if neither is the case. */
  reason: string | null;
  prepareMs: number | null;
  traceMs: number | null;
  samples: number | null;
  lost: number | null;
  /** The number of samples that the method's own authors would reject, too. */
  lostByOwnRule: number | null;
  /** The distances from the reference in mean edges, over `samples` samples that are not lost. */
  deviation: { median: number; max: number; samples: number } | null;
  turningNoise: number | null;
  /** The number of samples at which the curve leaps. */
  breaks: number | null;
  /** The largest angle by which the curve turns at a sample. */
  sharpestTurn: { degrees: number; t: number } | null;
  /**
   * Measurements of the line by exact shortest paths, in the same way for all methods. They arrive
   * after the line.
   */
  ruler: RulerMeasures | null;
  /** The behaviour of the curve in a drag; null without a measurement. */
  drag: DragMeasures | null;
}

export interface LineResult extends LineNumbers {
  /** Polylines on the surface, with x, y, z of each vertex. */
  polylines: Float32Array[];
  /**
   * A status for each vertex of each polyline: 1 where the curve is lost. Empty if the line has no
   * lost parts.
   */
  status: Uint8Array[];
  marker: Vector | null;
}
