import Delaunator from 'delaunator';
import { type MadeSource, usualStretch } from './meshes';
import { randomFrom } from './random';

/** Positions and triangles in the form of `Karcher.meshFromArrays`. */
export interface Arrays {
  positions: Float64Array;
  triangles: Int32Array;
}

const seed = 8;

/** A triangulation of the unit square in z = 0. */
export function planeArrays({
  tessellation,
  triangles,
  stretch = usualStretch,
}: Extract<MadeSource, { kind: 'plane' }>): Arrays {
  if (tessellation === 'delaunay') return delaunay(triangles, whiteNoise);
  if (tessellation === 'fair') return delaunay(triangles, fairPoints);
  if (tessellation === 'grid') {
    const cells = Math.max(2, Math.round(Math.sqrt(triangles / 2)));
    return grid(cells, cells, 0);
  }
  const columns = Math.max(2, Math.round(Math.sqrt(triangles / 2 / stretch)));
  return grid(columns, Math.max(2, Math.round(columns * stretch)), 0.3);
}

/** Appends about `count` points with coordinates from `least` to 1 - `least`. */
type Scatter = (flat: number[], count: number, least: number, random: () => number) => void;

/** Independent, uniformly distributed points. */
const whiteNoise: Scatter = (flat, count, least, random) => {
  for (let k = 0; k < count; k++) {
    flat.push(least + (1 - 2 * least) * random(), least + (1 - 2 * least) * random());
  }
};

/**
 * Points of a lattice of equilateral triangles, each moved by up to a quarter of the triangles'
 * side.
 */
const fairPoints: Scatter = (flat, count, least, random) => {
  const width = 1 - 2 * least;
  const side = width / Math.sqrt(count * Math.sqrt(0.75));
  const rows = Math.max(2, Math.round(width / (side * Math.sqrt(0.75))));
  const columns = Math.max(2, Math.round(width / side));
  const most = side / 4;
  const within = (x: number) => Math.min(1 - least, Math.max(least, x));
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const [radius, angle] = [most * Math.sqrt(random()), 2 * Math.PI * random()];
      const x = ((i + (j % 2 ? 0.75 : 0.25)) / columns) * width + least;
      const y = ((j + 0.5) / rows) * width + least;
      flat.push(within(x + radius * Math.cos(angle)), within(y + radius * Math.sin(angle)));
    }
  }
};

/**
 * A grid. With `jitter`, vertices move by up to that many cells in each coordinate, and diagonals
 * are random. Vertices of the border move only along it.
 */
function grid(columns: number, rows: number, jitter: number): Arrays {
  const random = randomFrom(seed);
  const positions: number[] = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++) {
      const [dx, dy] = [random() - 0.5, random() - 0.5];
      const x = i === 0 || i === columns ? i : i + 2 * jitter * dx;
      const y = j === 0 || j === rows ? j : j + 2 * jitter * dy;
      positions.push(x / columns, y / rows, 0);
    }
  }
  const triangles: number[] = [];
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const a = i + (columns + 1) * j;
      const [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
      if (jitter > 0 && random() < 0.5) triangles.push(a, b, d, b, c, d);
      else triangles.push(a, b, c, a, c, d);
    }
  }
  return { positions: Float64Array.from(positions), triangles: Int32Array.from(triangles) };
}

/** The Delaunay triangulation of scattered points, with evenly spaced points on the border. */
function delaunay(triangles: number, scatter: Scatter): Arrays {
  const random = randomFrom(seed);
  const count = Math.max(9, Math.round(triangles / 2));
  const side = Math.max(2, Math.round(Math.sqrt(count)));
  const flat: number[] = [];
  for (let i = 0; i < side; i++) {
    const s = i / side;
    flat.push(s, 0, 1, s, 1 - s, 1, 0, 1 - s);
  }
  // Points keep away from the border, so that no triangle there is a sliver.
  const inset = 0.4 / side;
  scatter(flat, count - flat.length / 2, inset, random);
  const { triangles: corners } = new Delaunator(flat);
  const positions = new Float64Array((flat.length / 2) * 3);
  for (let v = 0; v < flat.length / 2; v++) positions.set([flat[2 * v]!, flat[2 * v + 1]!], 3 * v);
  const faces: number[] = [];
  for (let f = 0; f < corners.length; f += 3) {
    const [a, b, c] = [corners[f]!, corners[f + 1]!, corners[f + 2]!];
    const [ux, uy] = [flat[2 * b]! - flat[2 * a]!, flat[2 * b + 1]! - flat[2 * a + 1]!];
    const [vx, vy] = [flat[2 * c]! - flat[2 * a]!, flat[2 * c + 1]! - flat[2 * a + 1]!];
    const area = ux * vy - uy * vx;
    // Points of one side are collinear, and rounding may turn them into degenerate triangles.
    if (Math.abs(area) < 1e-12) continue;
    faces.push(...(area > 0 ? [a, b, c] : [a, c, b]));
  }
  return { positions, triangles: Int32Array.from(faces) };
}
