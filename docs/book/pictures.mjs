// The pictures of the book's pages on algorithms, by the built package.
import { Picture } from './picture.mjs';

const colors = { curve: '#2450d8', center: '#0a8f78', other: '#d9560b', point: '#191c22' };

/** The color of a distance: blue near, yellow far. */
const heat = (part) => [0.25 + 0.7 * part, 0.35 + 0.5 * part, 0.85 - 0.6 * part];

/** Draws the picture of each page, by its name, on `see`, a picture of its surface. */
const drawings = {
  means({ mesh, see }) {
    const points = [
      [0.3, 0.62],
      [0.47, 0.78],
      [0.72, 0.6],
      [0.56, 0.5],
    ].map(([x, y]) => see.pick(x, y));
    const mean = mesh.centerOfMass(points, [0.25, 0.25, 0.25, 0.25]);
    see.surface();
    for (const point of points) {
      see.line(mesh.shortestPath(mean.point, point).polyline(), colors.curve, 3);
    }
    for (const point of points) see.dot(mesh.position(point), colors.point);
    see.dot(mean.position, colors.center, 18);
  },
  fields({ mesh, see }) {
    const center = see.pick(0.58, 0.66);
    see.surface();
    const { length } = mesh.circle(center, { radius: 0.05 * mesh.info.diagonal }).path;
    const normal = mesh.normal(center);
    const along = cross(normal, [0, 1, 0]);
    const across = cross(normal, along);
    for (let k = 0; k < 24; k++) {
      const angle = (k * Math.PI) / 12;
      const direction = along.map((one, x) => one * Math.cos(angle) + across[x] * Math.sin(angle));
      see.line(mesh.straightest(center, direction, length).path.polyline(), colors.curve, 2.5);
    }
    see.dot(mesh.position(center), colors.center, 18);
  },
  distances({ mesh, see }) {
    const source = see.pick(0.36, 0.6);
    const distances = mesh.distance(source, { solver: 'exact' });
    const farthest = distances.reduce((most, one) => Math.max(most, one), 0);
    see.surface((vertex) => heat(distances[vertex] / farthest));
    for (let k = 1; k < 20; k++) {
      for (const line of mesh.isolines(source, { radius: (k / 20) * farthest })) {
        see.line(line.polyline(), colors.point, 1.5);
      }
    }
    see.dot(mesh.position(source), colors.center, 18);
  },
  paths({ mesh, see }) {
    const from = see.pick(0.33, 0.55);
    see.surface();
    const ends = [
      [0.5, 0.84],
      [0.6, 0.74],
      [0.7, 0.7],
      [0.76, 0.6],
      [0.72, 0.5],
      [0.62, 0.42],
      [0.5, 0.45],
      [0.4, 0.78],
    ].map(([x, y]) => see.pick(x, y));
    for (const to of ends) see.line(mesh.shortestPath(from, to).polyline(), colors.curve, 3);
    for (const to of ends) see.dot(mesh.position(to), colors.point, 11);
    see.dot(mesh.position(from), colors.center, 18);
  },
  circles({ mesh, see }) {
    const center = see.pick(0.58, 0.66);
    see.surface();
    for (let k = 1; k <= 6; k++) {
      const { path } = mesh.circle(center, { radius: 0.035 * k * mesh.info.diagonal });
      see.line(path.polyline(), k % 2 ? colors.curve : colors.other, 3);
    }
    see.dot(mesh.position(center), colors.center, 14);
  },
  regions({ mesh, see }) {
    const { diagonal } = mesh.info;
    const outlines = [
      [0.5, 0.66],
      [0.62, 0.6],
    ].map(([x, y]) => mesh.circle(see.pick(x, y), { radius: 0.1 * diagonal }).path);
    const insides = mesh.regions(outlines);
    const triangles = mesh.triangles();
    const tints = [
      [0.83, 0.85, 0.89],
      [0.72, 0.79, 0.96],
      [0.98, 0.82, 0.68],
      [0.86, 0.72, 0.82],
    ];
    const cells = new Map();
    for (let corner = 0; corner < triangles.length; corner++) {
      const bary = [0, 1, 2].map((k) => +(k === corner % 3));
      const point = { face: Math.floor(corner / 3), bary };
      const cell = insides.reduce((sum, one, i) => sum + 2 ** i * one.contains(point), 0);
      cells.set(triangles[corner], cell);
    }
    see.surface((vertex) => tints[cells.get(vertex) ?? 0]);
    const [union] = mesh.regions(outlines, { combine: 'union' });
    for (const k of [1, 2, 3]) {
      const options = { distance: 0.012 * k * diagonal, side: 'both' };
      for (const line of mesh.offset(union.boundary(), options)) {
        see.line(line.polyline(), colors.point, 1.5);
      }
    }
    see.line(outlines[0].polyline(), colors.curve, 4);
    see.line(outlines[1].polyline(), colors.other, 4);
  },
  curves({ mesh, see }) {
    const points = [
      [0.34, 0.62],
      [0.44, 0.84],
      [0.56, 0.5],
      [0.68, 0.84],
      [0.74, 0.6],
    ].map(([x, y]) => see.pick(x, y));
    see.surface();
    for (let k = 1; k < points.length; k++) {
      see.line(mesh.shortestPath(points[k - 1], points[k]).polyline(), '#7d8796', 2);
    }
    see.line(mesh.curve({ kind: 'bspline', points }).polyline(), colors.curve, 5);
    for (const point of points) see.dot(mesh.position(point), colors.point, 11);
  },
  editing({ mesh, see }) {
    const places = [
      [0.32, 0.62],
      [0.44, 0.8],
      [0.56, 0.48],
      [0.66, 0.8],
      [0.76, 0.62],
    ];
    const points = places.map(([x, y]) => see.pick(x, y));
    const curve = mesh.curve({ kind: 'bspline', points });
    see.surface();
    see.line(curve.polyline(), '#9db0e8', 4);
    curve.movePoint(2, see.pick(0.56, 0.62));
    see.line(curve.polyline(), colors.curve, 5);
    for (const point of points) see.dot(mesh.position(point), colors.point, 11);
    see.dot(mesh.position(curve.points()[2]), colors.other, 16);
  },
};

const cross = (a, b) =>
  [0, 1, 2].map((x) => {
    const [y, z] = [(x + 1) % 3, (x + 2) % 3];
    return a[y] * b[z] - a[z] * b[y];
  });

/** PNGs by the names of their pages. */
export async function pictures() {
  const { load } = await import('../../dist/index.js');
  const { default: bunny } = await import('bunny');
  const karcher = await load();
  const coarse = karcher.meshFromArrays(bunny.positions.flat(), bunny.cells.flat());
  const mesh = coarse.subdivide(1);
  const made = new Map();
  for (const [name, draw] of Object.entries(drawings)) {
    const see = new Picture(mesh);
    draw({ mesh, see });
    made.set(name, see.png());
  }
  return made;
}
