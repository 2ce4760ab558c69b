// The center of mass of four points, whether it is unique, and weights that give another point.
import { load } from 'karcher';

const karcher = await load();
const mesh = karcher.shape('torus', 5000);
const points = [{ vertex: 10 }, { vertex: 40 }, { vertex: 300 }, { vertex: 340 }];

const mean = mesh.centerOfMass(points, [0.1, 0.4, 0.4, 0.1], { uniqueness: true });
console.log(`${mean.status} at ${mean.position.map((x) => x.toFixed(3))}; ${mean.uniqueness}`);

const { weights } = mesh.weightsOf(points[0], points);
console.log(`weights for the first point: ${[...weights].map((x) => x.toFixed(2))}`);
mesh.dispose();
