import { booleans } from '../model/derived';
import type { Kind } from '../model/figure';

/** The page's names of kinds. */
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
  offset: 'Offset',
  union: 'Union',
  intersection: 'Intersection',
  difference: 'Difference',
  exclusion: 'Exclusion',
  cut: 'Cut',
};

/** Short descriptions of kinds. */
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
  offset: 'Lines at a distance from another object',
  union: 'What any of the objects enclose',
  intersection: 'What all of the objects enclose',
  difference: 'What the lowest of the objects encloses without what the others do',
  exclusion: 'What an odd number of the objects enclose',
  cut: 'The surface cut apart along objects',
};

/** Groups of kinds that the page offers together, as alternatives. */
export const kindGroups: readonly { title: string; kinds: readonly Kind[] }[] = [
  { title: 'Pen', kinds: ['pen'] },
  {
    title: 'Curve',
    kinds: ['bspline', 'bezier', 'catmullrom', 'rational', 'barycentric', 'polyline'],
  },
  { title: 'Circle', kinds: ['circle', 'ellipse'] },
  { title: 'Points', kinds: ['center', 'points'] },
  { title: 'Combined', kinds: booleans },
  { title: 'Offset', kinds: ['offset'] },
  { title: 'Cut', kinds: ['cut'] },
];
