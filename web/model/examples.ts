/** Finished drawings, made by code. */
import type { SurfacePoint } from 'karcher';
import { type Drawing, newObject, type Properties } from './drawing';
import type { Tangents } from './figure';
import { type ControlPoint, emptyFigure, type Figure, type Kind, type Vector } from './figure';
import { defaultMesh } from './meshes';
import { withTangents } from './pen';

/** A search for places of a surface. The surface is scaled to a ball of radius 1, with y up. */
export interface Places {
  /**
   * The point of the surface that is visible at the place `x`, `y` from a direction, with x to the
   * right and y up; null outside the silhouette.
   */
  seen(from: Vector, x: number, y: number): SurfacePoint | null;
  /** The point of the surface nearest to a place. */
  near(place: Vector): SurfacePoint;
}

export interface Example {
  id: string;
  /** The example's name. */
  name: string;
  /** The key of its surface. */
  mesh: string;
  draw(places: Places): Drawing;
}

const ink = '#222831';
const orange = '#d9480f';
const pink = '#c81e5b';
const violet = '#8a3ffc';
const green = '#0b8457';
const teal = '#0e7c9e';
const white = '#f8f9fa';

/** An object before it has an id. */
interface Part extends Partial<Properties> {
  figure: Figure;
}

/** A drawing of parts from the lowest to the topmost; `edited` is the index of the edited one. */
function drawingOfParts(parts: readonly Part[], edited: number): Drawing {
  const objects = parts.map(({ figure, ...properties }, i) => newObject(i + 1, figure, properties));
  return { objects, active: edited + 1 };
}

function curve(
  points: readonly (SurfacePoint | null)[],
  { closed = false, kind = 'bspline' }: { closed?: boolean; kind?: Kind } = {},
): Figure {
  const found = points.filter((point): point is ControlPoint => point !== null);
  const settings = { ...emptyFigure.settings, closed };
  return { ...emptyFigure, kind, points: found, settings };
}

function circle(center: SurfacePoint, rim: SurfacePoint, across?: SurfacePoint): Figure {
  const kind = across ? 'ellipse' : 'circle';
  return { ...emptyFigure, kind, circle: { center, rim, ...(across && { across }) } };
}

/** Evenly spaced numbers from 0 to 1, without the end. */
const parts = (count: number) => Array.from({ length: count }, (_, i) => i / count);

/** A ring of places about an axis that leans by an angle in the x, y plane. */
function ring(center: Vector, lean: number, radius: number, count: number): Vector[] {
  const [c, s] = [Math.cos(lean), Math.sin(lean)];
  return parts(count).map((part) => {
    const angle = 2 * Math.PI * part;
    const [aside, deep] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return [center[0] + aside * c, center[1] + aside * s, center[2] + deep];
  });
}

/** A flower around a center: smooth anchors at the tips of its petals, corners between them. */
function flower(x: number, y: number, radius: number, petals: number): Anchor[] {
  const step = (part: number, far: number): Place => {
    const angle = 2 * Math.PI * part + Math.PI / 2;
    return [radius * far * Math.cos(angle), radius * far * Math.sin(angle)];
  };
  const width = 0.7 / petals;
  return parts(petals).flatMap((part) => [
    { at: plus([x, y], step(part, 1)), after: step(part + 1 / 4, 3 * width) },
    {
      at: plus([x, y], step(part + 0.5 / petals, 0.45)),
      after: step(part + 0.8 / petals, 0.25),
      before: step(part + 0.2 / petals, 0.25),
    },
  ]);
}

type Place = [x: number, y: number];

/**
 * An anchor of the pen, with its handles as steps from it. A smooth anchor has only `after`, and
 * its other handle is opposite; a corner with handles has both.
 */
interface Anchor {
  at: Place;
  after?: Place;
  before?: Place;
}

/** A curve of the pen through anchors at these places of the view. */
function penned(
  find: (place: Place) => SurfacePoint | null,
  anchors: readonly Anchor[],
  closed: boolean,
): Figure {
  const points = anchors.flatMap(({ at, after, before }): ControlPoint[] => {
    const [anchor, next, last] = [at, after && plus(at, after), before && plus(at, before)].map(
      (place) => (place ? find(place) : null),
    );
    if (!anchor) return [];
    const tangents: Tangents = {
      ...(next && { after: next }),
      ...(last ? { before: last } : next && { before: { length: null } }),
    };
    return [withTangents(anchor, tangents)];
  });
  return curve(points, { closed, kind: 'pen' });
}

const plus = ([a, b]: Place, [x, y]: Place): Place => [a + x, b + y];

/** A heart of the given size. */
const heart = (x: number, y: number, size: number): Anchor[] => {
  const step = (dx: number, dy: number): Place => [size * dx, size * dy];
  const at = (dx: number, dy: number) => plus([x, y], step(dx, dy));
  return [
    { at: at(0, 0.45), after: step(0.2, 0.45), before: step(-0.2, 0.45) },
    { at: at(0.95, 0.4), after: step(0, -0.5) },
    { at: at(0, -0.95), after: step(-0.25, 0.35), before: step(0.25, 0.35) },
    { at: at(-0.95, 0.4), after: step(0, 0.5) },
  ];
};

