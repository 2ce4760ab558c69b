// Surfaces whose coordinates are large numbers beside their size, such as those of maps.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { openPage } from './engine_in_node.mjs';
import { figure, load } from './figures.mjs';

/** A flat square of unit squares at the coordinates of a map (UTM), in meters. */
function mapArrays(cells) {
  const positions = [];
  const triangles = [];
  for (let j = 0; j <= cells; j++) {
    for (let i = 0; i <= cells; i++) positions.push(5e5 + i, 5e6 + j, 0);
  }
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const a = i + (cells + 1) * j;
      const c = a + cells + 1;
      triangles.push(a, a + 1, c + 1, a, c + 1, c);
    }
  }
  return { positions: Float64Array.from(positions), triangles: Int32Array.from(triangles) };
}

describe('on a surface at the coordinates of a map', () => {
  const cells = 16;
  const arrays = mapArrays(cells);
  const at = (i, j, u = 0.2, v = 0.3) => ({
    face: 2 * (i + cells * j),
    bary: [1 - u - v, u, v],
  });
  const place = ({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, k) =>
          sum + weight * arrays.positions[3 * arrays.triangles[3 * face + k] + axis],
        0,
      ),
    );
  const [from, to] = [at(4, 5), at(11, 8, 0.45, 0.11)];
  const step = place(to).map((value, axis) => value - place(from)[axis]);
  const length = Math.hypot(...step);
  let page;
  before(async () => {
    page = await openPage(arrays);
  });

  test('an ellipse has the direction of its handle', async () => {
    const circle = { center: from, rim: to };
    page.editor.replace({ ...figure, kind: 'ellipse', points: [], circle });
    const { circle: shown } = await page.settled();
    const isAlong = (direction, wanted) => {
      const off = Math.hypot(...direction.map((value, axis) => value - wanted[axis]));
      // Coordinates have 9 digits behind the point.
      assert.ok(off < 1e-6, `${direction}, not ${wanted}`);
    };
    const along = step.map((value) => value / length);
    isAlong(shown.direction, along);
    isAlong(shown.across.direction, [-along[1], along[0], 0]);
    assert.ok(Math.abs(shown.radius - length) < 1e-6);
  });

  test('the ruler measures straight lengths exactly', async () => {
    const { Ruler } = await load('editor/hand/ruler.ts');
    const viewer = { surface: { toScene: (line) => line }, aids: { showBand() {} } };
    const ruler = new Ruler(page.editor, page.session, viewer);
    const measured = new Promise((resolve) => {
      ruler.onChange = (ruled) => ruled && resolve(ruled);
    });
    ruler.click(from);
    ruler.click(to);
    const { along, straight } = await measured;
    assert.ok(Math.abs(along - length) < 1e-6, `${along}, not ${length}`);
    assert.ok(Math.abs(straight - length) < 1e-6, `${straight}, not ${length}`);
  });
});
