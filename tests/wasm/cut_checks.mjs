// Properties that every cut mesh and the files of its parts must have.
import { solidOf } from 'karcher/checkup';
import { meshFile, meshFromFile, writtenFormats } from 'karcher/formats';

const minus = (a, b) => a.map((x, k) => x - b[k]);
const norm = (a) => Math.hypot(...a);
const cross = (u, v) =>
  [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]);

const placeOf = ({ positions }, vertex) => positions.slice(3 * vertex, 3 * vertex + 3);

/** The edges that belong to a single triangle, as the places of their ends. */
export function rimOf(part) {
  const { triangles } = part;
  const next = (i) => triangles[i - (i % 3) + ((i + 1) % 3)];
  const edges = new Set();
  for (let i = 0; i < triangles.length; i++) edges.add(`${triangles[i]} ${next(i)}`);
  return [...edges]
    .map((edge) => edge.split(' ').map(Number))
    .filter(([tail, head]) => !edges.has(`${head} ${tail}`))
    .map((ends) => ends.map((vertex) => placeOf(part, vertex)));
}

/**
 * The rims of parts that do not match another rim in the opposite direction, place by place. If all
 * parts fit to the last bit, these are the surface's own boundary.
 */
function openEdges(parts) {
  const sides = new Map();
  for (const part of parts) {
    for (const [tail, head] of rimOf(part)) {
      const [there, back] = [
        `${tail.join(' ')}/${head.join(' ')}`,
        `${head.join(' ')}/${tail.join(' ')}`,
      ];
      if (sides.has(back)) {
        const { count } = sides.get(back);
        if (count > 1) sides.get(back).count--;
        else sides.delete(back);
      } else {
        const known = sides.get(there);
        if (known) known.count++;
        else sides.set(there, { count: 1, length: norm(minus(tail, head)) });
      }
    }
  }
  return [...sides.values()];
}

const openLength = (parts) =>
  openEdges(parts).reduce((sum, { count, length }) => sum + count * length, 0);

/**
 * Whether a part lies on both sides of a stretch of its border: readers of files close such a slit.
 */
const hasSlit = (part) =>
  openEdges([part]).reduce((sum, { count }) => sum + count, 0) < rimOf(part).length;

/** The vertices whose triangles do not form a single fan. */
function splitVertices({ positions, triangles }) {
  const parent = Int32Array.from(triangles, (_, i) => i);
  const find = (i) => {
    let root = i;
    while (parent[root] !== root) root = parent[root];
    for (let at = i; parent[at] !== root; ) [at, parent[at]] = [parent[at], root];
    return root;
  };
  const cornerOf = new Map();
  const next = (i) => i - (i % 3) + ((i + 1) % 3);
  for (const [i, tail] of triangles.entries()) cornerOf.set(`${tail} ${triangles[next(i)]}`, i);
  triangles.forEach((tail, i) => {
    const other = cornerOf.get(`${triangles[next(i)]} ${tail}`);
    if (other === undefined) return;
    parent[find(i)] = find(next(other));
    parent[find(next(i))] = find(other);
  });
  const fans = new Int32Array(positions.length / 3);
  parent.forEach((_, i) => {
    if (find(i) === i) fans[triangles[i]]++;
  });
  return fans.reduce((sum, count) => sum + (count === 1 ? 0 : 1), 0);
}

/** The least height of a triangle, in units of the mesh. */
export function leastHeight(part) {
  const { triangles } = part;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [...placeOf(part, triangles[i + k])]);
    const [u, v] = [minus(b, a), minus(c, a)];
    const longest = Math.max(norm(u), norm(v), norm(minus(b, c)));
    least = Math.min(least, norm(cross(u, v)) / longest);
  }
  return least;
}

/** Whether a part has two vertices at one place: readers keep such vertices apart. */
const touchesItself = ({ positions }) => {
  const places = new Set();
  for (let i = 0; i < positions.length; i += 3) places.add(positions.slice(i, i + 3).join(' '));
  return places.size < positions.length / 3;
};

/**
 * The surface under the cut: `mesh.cut([])` as `whole`, its area and the length of its boundary,
 * and whether it touches itself along edges that had more than two faces in its file.
 */
export function surfaceOf(mesh) {
  const whole = mesh.cut([]);
  const area = whole.reduce((sum, part) => sum + solidOf(part).area, 0);
  const isBranched = mesh.info.repairs.some(({ kind }) => kind === 'branching');
  return { whole, area, open: openLength(whole), isBranched, diagonal: mesh.info.diagonal };
}

/**
 * The faults of parts as sentences, and the measurements: `areaError` as a part of the surface's
 * area, `height` as one of its diagonal.
 */
export function checkedParts(parts, surface) {
  const faults = [];
  let area = 0;
  let height = Number.POSITIVE_INFINITY;
  parts.forEach((part, i) => {
    const solid = solidOf(part);
    area += solid.area;
    height = Math.min(height, leastHeight(part) / surface.diagonal);
    if (!solid.oriented) faults.push(`part ${i} is not oriented`);
    const split = splitVertices(part);
    if (split > 0) faults.push(`part ${i} has ${split} vertices that are no single fan`);
  });
  const open = Math.abs(openLength(parts) - surface.open) / surface.diagonal;
  if (open > 1e-9) faults.push(`borders that do not fit are ${open.toPrecision(2)} diagonals long`);
  const areaError = Math.abs(area - surface.area) / surface.area;
  if (areaError > 1e-12) faults.push(`areas are off by ${areaError.toPrecision(2)}`);
  if (!(height > 0)) faults.push('there is a face without area');
  return { faults, areaError, height };
}

/**
 * The faults of files of parts. Each must open without a repair, unless the part touches itself or
 * has a slit.
 */
export async function checkedFiles(karcher, parts, surface) {
  const faults = [];
  let files = 0;
  let slits = 0;
  for (const [i, part] of parts.entries()) {
    const touches = touchesItself(part);
    const slit = hasSlit(part);
    slits += slit ? 1 : 0;
    const meant = [
      ...(touches ? ['keptApart', 'bowTie'] : []),
      ...(touches && surface.isBranched ? ['branching'] : []),
      ...(slit ? ['welded'] : []),
    ];
    for (const format of writtenFormats) {
      const bytes = meshFile(part, format);
      files++;
      const tell = (what) =>
        faults.push(`part ${i} of ${part.triangles.length / 3} as ${format}: ${what}`);
      try {
        const { mesh } = await meshFromFile(karcher, bytes, {
          name: `part.${format}`,
          repair: touches ? 'safe' : 'none',
        });
        const kinds = mesh.info.repairs.map(({ kind }) => kind);
        const own = kinds.filter((kind) => !meant.includes(kind));
        if (own.length > 0) tell(`read with ${own.join(', ')}`);
        mesh.dispose();
      } catch (error) {
        tell(error.message);
      }
    }
  }
  return { faults, files, slits };
}
