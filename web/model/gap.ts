/** The distance of two curves from each other, by their polylines. */
export interface Gap {
  /** The mean distance of the points of each curve from the other curve. */
  mean: number;
  /** The Hausdorff distance: the largest distance of a point of one curve from the other. */
  largest: number;
}

/** The number of evenly spaced points at which the distance of each curve is measured. */
const samples = 256;
/** The number of segments in a block, which a search measures or skips as a whole. */
const blockLength = 32;

/** Consecutive segments, and a ball that contains them. */
interface Block {
  center: readonly [number, number, number];
  radius: number;
  first: number;
  end: number;
}

/**
 * The distances in space between two polylines; null if one has no vertex. The arrays have x, y, z
 * of each vertex.
 */
export function gapBetween(a: ArrayLike<number>, b: ArrayLike<number>): Gap | null {
  if (a.length < 3 || b.length < 3) return null;
  const [there, back] = [distances(a, b), distances(b, a)];
  const mean = (values: readonly number[]) =>
    values.reduce((sum, value) => sum + value, 0) / values.length;
  return { mean: (mean(there) + mean(back)) / 2, largest: Math.max(...there, ...back) };
}

function distances(from: ArrayLike<number>, to: ArrayLike<number>): number[] {
  const blocks = blocksOf(to);
  return evenly(from).map((place) => distanceTo(place, to, blocks));
}

type Place = readonly [number, number, number];

const vertex = (line: ArrayLike<number>, i: number): Place => [
  line[3 * i]!,
  line[3 * i + 1]!,
  line[3 * i + 2]!,
];
const far = (p: Place, q: Place) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

/** The midpoints of equally long parts of a polyline. */
function evenly(line: ArrayLike<number>): Place[] {
  const count = Math.floor(line.length / 3);
  const lengths = new Float64Array(count);
  for (let i = 1; i < count; i++) {
    lengths[i] = lengths[i - 1]! + far(vertex(line, i), vertex(line, i - 1));
  }
  const whole = lengths[count - 1]!;
  if (!(whole > 0)) return [vertex(line, 0)];
  let at = 1;
  return Array.from({ length: samples }, (_, sample) => {
    const wanted = (whole * (sample + 0.5)) / samples;
    while (at < count - 1 && lengths[at]! < wanted) at++;
    const [before, after] = [lengths[at - 1]!, lengths[at]!];
    const part = after > before ? (wanted - before) / (after - before) : 0;
    const [p, q] = [vertex(line, at - 1), vertex(line, at)];
    return [0, 1, 2].map((axis) => p[axis]! + part * (q[axis]! - p[axis]!)) as [
      number,
      number,
      number,
    ];
  });
}

function blocksOf(line: ArrayLike<number>): Block[] {
  const last = Math.floor(line.length / 3) - 1;
  const blocks: Block[] = [];
  for (let first = 0; first === 0 || first < last; first += blockLength) {
    const end = Math.min(last, first + blockLength);
    const center = vertex(line, Math.floor((first + end) / 2));
    let radius = 0;
    for (let i = first; i <= end; i++) radius = Math.max(radius, far(center, vertex(line, i)));
    blocks.push({ center, radius, first, end });
  }
  return blocks;
}

function distanceTo(place: Place, line: ArrayLike<number>, blocks: readonly Block[]): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (const { center, radius, first, end } of blocks) {
    if (far(place, center) - radius >= nearest) continue;
    // A single vertex is a segment without length.
    for (let i = first; i < Math.max(end, first + 1); i++) {
      nearest = Math.min(nearest, toSegment(place, line, i, Math.min(i + 1, end)));
    }
  }
  return nearest;
}

function toSegment([x, y, z]: Place, line: ArrayLike<number>, from: number, to: number): number {
  const [px, py, pz] = vertex(line, from);
  const [qx, qy, qz] = vertex(line, to);
  const [dx, dy, dz] = [qx - px, qy - py, qz - pz];
  const square = dx * dx + dy * dy + dz * dz;
  const along = (x - px) * dx + (y - py) * dy + (z - pz) * dz;
  const part = square > 0 ? Math.min(1, Math.max(0, along / square)) : 0;
  return Math.hypot(x - px - part * dx, y - py - part * dy, z - pz - part * dz);
}
