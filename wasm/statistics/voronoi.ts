import { checkArray } from '../check.js';
import { KarcherError } from '../errors.js';
import type { Region } from '../region.js';
import type { DistanceOptions, PointLike } from '../types.js';
import type { AnyMesh } from './energy.js';
import { type Fans, fansOf, inFace } from './fans.js';
import { NearestPieces } from './nearest_pieces.js';
import { areasOf, bordersOf, regionOf, type VoronoiBorder } from './voronoi_cells.js';

/** A site of a Voronoi diagram: a point, or several points of which the nearest counts. */
export type Site = PointLike | readonly PointLike[];

/**
 * A division of a surface into cells, each nearest to one of several sites. The diagram needs no
 * mesh and has no `dispose`.
 */
export interface VoronoiDiagram {
  /**
   * The number of the nearest site for each vertex; the lowest number if several sites are equally
   * near, and -1 for unreachable vertices.
   */
  nearest: Int32Array;
  /** The area of each site's cell, in squared units of the mesh. */
  areas: Float64Array;
  /** The lines between cells. */
  borders: VoronoiBorder[];
  /**
   * The cell of a site as a region, such as for `centroid`. Throws `KarcherError` badIndex if there
   * is no such site.
   */
  cell(site: number): Region;
}

/**
 * The Voronoi diagram of sites: the surface divided into cells, each with the points that are
 * nearest to one site.
 *
 * In every triangle, squared distances are interpolated linearly between the vertices. So the
 * borders are exact on a plane; on smooth surfaces their error is of the order of the squared edge
 * length. Each site takes one field of distances. If sites coincide, the first site has the cell,
 * and the others have empty cells. Where a connected part of the surface touches itself at a vertex,
 * all faces there count with the vertex's one distance.
 *
 * Rejects with `KarcherError` tooFewPoints without sites, or for a site without points, and as
 * `Mesh.distance` does.
 *
 * @example
 * ```ts
 * const { areas, borders, cell } = await voronoi(mesh, [{ vertex: 12 }, { vertex: 340 }]);
 * (await centroid(mesh, cell(0))).point;
 * ```
 */
export async function voronoi(
  mesh: AnyMesh,
  sites: readonly Site[],
  options: DistanceOptions = {},
): Promise<VoronoiDiagram> {
  if (checkArray(sites, 'the sites').length === 0) {
    throw new KarcherError('tooFewPoints', 'a Voronoi diagram needs at least one site');
  }
  const fans = await fansOf(mesh);
  const found = new NearestPieces(fans);
  for (const site of sites) {
    const given = await mesh.distance(site, options);
    found.add(await distancesOf(mesh, fans, { site, given, options }));
  }
  return {
    nearest: found.nearest(),
    areas: areasOf(found, sites.length),
    borders: bordersOf(found),
    cell: (site) => {
      if (Number.isInteger(site) && site >= 0 && site < sites.length) return regionOf(found, site);
      const sentence = `there is no site ${site}: the diagram has ${sites.length}`;
      throw new KarcherError('badIndex', sentence);
    },
  };
}

/**
 * The distances of a site to the vertices in all their fans. `given` has the distance of each vertex
 * in its nearest fan. Where parts touch, each has the distances of the site's points on it.
 */
async function distancesOf(
  mesh: AnyMesh,
  { corners, vertices, parts }: Fans,
  { site, given, options }: { site: Site; given: Float64Array; options: DistanceOptions },
): Promise<Float64Array> {
  if (!parts) return given;
  const byPart = new Map<number, PointLike[]>();
  for (const point of [site].flat() as PointLike[]) {
    const part = parts[corners[3 * (await inFace(mesh, point)).face]!]!;
    byPart.set(part, [...(byPart.get(part) ?? []), point]);
  }
  const own = new Map<number, Float64Array>();
  for (const [part, points] of byPart) {
    own.set(part, byPart.size > 1 ? await mesh.distance(points, options) : given);
  }
  // A vertex of no face may be welded to another one.
  own.set(-1, given);
  return Float64Array.from(
    vertices,
    (vertex, number) => own.get(parts[number]!)?.[vertex] ?? Number.NaN,
  );
}
