import { planeSpline } from './limits';
import { onKnot, onSphere, onTorus } from './surfaces';
import type { Figure, LineId, Vector } from './types';

const genus3 = { kind: 'shape', name: 'genus3', triangles: 50_000 } as const;
const simplified = { kind: 'simplified', of: genus3, triangles: 1_000 } as const;
const methods: LineId[] = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'bSurf',
  'paperGraph2',
  'paperGraph6',
  'karcher',
  'leveled',
  'exactLogs',
];

/** The reference is initially hidden, since it would cover all lines that agree with it. */
const reference: LineId[] = ['exactLogs'];
const hidden: LineId[] = [...reference, 'paperGraph2'];

const fourSegments: Vector[] = [
  [-1.5, 0.05, 0.3],
  [-1.28, 0.52, 0.3],
  [-0.95, 0.5, 0.3],
  [-0.6, 0.2, 0.3],
  [-0.42, -0.2, 0.3],
  [-0.1, -0.5, 0.3],
  [0.3, -0.5, 0.3],
];

export const resolutionFigure: Figure = {
  id: 'resolution',
  name: 'Figure 4',
  title: 'A B-spline on a coarse and on a fine mesh',
  caption:
    'A uniform cubic B-spline of four segments on a surface of 1,000 and of 54,400 triangles, the first simplified from the second, by every method. Deviations are measured from the reference, our spline with exact distances on the same mesh. As in the paper’s figure its method has graph distances of k = 6; k = 2, which the paper shows in an inset of Section 5.1, can be switched on. The model and the control points are ours.',
  points: { spline: fourSegments },
  panels: [
    { id: 'coarse', title: 'Coarse', mesh: simplified, edges: true },
    { id: 'fine', title: 'Fine', mesh: genus3, edges: false },
  ].map(({ edges, ...panel }) => ({
    ...panel,
    points: 'spline',
    curve: { kind: 'bspline' },
    lines: methods,
    off: hidden,
    samples: 128,
    view: { from: [0, -0.35, 1], edges },
  })),
};

const gallery: LineId[] = [
  'weightedAverages',
  'bSurf',
  'paperGraph6',
  'paper',
  'karcher',
  'leveled',
  'exactLogs',
];

const sphere: Vector[] = [
  onSphere(-50, -30),
  onSphere(-42, 25),
  onSphere(-16, 42),
  onSphere(4, -28),
  onSphere(24, -40),
  onSphere(36, 18),
  onSphere(58, 36),
];

export const galleryFigure: Figure = {
  id: 'gallery',
  name: 'Figure 5',
  title: 'A gallery',
  caption:
    'Uniform cubic B-splines on surfaces of different shape and topology. The paper shows its method with graph distances of k = 6, which can be switched on; here it has exact distances, which are in its favour. Weighted averages, which the paper compares in an inset of Section 5.2, can be switched on too. The models and control points are ours; all are smooth but the bunny. Rough ones are in the table of claims.',
  points: {
    bunny: [
      [-3.2, 3.2, 2.4],
      [-3.4, 5.2, 2.6],
      [-1.8, 5.4, 3.2],
      [-0.4, 3.2, 3.6],
      [1.2, 1.6, 3.4],
      [2.6, 3, 3.2],
      [2.2, 5, 2.6],
      [0.8, 6, 2.2],
    ],
    knot: [0, 18, 36, 54, 72, 90, 108].map((degrees, i) =>
      onKnot(190 + degrees, i % 2 ? 0.1 : -0.1),
    ),
    sphere,
    torus: [
      onTorus(10, 50),
      onTorus(40, 110),
      onTorus(70, 40),
      onTorus(95, 120),
      onTorus(125, 50),
      onTorus(155, 110),
      onTorus(185, 50),
    ],
  },
  panels: [
    {
      id: 'bunny',
      title: 'Bunny',
      mesh: { kind: 'bunny', levels: 2 },
      points: 'bunny',
      view: { from: [-0.25, 0.1, 1] },
    },
    {
      id: 'knot',
      title: 'Knotted tube',
      mesh: { kind: 'shape', name: 'knot', triangles: 30_000 },
      points: 'knot',
      view: { from: [0.1, 0.1, 1] },
    },
    {
      id: 'sphere',
      title: 'Sphere',
      mesh: { kind: 'shape', name: 'sphere', triangles: 20_000 },
      points: 'sphere',
      view: { from: [0, 0, 1] },
    },
    {
      id: 'torus',
      title: 'Torus',
      mesh: { kind: 'shape', name: 'torus', triangles: 30_000 },
      points: 'torus',
      view: { from: [0, 0.55, 1] },
    },
  ].map((panel) => ({
    ...(panel as Pick<Figure['panels'][number], 'id' | 'title' | 'mesh' | 'points' | 'view'>),
    curve: { kind: 'bspline' },
    lines: gallery,
    off: [...reference, 'weightedAverages', 'paperGraph6'],
    samples: 128,
  })),
};

const rings: LineId[] = ['paperGraph2', 'paperGraph6', 'paper', 'karcher', 'leveled'];

export const graphFigure: Figure = {
  id: 'graph',
  name: 'Section 5.1, inset',
  title: 'Graph distances with k = 2 and k = 6',
  caption:
    'The paper’s method with distances on the graph that joins each vertex to those of its k-ring that it sees straight; the graph of the authors’ program also joins those round saddles, so that its curves are others by a few hundredths of an edge. With k = 2, paths have few directions to choose from: the farther apart the points are, in edges, the more the curve strays and wiggles. With k = 6 it is several times closer, on the plane to the affine curve and on the sphere to the reference; with exact distances it is closer still. The paper’s inset is of the curve of Figure 4, where both can be switched on; these curves are ours.',
  points: { plane: planeSpline, sphere },
  panels: [
    {
      id: 'grid',
      title: 'Plane, regular grid',
      mesh: { kind: 'plane', tessellation: 'grid', triangles: 8_000 },
      points: 'plane',
      curve: { kind: 'bspline' },
      lines: [...rings, 'truth'],
      off: ['truth'],
      samples: 128,
      view: { from: [0, 0, 1] },
    },
    {
      id: 'sphere',
      title: 'Sphere',
      mesh: { kind: 'shape', name: 'sphere', triangles: 20_000 },
      points: 'sphere',
      curve: { kind: 'bspline' },
      lines: [...rings, 'exactLogs'],
      off: reference,
      samples: 128,
      view: { from: [0, 0, 1] },
    },
  ],
};

export const averagesFigure: Figure = {
  id: 'averages',
  name: 'Section 5.2, inset',
  title: 'Weighted averages and the paper’s curve',
  caption:
    'Weighted averages are taken in an embedding whose straight lines are about as long as shortest paths. Where they are not, the curve is a different one. The paper’s inset is of a curve of Figure 5, where weighted averages can be switched on; this curve is ours.',
  points: {
    spline: [
      [-1.35, -0.55, 0.2],
      [-1.55, 0.1, 0.2],
      [-1.1, 0.62, 0.2],
      [-0.62, 0.25, 0.2],
      [-0.42, -0.4, 0.2],
      [0.2, -0.55, 0.2],
    ],
  },
  panels: [
    {
      id: 'averages',
      title: 'Genus 3',
      mesh: { kind: 'shape', name: 'genus3', triangles: 8_000 },
      points: 'spline',
      curve: { kind: 'bspline' },
      lines: ['weightedAverages', 'bSurf', 'paper', 'karcher', 'leveled', 'exactLogs'],
      off: reference,
      samples: 128,
      view: { from: [-0.4, -0.1, 1] },
    },
  ],
};
