import type { Tessellation } from '../../model/meshes';
import type { Figure, LineId, MeshSpec, Vector } from './types';

const farMethods: LineId[] = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'bSurf',
  'paper',
  'karcher',
  'bridged',
  'leveled',
];

export const farFigure: Figure = {
  id: 'far',
  name: 'Figure 7',
  title: 'Points too far apart',
  caption:
    'Where control points lie too far apart, there may be more than one center of mass, or none near the last one. Curves then break: they jump from one center to another, or samples are lost, which is drawn dashed. A lost sample means that its searches failed, not that there is no center. The paper’s method goes on from its last sample that was found, as its authors’ program does, and may reach a center far away; ours starts again at the heaviest control point, as in the engine. Where a curve is at another center than the reference, its deviation is large. Our curve is bridged there: it takes the better of the centers reached from either end, and a subdivision curve of the same points, also dashed, joins them. Bridged so, the Bézier curve doubles back under the hole: it turns by {bezier/bridged turn} at t = {bezier/bridged at}. With levels, as in the editor, the control polygon is refined first, and each piece is the center of its own near points: no sample is bridged, and the Bézier curve turns by {bezier/leveled turn} at most. All are measured from one reference, our curve of level 0 with exact distances, and by the residual of all four points at once; the curve with levels is another curve and has its own pieces’ centers, which neither measures. b/Surf’s curve never breaks, but is no center of mass. “Drag” moves a control point in small steps and tells how far the curves leap. The surface and the points are ours.',
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
  'bSurf',
  'paper',
  'paperRing',
  'paperOurSeeds',
  'paperGraph6',
  'karcher',
  'leveled',
];

/** Control points in the unit square. */
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
    'On the plane the cubic B-spline is known. Gradients averaged over rings are wrong wherever the rings are not symmetric; log vectors are linear there, and therefore exact on any tessellation. The paper shows a Delaunay mesh of fairly regular points, a triangulated grid and an anisotropic mesh. Here the first is one of a lattice whose points were moved by up to a quarter of its side; beside it is one of white noise, which is harder. The meshes and control points are ours. How anisotropic the last is can be changed. The paper’s method starts as its authors’ program does and averages, as that does, the faces around a vertex and those beyond; “1-ring” is Eq. 3 as it is printed, and “our seeds” starts at the heaviest control points, and again where it fails. Where a sample is lost its search failed: on the anisotropic mesh a search from some face near by finds a center of mass at every parameter.',
  points: {
    spline: planeSpline,
  },
  panels: (
    [
      ['fair', 'Delaunay, fairly regular points'],
      ['delaunay', 'Delaunay, white noise'],
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
    off: ['vectorHeatDelaunay', 'paperRing', 'paperOurSeeds'],
    samples: 128,
    view: { from: [0, 0, 1], edges: true },
  })),
};
