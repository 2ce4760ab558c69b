/**
 * Cubic Bézier curves near points of a plane: least squares for the handles, Newton steps for the
 * parameters, and a split where one curve is not enough (Schneider, An Algorithm for Automatically
 * Fitting Digitized Curves, Graphics Gems, 1990).
 */
export type Planar = readonly [number, number];
export type Cubic = readonly [Planar, Planar, Planar, Planar];

/** The unit directions into the curve from its ends; null for a free handle. */
export interface EndDirections {
  start: Planar | null;
  end: Planar | null;
}

/** A curve near the points between two indices. */
export interface Piece {
  from: number;
  to: number;
  cubic: Cubic;
}

/**
 * The largest number of steps that improve a curve's parameters before the fit splits or returns
 * it.
 */
const mostSteps = 24;
/** The largest deviation, in tolerances, for which the fit goes on to improve the parameters. */
const worthBettering = 16;
/**
 * The least length of a handle in a given direction, relative to the chord. A third of the chord
 * replaces a shorter length, or one against the direction.
 */
const leastHandle = 1e-6;

const add = (p: Planar, q: Planar, factor = 1): Planar => [
  p[0] + factor * q[0],
  p[1] + factor * q[1],
];
const dot = (p: Planar, q: Planar) => p[0] * q[0] + p[1] * q[1];
const far = (p: Planar, q: Planar) => Math.hypot(p[0] - q[0], p[1] - q[1]);

export function bernstein(t: number): [number, number, number, number] {
  const s = 1 - t;
  return [s ** 3, 3 * t * s ** 2, 3 * t ** 2 * s, t ** 3];
}

export function cubicAt(cubic: Cubic, t: number): Planar {
  return bernstein(t).reduce<Planar>((sum, weight, i) => add(sum, cubic[i]!, weight), [0, 0]);
}

/** The first and the second derivative of a curve at a parameter. */
function derivativesAt([p, q, r, s]: Cubic, t: number): [Planar, Planar] {
  const [a, b, c] = [add(q, p, -1), add(r, q, -1), add(s, r, -1)];
  const u = 1 - t;
  const first = add(add([0, 0], a, 3 * u * u), add(add([0, 0], b, 6 * u * t), c, 3 * t * t));
  const second = add(add([0, 0], add(b, a, -1), 6 * u), add(c, b, -1), 6 * t);
  return [first, second];
}

/** Solves a small symmetric system by elimination; null if it is singular. */
function solved(rows: number[][]): number[] | null {
  const count = rows.length;
  for (let k = 0; k < count; k++) {
    const best = rows.reduce((top, row, i) => {
      return i >= k && Math.abs(row[k]!) > Math.abs(rows[top]![k]!) ? i : top;
    }, k);
    [rows[k], rows[best]] = [rows[best]!, rows[k]!];
    const pivot = rows[k]![k]!;
    if (Math.abs(pivot) < 1e-300) return null;
    for (let i = 0; i < count; i++) {
      if (i === k) continue;
      const factor = rows[i]![k]! / pivot;
      for (let j = k; j <= count; j++) rows[i]![j]! -= factor * rows[k]![j]!;
    }
  }
  return rows.map((row, k) => row[count]! / row[k]!);
}