/** The direction from which the page first shows a surface. */
const front: Vector = [0.34, 0.22, 1];

function bunny({ seen, near }: Places): Drawing {
  const at = ([x, y]: Place) => seen(front, x, y);
  const point = (x: number, y: number) => at([x, y]) ?? near([x, y, 0]);
  const collar = ring([-0.36, 0.02, 0.06], 0.42, 0.27, 10).map(near);
  const wave: Place[] = [
    [-0.14, 0.1],
    [-0.02, 0.02],
    [0.08, 0.14],
    [0.2, 0.06],
    [0.3, 0.08],
    [0.38, -0.06],
    [0.45, -0.12],
    [0.44, -0.28],
  ];
  return drawingOfParts(
    [
      { figure: curve(collar, { closed: true }), name: 'Collar', color: orange, width: 9 },
      { figure: curve(wave.map(at)), name: 'Wave', color: teal, width: 5, dash: 'dashed' },
      {
        figure: circle(point(0.17, -0.24), point(0.23, -0.24)),
        name: 'Seed',
        color: orange,
        width: 5,
      },
      { figure: penned(at, heart(-0.31, -0.15, 0.1), true), name: 'Heart', color: pink, width: 5 },
      {
        figure: circle(point(0.5, -0.46), point(0.54, -0.41)),
        ...{ name: 'Tail', color: green, width: 4, dash: 'dotted' as const },
      },
      { figure: circle(point(-0.55, 0.22), point(-0.51, 0.22)), name: 'Eye', color: ink, width: 5 },
      {
        figure: penned(at, flower(0.17, -0.24, 0.24, 5), true),
        name: 'Flower',
        color: violet,
        width: 6,
      },
    ],
    6,
  );
}

/** The seam of a tennis ball, and a circle in each of its halves. */
function ball({ near }: Places): Drawing {
  const seam = parts(16).map((part): Vector => {
    const t = 2 * Math.PI * part;
    const [a, b] = [0.75, 0.25];
    return [
      a * Math.cos(t) + b * Math.cos(3 * t),
      a * Math.sin(t) - b * Math.sin(3 * t),
      2 * Math.sqrt(a * b) * Math.sin(2 * t),
    ];
  });
  const rings = ([1, -1] as const).map((side) =>
    circle(near([0, 0, side]), near([0.34, 0, side * 0.94])),
  );
  return drawingOfParts(
    [
      ...rings.map((figure) => ({ figure, color: teal, width: 4, dash: 'dotted' as const })),
      { figure: curve(seam.map(near), { closed: true }), name: 'Seam', color: orange, width: 8 },
    ],
    2,
  );
}

/**
 * A curve that winds twice round a torus and three times through its hole, and one that runs beside
 * it.
 */
function windings({ near }: Places): Drawing {
  // The torus that fills a ball of radius 1, about the z axis.
  const place = (around: number, through: number): Vector => {
    const far = 0.7 + 0.3 * Math.cos(through);
    return [far * Math.cos(around), far * Math.sin(around), 0.3 * Math.sin(through)];
  };
  const wound = (shift: number) =>
    parts(18).map((part) => {
      const angle = 2 * Math.PI * part;
      return near(place(2 * angle + shift, 3 * angle));
    });
  return drawingOfParts(
    [
      { figure: curve(wound(Math.PI / 2), { closed: true }), name: 'Echo', color: teal, width: 4 },
      { figure: curve(wound(0), { closed: true }), name: 'Winding', color: pink, width: 7 },
    ],
    1,
  );
}

/** Hearts of the pen on a wavy sheet. */
function hearts({ seen, near }: Places): Drawing {
  const from: Vector = [0.34, 0.22, 1];
  const at = ([x, y]: Place) => seen(from, x, y);
  const point = (x: number, y: number) => at([x, y]) ?? near([x, y, 0]);
  const vine: Place[] = [
    [-0.62, -0.3],
    [-0.4, -0.42],
    [-0.15, -0.28],
    [0.1, -0.42],
    [0.35, -0.26],
    [0.62, -0.4],
  ];
  return drawingOfParts(
    [
      { figure: curve(vine.map(at)), name: 'Vine', color: green, width: 5 },
      {
        figure: circle(point(0.48, 0.18), point(0.58, 0.18)),
        name: 'Ring',
        color: white,
        width: 6,
      },
      {
        figure: penned(at, heart(-0.48, 0.18, 0.12), true),
        name: 'Little',
        color: violet,
        width: 5,
      },
      { figure: penned(at, heart(0, 0.1, 0.27), true), name: 'Heart', color: pink, width: 7 },
    ],
    3,
  );
}

/** The examples. The page opens with the first one. */
export const examples: readonly Example[] = [
  { id: 'bunny', name: 'Ornaments on a bunny', mesh: defaultMesh, draw: bunny },
  { id: 'ball', name: 'Seam of a tennis ball', mesh: 'sphere:20000', draw: ball },
  { id: 'windings', name: 'Windings of a torus', mesh: 'torus:20000', draw: windings },
  { id: 'hearts', name: 'Hearts of the pen on a sheet', mesh: 'openSheet:20000', draw: hearts },
];
