// Measurements of drawn lines: x, y, z of each vertex.

export const far = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));

export const vertices = (line) =>
  Array.from({ length: line.length / 3 }, (_, i) => line.slice(3 * i, 3 * i + 3));

export function lengthOf(line) {
  const places = vertices(line);
  return places.slice(1).reduce((length, place, i) => length + far(place, places[i]), 0);
}
