import type { Tessellation } from '../../editor/meshes';
import type { Figure, LineId, MeshSpec, Vector } from './types';

const farMethods: LineId[] = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'paper',
  'karcher',
  'bridged',
];

export const farFigure: Figure = {
  id: 'far',
  name: 'Figure 7',
  title: 'Points too far apart',
  caption:
    'Where control points lie too far apart there may be more than one center of mass, or none near the last, and curves break: they jump, or samples are lost, which is dashed. A lost sample tells that the search for it failed, and not that there is no center. Ours is then bridged by a subdivision curve of the same points: the bridge is dashed too, and holds the curve together.',
  points: {
    far: [
      [-1.6, 0, 0.1],
      [-0.3, 0.45, 0.25],
      [0.3, -0.45, 0.25],
      [1.6, 0, 0.1],
    ],
  },
  panels: (
    [
      ['bspline', 'B-spline'],
      ['bezier', 'Bézier curve'],
    ] as const
  ).map(([kind, title]) => ({
    id: kind,
    title,
    mesh: { kind: 'shape', name: 'genus3', triangles: 10_000 },
    points: 'far',
    curve: { kind },
    lines: farMethods,
    samples: 128,
    view: { from: [0, -0.2, 1] },
  })),
};

const plane = (tessellation: Tessellation): MeshSpec => ({
  kind: 'plane',
  tessellation,
  triangles: 8_000,
});
const methods: LineId[] = [
  'truth',
  'vectorHeat',
  'vectorHeatDelaunay',
  'affineHeat',
  'weightedAverages',
  'paper',
  'paperGraph6',
  'karcher',
];

/** In the unit square. */
export const planeSpline: Vector[] = [
  [0.16, 0.3, 0],
  [0.28, 0.72, 0],
  [0.44, 0.34, 0],
  [0.58, 0.74, 0],
  [0.72, 0.3, 0],
  [0.86, 0.66, 0],
];

export const planeFigure: Figure = {
  id: 'plane',
  name: 'Figure 8',
  title: 'A B-spline on the plane',
  caption:
    'On the plane the cubic B-spline is known. Gradients that are averaged over rings are off wherever rings are not symmetric; log vectors are linear there, and so exact on any tessellation.',
  points: {
    spline: planeSpline,
  },
  panels: (
    [
      ['delaunay', 'Delaunay'],
      ['grid', 'Regular grid'],
      ['anisotropic', 'Anisotropic'],
    ] as const
  ).map(([id, title]) => ({
    id,
    title,
    mesh: plane(id),
    points: 'spline',
    curve: { kind: 'bspline' },
    lines: methods,
    off: ['vectorHeatDelaunay'],
    samples: 128,
    view: { from: [0, 0, 1], edges: true },
  })),
};
