// Random curves for cuts of surfaces.
import { randomFrom } from '../web/part.mjs';

/** The vertices of a mesh's boundary. */
export function rimVertices(mesh) {
  const triangles = mesh.triangles();
  const count = mesh.info.vertices;
  const edges = new Set();
  const next = (i) => triangles[i - (i % 3) + ((i + 1) % 3)];
  for (const [i, tail] of triangles.entries()) edges.add(tail * count + next(i));
  return [...new Set(triangles.filter((tail, i) => !edges.has(next(i) * count + tail)))];
}

const closedKinds = ['polyline', 'bspline', 'catmullrom', 'bezier'];

/** One to three curves: closed ones around random places, and ones from rim to rim. */
export function randomCut(mesh, rim, seed) {
  const random = randomFrom(seed);
  const index = (count) => Math.floor(random() * count);
  const randomPoint = () => {
    const [u, v] = [random(), random()];
    const [b1, b2] = u + v < 1 ? [u, v] : [1 - u, 1 - v];
    return { face: index(mesh.info.triangles), bary: [1 - b1 - b2, b1, b2] };
  };
  const loop = () => {
    const middle = randomPoint();
    const reach = mesh.info.diagonal * 10 ** (-2.5 + 2 * random());
    const count = 3 + index(8);
    const ways = Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * (i + random())) / count;
      const radius = reach * (0.4 + 0.6 * random());
      return [radius * Math.cos(angle), radius * Math.sin(angle), reach * (2 * random() - 1)];
    });
    return { points: mesh.expMap(middle, ways).points, closed: true };
  };
  const crossing = () => {
    const [from, to] = [{ vertex: rim[index(rim.length)] }, { vertex: rim[index(rim.length)] }];
    return { points: [from, to], closed: false };
  };
  const paths = [];
  const count = 1 + index(3);
  for (let tries = 0; paths.length < count && tries < 20; tries++) {
    const { points, closed } = rim.length > 1 && random() < 0.4 ? crossing() : loop();
    try {
      const kind = closed ? closedKinds[index(closedKinds.length)] : 'polyline';
      const curve = mesh.curve({ kind, points, closed, samples: 32 });
      const path = curve.path();
      curve.dispose();
      if (path.length > 0) paths.push(path);
    } catch (error) {
      // Points of two components, and repeated points, have no path.
      if (error.name !== 'KarcherError') throw error;
    }
  }
  return paths;
}
