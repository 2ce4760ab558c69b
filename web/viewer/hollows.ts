/**
 * The depth of each vertex in its neighborhoods of the `hollowRadii`, for relief: `hollowWidths`
 * bytes for each vertex. The depth is positive in hollows, negative on ridges, and 0 where the
 * surface is flat or a saddle bends equally to both sides. A triangle's bend is the flux of its
 * normals through its border. This is the integral of twice the mean curvature, for any shape of
 * the triangle. Heat that flows along the surface spreads the bends to a radius, so that the result
 * does not depend on the size of the triangles. Positions are in the scene, where a surface is
 * about 2 wide.
 */
export function hollowsOf(
  positions: Float32Array,
  normals: Float32Array,
  triangles: Uint32Array,
): Int8Array {
  const count = positions.length / 3;
  const hollows = new Int8Array(hollowWidths * count);
  const { areas, bends, weights } = measured(positions, normals, triangles);
  const curvatures = new Float64Array(count);
  // Solves from the narrowest to the widest neighborhood. Each solution starts from the previous
  // one.
  for (let width = hollowWidths - 1; width >= 0; width--) {
    const radius = hollowRadii[width]!;
    spread(curvatures, bends, areas, { triangles, weights, time: radius ** 2 / 4 });
    for (let i = 0; i < count; i++) {
      const sunken = Math.tanh(-steepness * radius * curvatures[i]!);
      hollows[hollowWidths * i + width] = Math.round(127 * sunken);
    }
  }
  return hollows;
}

/** The number of neighborhoods of a vertex. */
export const hollowWidths = 4;
/**
 * The radii, each a quarter of the previous one. With the whole surface in view the second is some
 * 15 pixels wide.
 */
export const hollowRadii = [0.2, 0.05, 0.0125, 0.003125] as const;
/**
 * The factor on the darkness. With it, the inside of a ball is three quarters as dark as possible
 * if the ball's radius is four times the neighborhood's.
 */
const steepness = 2;
/** The largest number of steps of conjugate gradients. Each step extends relief by one edge. */
const mostSteps = 16;
/** The tolerance of the solution; bytes cannot show a smaller error. */
const precision = 1e-2;

/**
 * The vertices' areas and integrals of twice the mean curvature, and the conductances of the
 * triangles' edges.
 */
function measured(positions: Float32Array, normals: Float32Array, triangles: Uint32Array) {
  const areas = new Float64Array(positions.length / 3);
  const bends = new Float64Array(positions.length / 3);
  const weights = new Float32Array(triangles.length);
  const edges = new Float64Array(9);
  for (let at = 0; at < triangles.length; at += 3) {
    // The edge opposite each corner.
    for (let corner = 0; corner < 3; corner++) {
      const from = 3 * triangles[at + ((corner + 1) % 3)]!;
      const to = 3 * triangles[at + ((corner + 2) % 3)]!;
      for (let axis = 0; axis < 3; axis++) {
        edges[3 * corner + axis] = positions[to + axis]! - positions[from + axis]!;
      }
    }
    const x = edges[1]! * edges[5]! - edges[2]! * edges[4]!;
    const y = edges[2]! * edges[3]! - edges[0]! * edges[5]!;
    const z = edges[0]! * edges[4]! - edges[1]! * edges[3]!;
    const twice = Math.sqrt(x * x + y * y + z * z);
    if (twice === 0) continue;
    let bend = 0;
    for (let corner = 0; corner < 3; corner++) {
      const ex = edges[3 * corner]!;
      const ey = edges[3 * corner + 1]!;
      const ez = edges[3 * corner + 2]!;
      const normal = 3 * triangles[at + corner]!;
      bend +=
        (normals[normal]! * (y * ez - z * ey) +
          normals[normal + 1]! * (z * ex - x * ez) +
          normals[normal + 2]! * (x * ey - y * ex)) /
        (2 * twice);
      // Equal to the cotangent weight for an equilateral triangle, but never negative.
      weights[at + corner] = Math.min(twice / (3 * (ex * ex + ey * ey + ez * ez)), longest);
    }
    for (let corner = 0; corner < 3; corner++) {
      const vertex = triangles[at + corner]!;
      areas[vertex]! += twice / 6;
      bends[vertex]! += bend / 3;
    }
  }
  return { areas, bends, weights };
}

/** The largest conductance of an edge: that of a triangle 3000 times as long as wide. */
const longest = 1e3;

/**
 * Spreads the bends like heat over the duration `heat.time`, in one implicit step. It solves (areas
 * + time L) curvatures = bends by conjugate gradients that start from the given curvatures.
 */
function spread(
  curvatures: Float64Array,
  bends: Float64Array,
  areas: Float64Array,
  heat: { triangles: Uint32Array; weights: Float32Array; time: number },
): void {
  const { triangles, weights, time } = heat;
  const count = areas.length;
  const diagonal = areas.slice();
  for (let at = 0; at < triangles.length; at += 3) {
    const toA = time * weights[at]!;
    const toB = time * weights[at + 1]!;
    const toC = time * weights[at + 2]!;
    diagonal[triangles[at]!]! += toB + toC;
    diagonal[triangles[at + 1]!]! += toC + toA;
    diagonal[triangles[at + 2]!]! += toA + toB;
  }
  const applied = (to: Float64Array, x: Float64Array) => {
    for (let i = 0; i < count; i++) to[i] = areas[i]! * x[i]!;
    for (let at = 0; at < triangles.length; at += 3) {
      const a = triangles[at]!;
      const b = triangles[at + 1]!;
      const c = triangles[at + 2]!;
      const toA = time * weights[at]! * (x[c]! - x[b]!);
      const toB = time * weights[at + 1]! * (x[a]! - x[c]!);
      const toC = time * weights[at + 2]! * (x[b]! - x[a]!);
      to[a]! += toB - toC;
      to[b]! += toC - toA;
      to[c]! += toA - toB;
    }
  };
  const rest = new Float64Array(count);
  const product = new Float64Array(count);
  applied(rest, curvatures);
  let [size, whole] = [0, 0];
  const way = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    // A vertex without triangles has an equation of its own.
    if (diagonal[i] === 0) diagonal[i] = 1;
    rest[i] = bends[i]! - rest[i]!;
    way[i] = rest[i]! / diagonal[i]!;
    size += rest[i]! * way[i]!;
    whole += bends[i]! ** 2 / diagonal[i]!;
  }
  for (let step = 0; step < mostSteps && size > precision ** 2 * whole; step++) {
    applied(product, way);
    let along = 0;
    for (let i = 0; i < count; i++) along += way[i]! * product[i]!;
    const length = size / along;
    let next = 0;
    for (let i = 0; i < count; i++) {
      curvatures[i]! += length * way[i]!;
      rest[i]! -= length * product[i]!;
      next += rest[i]! ** 2 / diagonal[i]!;
    }
    for (let i = 0; i < count; i++) {
      way[i] = rest[i]! / diagonal[i]! + (next / size) * way[i]!;
    }
    size = next;
  }
}
