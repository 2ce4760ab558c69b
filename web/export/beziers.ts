/** Visible lines as few Bézier curves, for the data of an SVG's path. */
import { cornersOf, fittedCubics, type Planar } from '../model/cubic_fit';

/**
 * Distances in pixels. Vertices nearer to each other than `together` are merged, the curves deviate
 * from the places by at most `tolerance`, and fitted places are at most `apart` from each other. So
 * the path lies within a quarter of a pixel of its line.
 */
const [together, tolerance, apart] = [0.1, 0.12, 4];
/** A corner is a turn by at least `angle`, in radians, within `reach`, in pixels. */
const corner = { reach: 2, angle: 0.35 };

const far = (p: Planar, q: Planar) => Math.hypot(p[0] - q[0], p[1] - q[1]);
const short = (value: number) => `${Number(value.toFixed(2))}`;

/** The places of a line, without repetitions. */
function merged(line: readonly Planar[]): Planar[] {
  const places = line.slice(0, 1);
  for (const [i, place] of line.entries()) {
    const isLast = i === line.length - 1;
    if (far(places.at(-1)!, place) >= together) places.push(place);
    // The end stays in place.
    else if (isLast && places.length > 1) places[places.length - 1] = place;
  }
  return places;
}

/**
 * The line with extra places between consecutive places that are far apart. Corners keep their
 * places.
 */
function filled(places: readonly Planar[]): Planar[] {
  const result = places.slice(0, 1);
  for (const place of places.slice(1)) {
    const from = result.at(-1)!;
    const parts = Math.max(1, Math.ceil(far(from, place) / apart));
    for (let i = 1; i < parts; i++) {
      const t = i / parts;
      result.push([from[0] + t * (place[0] - from[0]), from[1] + t * (place[1] - from[1])]);
    }
    result.push(place);
  }
  return result;
}

/** The data of a path along a line's places. The path ends exactly at the line's end. */
export function pathData(line: readonly Planar[]): string {
  const points = filled(merged(line));
  const at = ([x, y]: Planar) => `${short(x)} ${short(y)}`;
  // The path is a dot, whose round ends make it visible.
  if (points.length < 2) return `M${at(line[0]!)}L${at(line.at(-1)!)}`;
  const { pieces } = fittedCubics(points, {
    tolerances: points.map(() => tolerance),
    corners: cornersOf(points, corner),
    reach: corner.reach,
  });
  const parts = pieces.map(({ from, to, cubic: [, p, q, end] }) =>
    isStraight(points.slice(from, to + 1)) ? `L${at(end)}` : `C${at(p)} ${at(q)} ${at(end)}`,
  );
  return `M${at(points[0]!)}${parts.join('')}`;
}

/** Whether points lie on the segment between their ends, to within a hundredth of a pixel. */
function isStraight(points: readonly Planar[]): boolean {
  const [from, to] = [points[0]!, points.at(-1)!];
  const length = far(from, to);
  if (!(length > 0)) return points.length < 3;
  const [dx, dy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  return points.every(([x, y]) => {
    const along = dx * (x - from[0]) + dy * (y - from[1]);
    return Math.abs(dx * (y - from[1]) - dy * (x - from[0])) < 0.01 && along > -0.01;
  });
}
