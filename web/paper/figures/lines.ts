import type { MethodOptions } from 'karcher/peers';
import type { LineId, LineNumbers, LineResult } from './types';

export interface LineStyle {
  label: string;
  /** The custom property (paper.css) with the line's color. */
  color: string;
  /** Width in CSS pixels. */
  width: number;
  /** Whether the surface hides the line completely. Otherwise hidden parts are faint. */
  opaque?: boolean;
  /** The method, if any, that traces the line. */
  options?: MethodOptions;
}

/**
 * Colors are the paper's: descent magenta, vector heat blue, weighted averages dark green, its own
 * method red, exact paths black.
 */
export const lineStyles: Record<LineId, LineStyle> = {
  truth: { label: 'Ground truth', color: '--line-exact', width: 1.5 },
  exactPath: { label: 'Exact shortest path', color: '--line-exact', width: 1.5 },
  exactLogs: { label: 'Reference', color: '--line-exact', width: 1.5 },
  spokes: { label: 'Shortest paths', color: '--line-exact', width: 1.5 },
  gradients: {
    label: 'Gradients of the distance',
    color: '--line-descent',
    width: 1.2,
    opaque: true,
  },
  descent: {
    label: 'Piecewise-linear descent',
    color: '--line-descent',
    width: 2.5,
    options: { method: 'descent' },
  },
  vectorHeat: {
    label: 'Vector heat',
    color: '--line-vector-heat',
    width: 2.5,
    options: { method: 'vectorHeat' },
  },
  vectorHeatDelaunay: {
    label: 'Vector heat, Delaunay',
    color: '--line-vector-heat-delaunay',
    width: 2.5,
    options: { method: 'vectorHeat', delaunay: true },
  },
  affineHeat: {
    label: 'Affine heat',
    color: '--line-affine-heat',
    width: 2.5,
    options: { method: 'affineHeat' },
  },
  weightedAverages: {
    label: 'Weighted averages',
    color: '--line-weighted-averages',
    width: 2.5,
    options: { method: 'weightedAverages' },
  },
  bSurf: {
    label: 'b/Surf',
    color: '--line-bsurf',
    width: 2.5,
    options: { method: 'bSurf' },
  },
  paper: {
    label: 'Paper',
    color: '--line-paper',
    width: 2.5,
    options: { method: 'paper', solver: 'exact', seeds: 'authors' },
  },
  paperRing: {
    label: 'Paper, 1-ring',
    color: '--line-paper-ring',
    width: 2,
    options: { method: 'paper', solver: 'exact', seeds: 'authors', star: 'ring' },
  },
  paperOurSeeds: {
    label: 'Paper, our seeds',
    color: '--line-paper-seeds',
    width: 2,
    options: { method: 'paper', solver: 'exact' },
  },
  paperGraph2: {
    label: 'Paper, graph k = 2',
    color: '--line-descent',
    width: 2.5,
    options: { method: 'paper', solver: 'graph', rings: 2, seeds: 'authors' },
  },
  paperGraph6: {
    label: 'Paper, graph k = 6',
    color: '--line-paper-graph',
    width: 2.5,
    options: { method: 'paper', solver: 'graph', rings: 6, seeds: 'authors' },
  },
  karcher: {
    label: 'Karcher, level 0',
    color: '--line-karcher',
    width: 4,
    options: { method: 'karcher', solver: 'fast' },
  },
  karcherExact: {
    label: 'Karcher, level 0, exact distances',
    color: '--line-karcher',
    width: 4,
    options: { method: 'karcher', solver: 'exact' },
  },
  leveled: {
    label: 'Karcher, default',
    color: '--line-levels',
    width: 2.5,
    options: { method: 'leveled' },
  },
  bridged: {
    label: 'Karcher, level 0, bridged',
    color: '--line-bridge',
    width: 2.5,
    options: { method: 'leveled', levels: 0 },
  },
  circleArcs: { label: 'Rational arcs, level 0', color: '--line-karcher', width: 3.5 },
  circleDefault: { label: 'Rational arcs, default', color: '--line-levels', width: 2 },
  isolineLinear: { label: 'Linear isoline', color: '--line-paper', width: 2 },
  isolineExact: { label: 'Exact isoline', color: '--line-exact', width: 2 },
};

/** The method that traces a line of the figures. */
export function methodOf(id: LineId): MethodOptions {
  const { options } = lineStyles[id];
  if (!options) throw new Error(`the line ${id} is by no method`);
  return options;
}

/** Methods with a long preparation or slow samples. They have a worker of their own. */
export const slowLines: ReadonlySet<LineId> = new Set([
  'vectorHeat',
  'vectorHeatDelaunay',
  'affineHeat',
  'weightedAverages',
  'paperGraph2',
  'paperGraph6',
]);

/** A line without its geometry. */
export function numbersOf({
  polylines: _,
  status: __,
  marker: ___,
  ...numbers
}: LineResult): LineNumbers {
  return numbers;
}
