import type { Fans } from './fans.js';

/**
 * A division of a surface into parts, each nearest to one of several sites. Squared distances are
 * linear in each triangle. Sites are added one after the other. In a triangle, a new site
 * takes points from the convex pieces of earlier sites: those nearer to the new site by more than
 * the rounding error.
 *
 * A corner of a piece is a vertex of the mesh or a point between two earlier corners. Such a point
 * arises if a site took one of the two earlier corners and not the other. The two earlier corners
 * identify the new corner. So the pieces on both sides of an edge share the new corner, even if they
 * lie in two triangles, and no gap opens, whatever the rounding.
 */

/** A convex part of a triangle, counterclockwise by its corners. */
export interface Piece {
  site: number;
  corners: number[];
}

/** The limit for the numbers of corners. Two numbers form a key that a double holds exactly. */
const mostCorners = 2 ** 26;

/**
 * The relative difference of squared distances that counts as rounding. A site must be nearer by
 * more than this.
 */
const rounding = 1e-12;

export class NearestPieces {
  /** x, y, z of each vertex, in the numbers of `Fans`. */
  readonly positions: Float64Array;
  /** 1 for each triangle that was turned over. */
  readonly turnedOver: Uint8Array;
  /** The vertices of each triangle. */
  readonly triangles: Int32Array;
  /**
   * The site to which a whole triangle belongs; -1 for no site, -2 for a triangle with pieces of
   * several sites.
   */
  readonly whole: Int32Array;

  /** The pieces of triangles that several sites share, or shared earlier. */
  readonly #pieces = new Map<number, Piece[]>();
  readonly #vertices: Int32Array;
  /**
   * The squared distance from each corner to its nearest site: first for vertices, then for the
   * other corners.
   */
  readonly #least: number[];
  readonly #site: Int32Array;
  /** For each corner that is no vertex, the vertices of its triangle and their weights, in turn. */
  readonly #blends: number[][] = [];
  readonly #between = new Map<number, number>();
  #sites = 0;

  constructor({ positions, corners, vertices, turnedOver }: Fans) {
    this.positions = positions;
    this.turnedOver = turnedOver;
    const count = vertices.length;
    this.#vertices = vertices;
    this.triangles = corners;
    this.whole = new Int32Array(corners.length / 3).fill(-1);
    this.#least = new Array<number>(count).fill(Infinity);
    this.#site = new Int32Array(count).fill(-1);
  }

  /** The nearest site of each of the caller's vertices in one of its fans, or -1. */
  nearest(): Int32Array {
    const number = this.#vertices.filter((vertex, i) => vertex === i);
    this.#vertices.forEach((vertex, i) => {
      if (this.#least[i]! < this.#least[number[vertex]!]!) number[vertex] = i;
    });
    return number.map((i) => this.#site[i]!);
  }

  /** Adds the next site by its distances to the vertices. */
  add(distances: Float64Array): void {
    const site = this.#sites++;
    const vertices = this.#site.length;
    const own = Array.from(this.#least, (_, corner) => {
      if (corner < vertices) return distances[corner]! ** 2;
      let sum = 0;
      const blend = this.#blends[corner - vertices]!;
      for (let i = 0; i < blend.length; i += 2) sum += blend[i + 1]! * distances[blend[i]!]! ** 2;
      return sum;
    });
    const isNearer = own.map((value, corner) => value < (1 - rounding) * this.#least[corner]!);
    for (let face = 0; face < this.whole.length; face++) {
      const pieces = this.of(face);
      if (!pieces.some(({ corners }) => corners.some((corner) => isNearer[corner]))) continue;
      this.#keep(
        face,
        pieces.flatMap((piece) => this.#divided(piece, site, own, isNearer)),
      );
    }
    isNearer.forEach((nearer, corner) => {
      if (!nearer) return;
      this.#least[corner] = own[corner]!;
      if (corner < vertices) this.#site[corner] = site;
    });
  }

  /**
   * The pieces of a triangle: one, or those of several sites, or none for a triangle that is no face
   * of the surface and so has a vertex at several corners.
   */
  of(face: number): readonly Piece[] {
    const pieces = this.#pieces.get(face);
    if (pieces) return pieces;
    const corners = this.#cornersOf(face);
    const [a, b, c] = corners;
    return a === b || b === c || c === a ? [] : [{ site: this.whole[face]!, corners }];
  }

