import { onTorus } from './surfaces';
import type { Figure, LineId, Vector } from './types';

const weights = [0.47, 0.3, 0.08, 0.15];
const methods: LineId[] = ['vectorHeat', 'affineHeat', 'weightedAverages', 'paper', 'karcher'];

export const meanFigure: Figure = {
  id: 'means',
  name: 'Figure 1',
  title: 'The center of mass of four points',
  caption:
    'Four points with the weights 0.47, 0.30, 0.08 and 0.15, and their center of mass, joined to them by shortest paths. Beside it is the plane, where the center of mass is the affine average. Deviations are measured from our center of mass with exact distances, and on the plane from the average itself. Below each picture stands whether the center is the only one; other minima are empty dots, also while a point is dragged. The weights are the paper’s; the torus and the points are ours, and the plane is one of random points.',
  points: {
    torus: [onTorus(52, 112), onTorus(132, 118), onTorus(122, 8), onTorus(66, 2)],
    plane: [
      [0.22, 0.26, 0],
      [0.8, 0.34, 0],
      [0.74, 0.82, 0],
      [0.28, 0.74, 0],
    ],
  },
  panels: [
    {
      id: 'torus',
      title: 'Torus',
      mesh: { kind: 'shape', name: 'torus', triangles: 20_000 },
      points: 'torus',
      curve: { kind: 'center', weights },
      lines: ['spokes', 'exactLogs', ...methods],
      samples: 1,
      view: { from: [0, 0.75, 1] },
    },
    {
      id: 'plane',
      title: 'Plane',
      mesh: { kind: 'plane', tessellation: 'delaunay', triangles: 4_000 },
      points: 'plane',
      curve: { kind: 'center', weights },
      lines: ['spokes', 'truth', ...methods],
      samples: 1,
      view: { from: [0, 0, 1] },
    },
  ],
};

const pair: Vector[] = [onTorus(60, 62), onTorus(130, 8)];
const torus = { kind: 'shape', name: 'torus', triangles: 50_000 } as const;
const simplified = { kind: 'simplified', of: torus, triangles: 500 } as const;
const paths: LineId[] = [
  'descent',
  'vectorHeat',
  'vectorHeatDelaunay',
  'affineHeat',
  'weightedAverages',
  'paper',
  'karcherExact',
  'leveled',
  'exactPath',
];

export const pathFigure: Figure = {
  id: 'paths',
  name: 'Figure 3',
  title: 'Shortest paths as centers of mass',
  caption:
    'The shortest path between two points p and q, as the centers of mass for weights (1 − w, w) with w from 0 to 1, by the paper’s method and by ours, with exact distances. The paper’s searches start as its authors’ program has it: each at the last sample that was found. Ours start the first at p, each of the others at the center before it, and the last, for w = 1, at q. Beside them are the path of steepest descent of the distance field and the exact path, from which deviations are measured. The surfaces are a regular torus and one simplified to 500 triangles. Our default refines the polygon first, and between two points is the path itself. The arrows are the constant gradients that the descent follows. The paper’s tori are others, and so are the two points.',
  points: { pair },
  panels: [
    {
      id: 'fine',
      title: 'Regular torus',
      mesh: torus,
      points: 'pair',
      curve: { kind: 'bezier' },
      lines: paths,
      off: ['vectorHeatDelaunay'],
      samples: 65,
      view: { from: [0, 0.75, 1] },
    },
    {
      id: 'coarse',
      title: 'Simplified torus',
      mesh: simplified,
      points: 'pair',
      curve: { kind: 'bezier' },
      lines: paths,
      off: ['vectorHeatDelaunay'],
      samples: 65,
      view: { from: [0, 0.75, 1], edges: true },
    },
    {
      id: 'close',
      title: 'Close-up of the simplified torus',
      mesh: simplified,
      points: 'pair',
      curve: { kind: 'bezier' },
      lines: ['gradients', 'descent', 'paper', 'karcherExact', 'exactPath'],
      samples: 65,
      view: { at: 0, distance: 0.75, edges: true },
    },
  ],
};
