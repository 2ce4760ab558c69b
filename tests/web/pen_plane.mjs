// A plane of irregular triangles, and curves of the pen on it, for tests of their shape.

/**
 * A square of side 1 in irregular triangles, whose vertices are those of a grid, displaced without
 * folding a triangle.
 */
export function roughPlane(cells, random) {
  const positions = [];
  const triangles = [];
  for (let j = 0; j <= cells; j++) {
    for (let i = 0; i <= cells; i++) {
      const inner = i > 0 && i < cells && j > 0 && j < cells;
      const [dx, dy] = inner ? [random() - 0.5, random() - 0.5] : [0, 0];
      positions.push((i + 0.32 * dx) / cells, (j + 0.32 * dy) / cells, 0);
    }
  }
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const at = j * (cells + 1) + i;
      triangles.push(at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1);
    }
  }
  return { positions: Float64Array.from(positions), triangles: Int32Array.from(triangles) };
}

export const add = (p, q, factor = 1) => p.map((value, axis) => value + factor * q[axis]);
export const far = (p, q) => Math.hypot(...add(p, q, -1));
export const bernstein = (t) => [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t ** 2 * (1 - t), t ** 3];
/** The place of a point of a surface. */
export const placeOn =
  ({ positions, triangles }) =>
  ({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
        0,
      ),
    );

/** The surface's point at a place of the plane, found by the engine. */
export async function pointAt(page, arrays, x, y) {
  const start = { face: 0, bary: [1 / 3, 1 / 3, 1 / 3] };
  const [dx, dy] = add([x, y, 0], placeOn(arrays)(start), -1);
  const length = Math.hypot(dx, dy);
  const { end } = await page.session.client.mesh.straightest(start, [dx, dy, 0], length);
  return end;
}

export const vector = (x, y) => {
  const length = Math.hypot(x, y);
  return { direction: [x / length, y / length, 0], length };
};

/** Draws a pen curve as the only object. */
export async function drawPen(page, points, settings = {}) {
  const { editor, emptyDrawing, activeObject } = page;
  const { figure } = activeObject(emptyDrawing);
  const pen = { ...figure, kind: 'pen', points, settings: { ...figure.settings, ...settings } };
  editor.draw({ objects: [{ ...activeObject(emptyDrawing), figure: pen }], active: 1 });
  return page.settled();
}

/** The control points of each segment by the figure's values, on a plane. */
export function segmentsOf(arrays, points, closed) {
  const placeOf = placeOn(arrays);
  const handle = ({ tangents, ...point }, side) => {
    const at = placeOf(point);
    const told = tangents?.[side];
    if (!told) return at;
    if (told.direction) return add(at, told.direction, told.length);
    if (told.face !== undefined) return placeOf(told);
    const lead = tangents[side === 'before' ? 'after' : 'before'];
    const back = lead.direction ?? add(placeOf(lead), at, -1);
    const size = Math.hypot(...back);
    const whole = lead.length ?? size;
    return add(at, back, -(told.length ?? whole) / size);
  };
  const count = points.length - (closed ? 0 : 1);
  return Array.from({ length: count }, (_, i) => {
    const [from, to] = [points[i], points[(i + 1) % points.length]];
    return [placeOf(from), handle(from, 'after'), handle(to, 'before'), placeOf(to)];
  });
}