/** The curve from the first point to the last that is nearest to the points at these parameters. */
function leastSquares(
  points: readonly Planar[],
  parameters: readonly number[],
  { start, end }: EndDirections,
): Cubic {
  const [first, last] = [points[0]!, points.at(-1)!];
  const axes: Planar[] = [
    [1, 0],
    [0, 1],
  ];
  // Each unknown moves a handle along its given direction, or along one of two axes.
  const unknowns = [
    ...(start ? [start] : axes).map((way) => ({ handle: 1, way })),
    ...(end ? [end] : axes).map((way) => ({ handle: 2, way })),
  ];
  const rows = unknowns.map(() => new Array<number>(unknowns.length + 1).fill(0));
  for (const [i, point] of points.entries()) {
    const weights = bernstein(parameters[i]!);
    const ends = add(add([0, 0], first, weights[0] + weights[1]), last, weights[2] + weights[3]);
    const missing = add(point, ends, -1);
    for (const [k, one] of unknowns.entries()) {
      const row = rows[k]!;
      const weight = weights[one.handle]!;
      for (const [l, other] of unknowns.entries()) {
        row[l]! += weight * weights[other.handle]! * dot(one.way, other.way);
      }
      row[unknowns.length]! += weight * dot(one.way, missing);
    }
  }
  const chord = far(first, last);
  const values = solved(rows);
  const handle = (which: number, from: Planar, direction: Planar | null): Planar => {
    const own = unknowns.flatMap((one, k) =>
      one.handle === which ? [{ ...one, value: values?.[k] ?? Number.NaN }] : [],
    );
    const isFit = own.every(({ value }) => Number.isFinite(value));
    if (isFit && !(direction && own[0]!.value < leastHandle * chord)) {
      return own.reduce<Planar>((sum, { way, value }) => add(sum, way, value), from);
    }
    return direction ? add(from, direction, chord / 3) : from;
  };
  return [first, handle(1, first, start), handle(2, last, end), last];
}

/** Parameters by the length along the points, from 0 to 1. */
function chordParameters(points: readonly Planar[]): number[] {
  const lengths = [0];
  for (let i = 1; i < points.length; i++) {
    lengths.push(lengths[i - 1]! + far(points[i]!, points[i - 1]!));
  }
  const whole = lengths.at(-1) || 1;
  return lengths.map((length) => length / whole);
}

/** Moves each parameter by one Newton step towards the curve's nearest place to the given point. */
function bettered(points: readonly Planar[], parameters: readonly number[], cubic: Cubic) {
  return parameters.map((t, i) => {
    const off = add(cubicAt(cubic, t), points[i]!, -1);
    const [first, second] = derivativesAt(cubic, t);
    const slope = dot(first, first) + dot(off, second);
    return slope > 0 ? Math.min(1, Math.max(0, t - dot(off, first) / slope)) : t;
  });
}

/**
 * The point from which the curve deviates most, and the deviation in units of the point's
 * tolerance.
 */
function worstOf(
  points: readonly Planar[],
  parameters: readonly number[],
  cubic: Cubic,
  tolerances: readonly number[],
): { off: number; at: number } {
  let worst = { off: 0, at: Math.floor(points.length / 2) };
  for (let i = 1; i < points.length - 1; i++) {
    const off = far(cubicAt(cubic, parameters[i]!), points[i]!) / tolerances[i]!;
    if (off > worst.off) worst = { off, at: i };
  }
  return worst;
}

/**
 * The best curve found from the first point to the last, its largest deviation in tolerances, and
 * the index of the point with this deviation.
 */
export function nearestCubic(
  points: readonly Planar[],
  directions: EndDirections,
  tolerances: readonly number[],
  begun = chordParameters(points),
): { cubic: Cubic; off: number; at: number } {
  let parameters = begun;
  let best: { cubic: Cubic; off: number; at: number } | null = null;
  for (let step = 0; step < mostSteps; step++) {
    const cubic = leastSquares(points, parameters, directions);
    const worst = worstOf(points, parameters, cubic, tolerances);
    if (!best || worst.off < best.off) best = { cubic, ...worst };
    if (worst.off <= 1e-12 || worst.off > worthBettering * Math.max(1, best.off)) break;
    if (step >= 4 && best.off > worthBettering) break;
    parameters = bettered(points, parameters, cubic);
  }
  return best!;
}

/**
 * The unit direction from the point at an index towards the points before it (step -1) or after it
 * (step 1).
 */
function directionAt(points: readonly Planar[], at: number, step: 1 | -1, reach: number): Planar {
  const from = points[at]!;
  let to = at + step;
  while (points[to + step] && far(points[to]!, from) < reach) to += step;
  const way = add(points[to] ?? from, from, -1);
  const length = Math.hypot(...way);
  return length > 0 ? [way[0] / length, way[1] / length] : [1, 0];
}

