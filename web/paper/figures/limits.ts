import type { Tessellation } from '../../model/meshes';
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
    'Where control points lie too far apart there may be more than one center of mass, or none near the last, and curves break: they jump from one to another, or samples are lost, which is dashed. A lost sample tells that its searches failed, and not that there is no center. The paper’s method starts again at other control points before it gives a sample up, and may come to a center far off. Where a curve is at another center than the reference, its deviation is large. Ours is then bridged: it takes the better of the centers that it comes to from either end, and a subdivision curve of the same points, dashed too, joins them; its deviation is from the same curve of exact distances.',
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
