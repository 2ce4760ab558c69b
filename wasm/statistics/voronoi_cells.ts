import type { EnginePath } from '../karcher-engine.mjs';
import { Path } from '../path.js';
import { Region } from '../region.js';
import type { NearestPieces } from './nearest_pieces.js';

/** A line on which two sites are equally near and all others are farther away. */
export interface VoronoiBorder {
  /**
   * The numbers of the two sites, the lower one first. The cell of the lower one lies to the left
   * of the path.
   */
  between: [number, number];
  /** The line, from triangle to triangle. */
  path: Path;
}

/** A side of a piece in its triangle, with the piece to its left on the surface. */
interface Side {
  face: number;
  site: number;
  from: number;
  to: number;
}

type Place = readonly [number, number, number];

/** The area of each site's pieces. */
export function areasOf(pieces: NearestPieces, sites: number): Float64Array {
  const areas = new Float64Array(sites);
  for (let face = 0; face < pieces.whole.length; face++) {
    for (const { site, corners } of pieces.of(face)) {
      if (site >= 0) areas[site]! += areaOf(pieces, face, corners);
    }
  }
  return areas;
}

/** The lines between cells, in the order of their sites. */
export function bordersOf(pieces: NearestPieces): VoronoiBorder[] {
  const between = new Map<string, Side[]>();
  for (const sides of sidesOf(pieces).values()) {
    const [one, other] = [...sides].sort((a, b) => a.site - b.site);
    if (!other || one!.site === other.site || one!.site < 0) continue;
    const name = `${one!.site},${other.site}`;
    if (!between.has(name)) between.set(name, []);
    between.get(name)!.push(one!);
  }
  const names = [...between.keys()].map((name) => name.split(',').map(Number) as [number, number]);
  names.sort(([a, b], [c, d]) => a - c || b - d);
  return names.flatMap((pair) =>
    joined(pieces, between.get(pair.join())!).map((path) => ({ between: pair, path })),
  );
}

/** The cell of a site. */
export function regionOf(pieces: NearestPieces, site: number): Region {
  const share = pieces.whole.map((whole, face) =>
    whole === site ? 1 : pieces.of(face).some((piece) => piece.site === site) ? 2 : 0,
  );
  const triangles: number[] = [];
  const sides: number[] = [];
  let area = 0;
  for (let face = 0; face < share.length; face++) {
    if (share[face] === 0) continue;
    for (const { site: of, corners } of pieces.of(face)) {
      if (of !== site) continue;
      area += areaOf(pieces, face, corners);
      if (share[face] === 1) continue;
      const weights = corners.map((corner) => pieces.weights(face, corner));
      weights.forEach(([, x, y], i) => {
        const [, nextX, nextY] = weights[(i + 1) % weights.length]!;
        triangles.push(face);
        sides.push(x, y, nextX, nextY);
      });
    }
  }
  const bounding: Side[] = [];
  for (const all of sidesOf(pieces).values()) {
    const own = all.filter((side) => side.site === site);
    if (own.length % 2 === 1) bounding.push(own[0]!);
  }
  const boundary = joined(pieces, bounding);
  return new Region({
    area,
    perimeter: boundary.reduce((sum, { length }) => sum + length, 0),
    boundary: boundary.map((path) => path.data()),
    share: Uint8Array.from(share),
    triangles: Int32Array.from(triangles),
    sides: Float64Array.from(sides),
  });
}

/** The sides of all pieces, by the key of the two corners of a side. */
function sidesOf(pieces: NearestPieces): Map<number, Side[]> {
  const all = new Map<number, Side[]>();
  for (let face = 0; face < pieces.whole.length; face++) {
    for (const { site, corners } of pieces.of(face)) {
      corners.forEach((from, i) => {
        const to = corners[(i + 1) % corners.length]!;
        if (from === to) return;
        const name = pieces.key(from, to);
        const [start, end] = pieces.turnedOver[face] ? [to, from] : [from, to];
        if (!all.has(name)) all.set(name, []);
        all.get(name)!.push({ face, site, from: start, to: end });
      });
    }
  }
  return all;
}

/**
 * Sides joined into paths: open paths first, then closed ones. Paths without length are left out.
 */
function joined(pieces: NearestPieces, sides: readonly Side[]): Path[] {
  const at = new Map<number, Side[]>();
  const ends = new Map<number, number>();
  for (const side of sides) {
    if (!at.has(side.from)) at.set(side.from, []);
    at.get(side.from)!.push(side);
    ends.set(side.from, (ends.get(side.from) ?? 0) + 1);
    ends.set(side.to, (ends.get(side.to) ?? 0) - 1);
  }
  const left = new Set(sides);
  const paths: Path[] = [];
  const follow = (start: Side) => {
    const points = [{ face: start.face, corner: start.from }];
    let corner = start.from;
    for (let side: Side | undefined = start; side; ) {
      left.delete(side);
      corner = side.to;
      points.push({ face: side.face, corner });
      side = at.get(corner)?.find((other) => left.has(other));
    }
    const path = pathOf(pieces, points);
    if (path.length > 0) paths.push(new Path(path));
  };
  for (const side of sides) if (left.has(side) && ends.get(side.from)! > 0) follow(side);
  for (const side of sides) if (left.has(side)) follow(side);
  return paths;
}

function pathOf(
  pieces: NearestPieces,
  corners: readonly { face: number; corner: number }[],
): EnginePath {
  const face: number[] = [];
  const bary: number[] = [];
  const position: number[] = [];
  const lengths: number[] = [];
  let length = 0;
  let last: Place | undefined;
  for (const { face: of, corner } of corners) {
    const weights = pieces.weights(of, corner);
    const place = placeOf(pieces, of, weights);
    const step = last ? Math.hypot(...place.map((value, k) => value - last![k]!)) : 0;
    if (last && step === 0) continue;
    length += step;
    last = place;
    face.push(of);
    bary.push(...weights);
    position.push(...place);
    lengths.push(length);
  }
  return {
    closed: corners.length > 2 && corners[0]!.corner === corners.at(-1)!.corner,
    length,
    face: Int32Array.from(face),
    bary: Float64Array.from(bary),
    position: Float64Array.from(position),
    lengths: Float64Array.from(lengths),
  };
}

function placeOf(pieces: NearestPieces, face: number, weights: Place): Place {
  const { positions, triangles } = pieces;
  const place: [number, number, number] = [0, 0, 0];
  weights.forEach((weight, k) => {
    const vertex = 3 * triangles[3 * face + k]!;
    for (let i = 0; i < 3; i++) place[i]! += weight * positions[vertex + i]!;
  });
  return place;
}

/** The area of a piece, by triangles that fan out from its first corner. */
function areaOf(pieces: NearestPieces, face: number, corners: readonly number[]): number {
  const places = corners.map((corner) => placeOf(pieces, face, pieces.weights(face, corner)));
  const [first, ...others] = places as [Place, ...Place[]];
  let twice = 0;
  for (let i = 0; i + 1 < others.length; i++) {
    const [u, v] = [others[i]!, others[i + 1]!].map((to) => to.map((x, k) => x - first[k]!)) as [
      number[],
      number[],
    ];
    twice += Math.hypot(
      u[1]! * v[2]! - u[2]! * v[1]!,
      u[2]! * v[0]! - u[0]! * v[2]!,
      u[0]! * v[1]! - u[1]! * v[0]!,
    );
  }
  return twice / 2;
}