export interface FitOptions {
  /** The tolerance at each point. */
  tolerances: readonly number[];
  /** The indices of points, besides the first and the last, where the curve may have a corner. */
  corners: readonly number[];
  /**
   * The least distance between two points that determine a direction. The distance may be less at
   * the end of the points.
   */
  reach: number;
  /**
   * For a closed line, whose first and last points are the same. The same direction may have
   * different angles at the two points: `turn` is the angle at the last point minus the angle at
   * the first. `cornerAngle` is the least turn of a corner.
   */
  loop?: { turn: number; cornerAngle: number };
}

/** A sequence of curves near points: they meet smoothly except at corners. */
export function fittedCubics(
  points: readonly Planar[],
  options: FitOptions,
): { pieces: Piece[]; isSmoothSeam: boolean } {
  const { tolerances, corners, reach, loop } = options;
  const last = points.length - 1;
  const ends = [...new Set([0, ...corners, last])].sort((a, b) => a - b);
  const middleAt = (before: Planar, after: Planar): Planar | null => {
    const way = add(after, before, -1);
    const length = Math.hypot(...way);
    return length > 1e-9 ? [way[0] / length, way[1] / length] : null;
  };
  /** The direction along the curve at a point, from the points on both sides. */
  const along = (at: number): Planar => {
    const [back, on] = [directionAt(points, at, -1, reach), directionAt(points, at, 1, reach)];
    return middleAt(back, on) ?? on;
  };
  const reversed = ([x, y]: Planar): Planar => [-x, -y];
  const pieces: Piece[] = [];
  const fit = (from: number, to: number, start: Planar, end: Planar): void => {
    const part = points.slice(from, to + 1);
    const found = nearestCubic(part, { start, end }, tolerances.slice(from, to + 1));
    // A closed curve needs two anchors.
    const isWholeLoop = loop !== undefined && from === 0 && to === last;
    if ((found.off <= 1 && !isWholeLoop) || to - from < 2) {
      pieces.push({ from, to, cubic: found.cubic });
      return;
    }
    const middle = from + Math.min(Math.max(found.at, 1), to - from - 1);
    const way = along(middle);
    fit(from, middle, start, reversed(way));
    fit(middle, to, way, end);
  };
  const turned = ([x, y]: Planar, angle: number): Planar => [
    x * Math.cos(angle) - y * Math.sin(angle),
    x * Math.sin(angle) + y * Math.cos(angle),
  ];
  const on = directionAt(points, 0, 1, reach);
  const back = turned(directionAt(points, last, -1, reach), -(loop?.turn ?? 0));
  const isSmoothSeam = loop !== undefined && turnBetween(back, on) < loop.cornerAngle;
  const seam = isSmoothSeam ? (middleAt(back, on) ?? on) : null;
  for (const [i, from] of ends.slice(0, -1).entries()) {
    const to = ends[i + 1]!;
    const start = from === 0 && seam ? seam : directionAt(points.slice(0, to + 1), from, 1, reach);
    const end =
      to === last && seam
        ? reversed(turned(seam, loop!.turn))
        : directionAt(points.slice(from), to - from, -1, reach);
    fit(from, to, start, end);
  }
  return { pieces, isSmoothSeam };
}

/** The angle by which a line turns at a point, from the directions back and onwards. */
const turnBetween = (back: Planar, on: Planar) =>
  Math.PI - Math.acos(Math.min(1, Math.max(-1, dot(back, on))));

/**
 * The indices of points where a line turns sharply within a reach. Of consecutive ones that are at
 * most a reach apart, only the sharpest counts.
 */
export function cornersOf(
  points: readonly Planar[],
  { reach, angle }: { reach: number; angle: number },
): number[] {
  const turns = points.map((_, i) => {
    if (i === 0 || i === points.length - 1) return 0;
    const [back, on] = [directionAt(points, i, -1, reach), directionAt(points, i, 1, reach)];
    return turnBetween(back, on);
  });
  const corners: number[] = [];
  for (const [i, turn] of turns.entries()) {
    if (turn < angle) continue;
    const before = corners.at(-1);
    if (before === undefined || far(points[i]!, points[before]!) > reach) corners.push(i);
    else if (turn > turns[before]!) corners[corners.length - 1] = i;
  }
  return corners;
}
