import type { Kind } from '../model/figure';

/** A kind as the page calls it. */
export const kindNames: Record<Kind, string> = {
  bspline: 'B-spline',
  bezier: 'Bézier',
  catmullrom: 'Catmull-Rom',
  rational: 'Rational',
  barycentric: 'Barycentric',
  polyline: 'Polyline',
  circle: 'Circle',
  ellipse: 'Ellipse',
  center: 'Center',
  points: 'Points',
  pen: 'Pen',
};

/** What a kind is, in a few words. */
export const kindNotes: Record<Kind, string> = {
  bspline: 'A smooth curve near its control points; with weights, a NURBS curve',
  bezier: 'One segment from the first point to the last',
  catmullrom: 'Smooth, through all points',
  rational: 'A Bézier curve whose weights pull it to its points',
  barycentric: 'One rational segment through all points, shaped by betas',
  polyline: 'Shortest paths from point to point',
  circle: 'All points at one distance from a center',
  ellipse: 'Two radii around a center, at right angles',
  center: 'The center of mass of the points',
  points: 'Single points of the surface',
  pen: 'Bézier curves through anchors with handles: click a corner, drag a smooth anchor (P)',
};

/** Kinds that are offered together, each for the others. */
export const kindGroups: readonly { title: string; kinds: readonly Kind[] }[] = [
  { title: 'Pen', kinds: ['pen'] },
  {
    title: 'Curve',
    kinds: ['bspline', 'bezier', 'catmullrom', 'rational', 'barycentric', 'polyline'],
  },
  { title: 'Circle', kinds: ['circle', 'ellipse'] },
  { title: 'Points', kinds: ['center', 'points'] },
];
