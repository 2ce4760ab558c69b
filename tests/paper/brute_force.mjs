// Residuals and energies of a uniform cubic B-spline's samples, computed independently of the
// ruler: weights by the recursion of Cox and de Boor, directions from paths that end at the sample
// instead of starting there, in coordinates of the face's plane.

const samplesRead = 33;

/** N_i,3 at u, on the knots 0, 1, 2, … */
function basis(i, degree, u) {
  if (degree === 0) return i <= u && u < i + 1 ? 1 : 0;
  return (
    ((u - i) / degree) * basis(i, degree - 1, u) +
    ((i + degree + 1 - u) / degree) * basis(i + 1, degree - 1, u)
  );
}

/** The weights of a segment's four points at t in [0, 1]. */
function weightsAt(t) {
  // The basis is right-continuous: its limit from the left at the end is the next segment's start.
  if (t === 1) return [0, ...weightsAt(0).slice(0, 3)];
  return [0, 1, 2, 3].map((i) => basis(i, 3, 3 + t));
}

const minus = (a, b) => a.map((x, c) => x - b[c]);
const size = (a) => Math.hypot(...a);
const places = (polyline) =>
  Array.from({ length: polyline.length / 3 }, (_, i) => [...polyline.slice(3 * i, 3 * i + 3)]);

/** A point of a face in coordinates of its plane: corner 0 is the origin, corner 1 on the x axis. */
function inFace([a, b, c], point) {
  const dot = (u, v) => u.reduce((sum, x, k) => sum + x * v[k], 0);
  const unit = (u) => u.map((x) => x / size(u));
  const x = unit(minus(b, a));
  const up = minus(c, a);
  const y = unit(up.map((value, k) => value - dot(up, x) * x[k]));
  const from = minus(point, a);
  return [dot(from, x), dot(from, y)];
}

/** Values of the converged ones among 33 samples, sorted, in mean edges and squared mean edges. */
export function residualsByBruteForce(mesh, points, samples) {
  const positions = mesh.positions();
  const triangles = mesh.triangles();
  const { meanEdge } = mesh.info;
  const residual = [];
  const energy = [];
  for (let k = 0; k < samplesRead; k++) {
    const i = Math.round((k * (samples.count - 1)) / (samplesRead - 1));
    if (samples.status[i] !== 'converged') continue;
    const face = samples.face[i];
    const bary = [...samples.bary.slice(3 * i, 3 * i + 3)];
    if (Math.min(...bary) < 1e-6) throw new Error(`sample ${i} lies on a side of its face`);
    const corners = [0, 1, 2].map((c) => {
      const v = triangles[3 * face + c];
      return [...positions.slice(3 * v, 3 * v + 3)];
    });
    const here = inFace(
      corners,
      [0, 1, 2].map((c) => corners.reduce((sum, p, j) => sum + bary[j] * p[c], 0)),
    );
    const total = [0, 0];
    let energyHere = 0;
    weightsAt(samples.t[i]).forEach((weight, j) => {
      if (weight === 0) return;
      const path = mesh.shortestPath(points[samples.segment[i] + j], { face, bary });
      energyHere += weight * path.length ** 2;
      const [before] = places(path.polyline({ bits: 64 })).slice(-2);
      const from = inFace(corners, before);
      const step = minus(from, here);
      for (const c of [0, 1]) total[c] += (weight * path.length * step[c]) / size(step);
    });
    residual.push(size(total) / meanEdge);
    energy.push(energyHere / meanEdge ** 2);
  }
  const sorted = (values) => values.toSorted((a, b) => a - b);
  return { residual: sorted(residual), energy: sorted(energy) };
}
