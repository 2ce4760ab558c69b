import { Places } from '../places.js';
import type { NearBoundaries } from './index.js';

/** How near boundaries lie on each other, as a part of the diagonal. */
const nearness = 1e-4;
/** Vertices nearer to each other than this part of their shortest edge are taken for one. */
const partOfEdge = 1 / 3;

interface Vertex {
  place: [number, number, number];
  /** The length of its shortest edge on the boundary. */
  shortest: number;
  neighbours: number[];
}

/**
 * Boundaries that lie on each other: vertices within 1e-4 of the diagonal, and a third of their
 * shortest edge, of another one that no edge joins them with. `edges` has both ends of each.
 */
export function nearBoundaries(edges: Float64Array, diagonal: number): NearBoundaries | null {
  const vertices = verticesOf(edges);
  const reach = nearness * diagonal;
  const cells = new Map<string, number[]>();
  const cellOf = (place: readonly number[]) => place.map((x) => Math.floor(x / reach));
  for (const [i, { place }] of vertices.entries()) {
    const key = `${cellOf(place)}`;
    const cell = cells.get(key);
    if (cell) cell.push(i);
    else cells.set(key, [i]);
  }
  const places: number[] = [];
  let farthest = 0;
  for (const [i, vertex] of vertices.entries()) {
    const nearest = nearestTo(i, vertex);
    if (nearest === Infinity) continue;
    places.push(...vertex.place);
    farthest = Math.max(farthest, nearest);
  }
  if (places.length === 0) return null;
  return { places: Float64Array.from(places), weld: roundedUp(farthest) };

  function nearestTo(i: number, { place, shortest, neighbours }: Vertex): number {
    const [x, y, z] = cellOf(place) as [number, number, number];
    let nearest = Infinity;
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        for (let dz = -1; dz <= 1; dz++) {
          for (const j of cells.get(`${[x + dx, y + dy, z + dz]}`) ?? []) {
            if (j === i || neighbours.includes(j)) continue;
            const other = vertices[j]!;
            const distance = Math.hypot(...place.map((value, axis) => value - other.place[axis]!));
            const most = Math.min(reach, partOfEdge * Math.min(shortest, other.shortest));
            if (distance <= most) nearest = Math.min(nearest, distance);
          }
        }
      }
    }
    return nearest;
  }
}

function verticesOf(edges: Float64Array): Vertex[] {
  const places = new Places();
  const vertices: Vertex[] = [];
  const vertexAt = (at: number) => {
    const place: Vertex['place'] = [edges[at]!, edges[at + 1]!, edges[at + 2]!];
    const number = places.number(...place);
    vertices[number] ??= { place, shortest: Infinity, neighbours: [] };
    return number;
  };
  for (let at = 0; at < edges.length; at += 6) {
    const [i, j] = [vertexAt(at), vertexAt(at + 3)];
    const [from, to] = [vertices[i]!, vertices[j]!];
    const length = Math.hypot(...from.place.map((value, axis) => value - to.place[axis]!));
    for (const [vertex, other] of [[from, j] as const, [to, i] as const]) {
      vertex.shortest = Math.min(vertex.shortest, length);
      vertex.neighbours.push(other);
    }
  }
  return vertices;
}

/** To two digits, and a little more than the length itself. */
function roundedUp(length: number): number {
  const unit = 10 ** (Math.floor(Math.log10(length)) - 1);
  return Number((Math.ceil((1.01 * length) / unit) * unit).toPrecision(2));
}
