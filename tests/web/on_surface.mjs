/** The largest distance of points (x, y, z each) from a triangle mesh, found without the engine. */
export function farthestFromSurface(points, { positions, triangles }) {
  const corner = (vertex) => positions.slice(3 * vertex, 3 * vertex + 3);
  const faces = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = triangles.slice(t, t + 3).map(corner);
    const center = corners[0].map((_, axis) => corners.reduce((sum, c) => sum + c[axis], 0) / 3);
    const radius = Math.max(...corners.map((c) => Math.hypot(...subtract(c, center))));
    faces.push({ corners, center, radius });
  }
  let farthest = 0;
  for (let i = 0; i < points.length; i += 3) {
    const point = points.slice(i, i + 3);
    let nearest = Number.POSITIVE_INFINITY;
    for (const { corners, center, radius } of faces) {
      const [x, y, z] = [point[0] - center[0], point[1] - center[1], point[2] - center[2]];
      const reach = nearest + radius;
      if (x * x + y * y + z * z >= reach * reach) continue;
      nearest = Math.min(nearest, distanceToTriangle(point, ...corners));
    }
    farthest = Math.max(farthest, nearest);
  }
  return farthest;
}

/** The face nearest to a place on the surface, and the weights of the face's corners there. */
export function nearestOnSurface(place, { positions, triangles }) {
  let nearest = { distance: Number.POSITIVE_INFINITY };
  for (let face = 0; 3 * face < triangles.length; face++) {
    const corners = [0, 1, 2].map((i) => {
      const vertex = triangles[3 * face + i];
      return positions.slice(3 * vertex, 3 * vertex + 3);
    });
    const distance = distanceToTriangle(place, ...corners);
    if (distance < nearest.distance) nearest = { distance, face, corners };
  }
  const { face, corners } = nearest;
  const [a, b, c] = corners;
  const normal = cross(subtract(b, a), subtract(c, a));
  const parts = corners.map((_, i) => {
    const [p, q] = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
    return Math.max(0, dot(cross(subtract(q, p), subtract(place, p)), normal));
  });
  const sum = parts.reduce((total, part) => total + part, 0);
  return { face, bary: parts.map((part) => part / sum) };
}

/** The middles of a polyline's segments. */
export function middles(polyline) {
  const points = [];
  for (let i = 3; i < polyline.length; i++) points.push((polyline[i - 3] + polyline[i]) / 2);
  return points;
}

const subtract = (a, b) => a.map((value, i) => value - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function distanceToSegment(p, a, b) {
  const [ab, ap] = [subtract(b, a), subtract(p, a)];
  const part = Math.min(1, Math.max(0, dot(ap, ab) / dot(ab, ab)));
  return Math.hypot(...ap.map((value, i) => value - part * ab[i]));
}

function distanceToTriangle(p, a, b, c) {
  const corners = [a, b, c];
  const normal = cross(subtract(b, a), subtract(c, a));
  const sides = corners.map((corner, i) => {
    const edge = subtract(corners[(i + 1) % 3], corner);
    return dot(cross(edge, subtract(p, corner)), normal);
  });
  if (sides.every((side) => side >= 0)) {
    return Math.abs(dot(subtract(p, a), normal)) / Math.hypot(...normal);
  }
  return Math.min(
    ...corners.map((corner, i) => distanceToSegment(p, corner, corners[(i + 1) % 3])),
  );
}
