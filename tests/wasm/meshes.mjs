// Small meshes as OBJ files.

/** A square of unit side with one polygon:
 *
 *    3 --- 2
 *    |     |
 *    0 --- 1
 */
export const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';

export const tetrahedron =
  'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';

/**
 * A flat grid of `cells` by `cells` unit squares, each cut along the diagonal from its lower left.
 * Vertex i + (cells + 1) j lies at (i, j, 0); triangles 2 k and 2 k + 1 form square k.
 */
export function grid(cells) {
  const lines = [];
  for (let j = 0; j <= cells; j++) {
    for (let i = 0; i <= cells; i++) lines.push(`v ${i} ${j} 0`);
  }
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const a = i + (cells + 1) * j + 1;
      const c = a + cells + 1;
      lines.push(`f ${a} ${a + 1} ${c + 1}`, `f ${a} ${c + 1} ${c}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/**
 * A tube of radius 1 and height 1 with this many flat sides and rows: faces 2 k and 2 k + 1 are
 * side k of the lowest row.
 */
export function tube(sides, rows) {
  const lines = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i < sides; i++) {
      const angle = (2 * Math.PI * i) / sides;
      lines.push(`v ${Math.cos(angle)} ${Math.sin(angle)} ${j / rows}`);
    }
  }
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < sides; i++) {
      const a = 1 + i + sides * j;
      const b = 1 + ((i + 1) % sides) + sides * j;
      lines.push(`f ${a} ${b} ${b + sides}`, `f ${a} ${b + sides} ${a + sides}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** All options for fields; the first is the default. */
export const fields = [
  {},
  { method: 'karcher', solver: 'fast' },
  { method: 'karcher', solver: 'exact' },
  { method: 'karcher', solver: 'graph', rings: 3 },
  { method: 'paper', solver: 'exact' },
  { method: 'paper', solver: 'graph', rings: 3 },
];

/** The options for the distances of a field. */
export const distancesOf = ({ method: _, ...distances }) => distances;

/** The options with exact distances on a plane. */
export const exactFields = fields.filter(({ solver }) => solver !== 'graph');

/** Files without a mesh: the fault, the code of the error, and a word of it. */
export const badFiles = [
  { what: 'an empty file', text: '', code: 'badFile', says: /no faces/ },
  { what: 'a file without faces', text: 'v 0 0 0\nv 1 0 0\n', code: 'badFile', says: /no faces/ },
  { what: 'a file that is no OBJ', text: '\0\x01\x02', code: 'badFile', says: /text/ },
  {
    what: 'a vertex that does not exist',
    text: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n',
    code: 'badIndex',
    says: /9/,
  },
  {
    what: 'an edge of three faces',
    text: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n',
    code: 'nonManifoldEdge',
    says: /edge/,
  },
  {
    what: 'a vertex of two fans',
    text: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n',
    code: 'nonManifoldVertex',
    says: /vertex 0/,
  },
  {
    what: 'a coordinate that is no number',
    text: 'v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n',
    code: 'notFinite',
    says: /line 2/,
  },
  {
    what: 'a face without area',
    text: 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n',
    code: 'degenerateFace',
    says: /face 0/,
  },
];

/** All properties of a path, for comparison. */
export const partsOf = (path) => ({
  length: path.length,
  closed: path.closed,
  count: path.count,
  points: path.points(),
  lengths: path.lengths(),
  polyline: path.polyline({ bits: 64 }),
});

/** The index of the mesh's vertex that is nearest to a place. */
export function nearestVertex(mesh, place) {
  const positions = mesh.positions();
  let nearest = 0;
  const away = (v) => distance(Array.from(positions.slice(3 * v, 3 * v + 3)), place);
  for (let v = 1; 3 * v < positions.length; v++) if (away(v) < away(nearest)) nearest = v;
  return nearest;
}

export function distance(a, b) {
  return Math.hypot(...a.map((x, i) => x - b[i]));
}

/**
 * A function that draws on the mesh of a grid: it returns the closed path through places (x, y).
 */
export function drawingOn(mesh, cells) {
  /** The point at (x, y); squares are cut from their lower left. */
  function at([x, y]) {
    const [i, j] = [x, y].map((value) => Math.min(Math.floor(value), cells - 1));
    const [u, v] = [x - i, y - j];
    const face = 2 * (i + cells * j) + (u >= v ? 0 : 1);
    return { face, bary: u >= v ? [1 - u, u - v, v] : [1 - v, u, v - u] };
  }
  return function outlineOf(corners) {
    const points = corners.map(at);
    return points.flatMap((point, i) => {
      const leg = mesh.shortestPath(point, points[(i + 1) % points.length]).points();
      return i < points.length - 1 ? leg.slice(0, -1) : leg;
    });
  };
}
