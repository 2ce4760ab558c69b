// The points where a path and a curve cross the mesh's edges, as an OBJ file of lines.
import { load } from 'karcher';

const karcher = await load();
const mesh = karcher.shape('torus', 5000);
const points = [{ vertex: 10 }, { vertex: 400 }, { vertex: 900 }, { vertex: 1200 }];

const path = mesh.shortestPath(points[0], points[3]);
const curve = mesh.curve({ kind: 'bspline', points, geometry: 'exact' });

const lines = [];
let first = 1;
for (const line of [path, curve.path()]) {
  const places = line.polyline({ bits: 64 });
  for (let i = 0; i < places.length; i += 3) lines.push(`v ${places.slice(i, i + 3).join(' ')}`);
  lines.push(`l ${Array.from({ length: line.count }, (_, i) => first + i).join(' ')}`);
  first += line.count;
}
// Neighbouring points share a face, so that inserting them cuts a mesh.
console.log(`${path.count} points of the path, ${curve.path().count} of the curve`);
console.log(lines.slice(0, 3).join('\n'));
