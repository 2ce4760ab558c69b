// The processor's time for regions in WebAssembly on 70,000 triangles: the regions of polygons of some thousand
// points, and the steps of a drag of a curve of sixty points, such as twenty Bézier segments have, with its region
// and one boolean operation.
//
//   npm run study -- region_times
import { load } from 'karcher';
import { randomFrom } from '../web/part.mjs';

const karcher = await load();
const row = (...cells) => console.log(`| ${cells.join(' | ')} |`);
const random = randomFrom(7);

/** The median processor time in milliseconds of calls with different indices. */
function milliseconds(call, times) {
  const took = Array.from({ length: times }, (_, i) => {
    const before = process.cpuUsage();
    call(i);
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  });
  return took.toSorted((a, b) => a - b)[times >> 1].toFixed(1);
}

row('surface', 'what', 'asked', 'median');
row(...Array(4).fill('---'));
for (const name of ['sphere', 'torus']) {
  const mesh = karcher.shape(name, 70_000);
  const loop = (face, count, reach) => {
    const ways = Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * i) / count;
      const radius = reach * mesh.info.diagonal * (0.8 + 0.4 * random());
      return [radius * Math.cos(angle), radius * Math.sin(angle), radius * Math.sin(angle + 1)];
    });
    return mesh.expMap({ face, bary: [0.3, 0.3, 0.4] }, ways).points;
  };
  const polygon = (face, reach) => {
    const curve = mesh.curve({ kind: 'polyline', closed: true, points: loop(face, 8, reach) });
    const path = curve.path();
    curve.dispose();
    return path;
  };
  const polygons = [1000, 12_000, 30_000, 50_000].map((face) => polygon(face, 0.016));
  const count = polygons.reduce((sum, path) => sum + path.count, 0);
  const tiny = mesh.circle({ vertex: 100 }, { radius: 0.01 * mesh.info.diagonal }).path;
  row(
    name,
    'a region of a small circle',
    '',
    milliseconds(() => mesh.regions([tiny]), 15),
  );
  const regions = () => mesh.regions(polygons);
  regions();
  row(name, `cells and regions of 4 polygons, ${count} points`, '40 ms', milliseconds(regions, 15));

  const points = loop(20_000, 60, 0.1);
  const curve = mesh.curve({ kind: 'bspline', closed: true, points, samples: 32 });
  const other = polygon(20_200, 0.08);
  const [from] = points;
  const step = (i) => {
    const way = [0.0005, 0.001, 0.0005].map((x) => x * mesh.info.diagonal * ((i % 20) + 1));
    curve.dragPoint(0, mesh.expMap(from, [way]).points[0]);
    return curve.path();
  };
  for (let i = 0; i < 20; i++) step(i);
  row(name, 'a step of a B-spline of 60 points', '', milliseconds(step, 41));
  const whole = (i) => {
    const path = step(i);
    mesh.regions([path]);
    return mesh.regions([path, other], { combine: 'union' });
  };
  row(name, 'the same with its region and a union', '16 ms', milliseconds(whole, 41));
  mesh.dispose();
}