  /**
   * Keeps the pieces of a triangle. If all belong to one site, they are merged into one piece. This
   * piece keeps the corners on the triangle's edges, since neighbors share them.
   */
  #keep(face: number, pieces: Piece[]): void {
    const [{ site }] = pieces as [Piece];
    if (pieces.some((piece) => piece.site !== site)) {
      this.whole[face] = -2;
      this.#pieces.set(face, pieces);
      return;
    }
    this.whole[face] = site;
    if (pieces.length === 1) {
      const [{ corners }] = pieces as [Piece];
      if (corners.length > 3) this.#pieces.set(face, pieces);
      return;
    }
    const all = [...new Set(pieces.flatMap(({ corners }) => corners))];
    const weights = new Map(all.map((corner) => [corner, this.weights(face, corner)]));
    const corners = [0, 1, 2].flatMap((k) => {
      const along = (corner: number) => weights.get(corner)![(k + 1) % 3]!;
      return all
        .filter((corner) => this.#isOnEdge(face, corner, k))
        .sort((one, other) => along(one) - along(other));
    });
    this.#pieces.set(face, [{ site, corners }]);
  }

  /**
   * Whether a corner is corner `k` of a triangle, or lies on the edge from it to the triangle's
   * next corner.
   */
  #isOnEdge(face: number, corner: number, k: number): boolean {
    const at = this.#cornersOf(face);
    if (corner < this.#site.length) return corner === at[k];
    const blend = this.#blend(corner);
    return (
      blend.length === 4 &&
      [at[k], at[(k + 1) % 3]].every((vertex) => vertex === blend[0] || vertex === blend[2])
    );
  }

  /** A key for two corners, in either order. */
  key(a: number, b: number): number {
    return Math.min(a, b) * mostCorners + Math.max(a, b);
  }

  /** The barycentric weights of a corner of a piece in its triangle. */
  weights(face: number, corner: number): [number, number, number] {
    const weights: [number, number, number] = [0, 0, 0];
    const at = this.#cornersOf(face);
    const blend = this.#blend(corner);
    for (let i = 0; i < blend.length; i += 2) weights[at.indexOf(blend[i]!)] = blend[i + 1]!;
    return weights;
  }

  #cornersOf(face: number): number[] {
    return Array.from(this.triangles.subarray(3 * face, 3 * face + 3));
  }

  #blend(corner: number): readonly number[] {
    const vertices = this.#site.length;
    return corner < vertices ? [corner, 1] : this.#blends[corner - vertices]!;
  }

  /**
   * The two parts of a piece: one without the points that are nearer to the new site, and one with
   * only these points. If one of them would be empty, the result is only the other one.
   */
  #divided(piece: Piece, site: number, own: number[], isNearer: readonly boolean[]): Piece[] {
    const { corners } = piece;
    if (!corners.some((corner) => isNearer[corner])) return [piece];
    if (corners.every((corner) => isNearer[corner])) return [{ site, corners }];
    // If no path leads to a corner, such as a corner where parts only touch, the piece stays whole.
    if (corners.some((corner) => !Number.isFinite(own[corner]! - this.#least[corner]!))) {
      return [piece];
    }
    const [kept, taken]: [number[], number[]] = [[], []];
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % corners.length]!;
      (isNearer[corner] ? taken : kept).push(corner);
      if (isNearer[corner] === isNearer[next]) return;
      const middle = this.#put(corner, next, own);
      kept.push(middle);
      taken.push(middle);
    });
    return [
      { site: piece.site, corners: kept },
      { site, corners: taken },
    ];
  }

  /** The corner between two others at which the new site is as near as the nearest earlier site. */
  #put(one: number, other: number, own: number[]): number {
    const name = this.key(one, other);
    const known = this.#between.get(name);
    if (known !== undefined) return known;
    const [a, b] = [Math.min(one, other), Math.max(one, other)];
    const [from, to] = [own[a]! - this.#least[a]!, own[b]! - this.#least[b]!];
    const part = Math.min(1, Math.max(0, from / (from - to)));
    const sums = new Map<number, number>();
    for (const [corner, share] of [
      [a, 1 - part],
      [b, part],
    ] as const) {
      const blend = this.#blend(corner);
      for (let i = 0; i < blend.length; i += 2) {
        sums.set(blend[i]!, (sums.get(blend[i]!) ?? 0) + share * blend[i + 1]!);
      }
    }
    const corner = this.#least.length;
    this.#between.set(name, corner);
    this.#blends.push([...sums].flat());
    this.#least.push((1 - part) * this.#least[a]! + part * this.#least[b]!);
    return corner;
  }
}
