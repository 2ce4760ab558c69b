// Objects derived from regions that cover more than half of a closed surface, by the engine alone.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { Vector3 } from 'three';
import { arraysOfShape, openPage } from './engine_in_node.mjs';

describe('objects derived from more than half of a sphere', () => {
  let page;
  let centers;
  before(async () => {
    page = await openPage(2000);
    const { mesh } = page.session.client;
    // Two centers 60 degrees apart. Their circles of 80 degrees cover more than a half together.
    const first = { face: 0, bary: [0.3, 0.3, 0.4] };
    const { vectors } = await mesh.logMap(first, [{ face: 1000, bary: [0.3, 0.3, 0.4] }]);
    const scale = Math.PI / 3 / Math.hypot(...vectors);
    const { points } = await mesh.expMap(
      first,
      vectors.map((value) => scale * value),
    );
    centers = [first, points[0]];
  });

  const degrees = (angle) => (angle * Math.PI) / 180;
  const round = (center, radius) => ({
    ...page.emptyDrawing.objects[0].figure,
    kind: 'circle',
    circleForm: { type: 'exact', arcs: 'auto' },
    circle: { center, rim: { radius, direction: [0.36, 0.48, 0.8] } },
  });
  const of = (kind, sources, derived = {}) => ({
    ...page.emptyDrawing.objects[0].figure,
    kind,
    derived: { sources, ...derived },
  });
  const offset = (sources, side, distance = 0.1) =>
    of('offset', sources, { offset: { distance, side } });

  /** The area of the last of these figures, whose ids count from 1. */
  async function areaOf(...figures) {
    const objects = figures.map((figure, i) => ({
      ...page.newObject(i + 1, figure, { fill: 0.5 }),
    }));
    const to = { objects, active: objects.length };
    page.editor.perform({ type: 'draw', from: page.editor.state.drawing, to });
    const { isolines, fill, problem } = await page.settled();
    assert.equal(problem, null);
    assert.equal(fill.problem, null);
    assert.ok(isolines.lines.length > 0);
    return fill.region.area;
  }
  const near = (value, wanted, most) =>
    assert.ok(Math.abs(value - wanted) < most, `${value}, not ${wanted}`);

  const large = () => [...centers.map((center) => round(center, degrees(80))), of('union', [1, 2])];
  const small = () => round(centers[0], degrees(20));

  test('a union of it and of a part of it is the same region', async () => {
    const whole = await areaOf(...large());
    assert.ok(whole > 2.2 * Math.PI, `${whole}`);
    near(await areaOf(...large(), small(), of('union', [3, 4])), whole, 1e-6);
    const cap = await areaOf(small(), round(centers[0], degrees(21)), of('intersection', [1, 2]));
    near(await areaOf(...large(), small(), of('intersection', [3, 4])), cap, 1e-6);
  });

  test('its offsets lie outside and inside of it', async () => {
    const whole = await areaOf(...large());
    const outer = await areaOf(...large(), offset([3], 'outwards'));
    const inner = await areaOf(...large(), offset([3], 'inwards'));
    assert.ok(outer > whole + 0.4, `${outer} ${whole}`);
    assert.ok(inner < whole - 0.4, `${inner} ${whole}`);
  });

  test('an offset is a source with its own side', async () => {
    for (const [side, end] of [['outwards'], ['inwards'], ['outwards', 0.15], ['inwards', 0.15]]) {
      const one = of('offset', [3], { offset: { distance: 0.1, side, ...(end && { end }) } });
      const area = await areaOf(...large(), one);
      near(await areaOf(...large(), one, small(), of('union', [4, 5])), area, 1e-6);
      const wider = await areaOf(...large(), one, offset([4], 'outwards'));
      assert.ok(wider > area + 0.3, `${side} ${wider} ${area}`);
    }
  });

  test('expanded, it has the same area', async () => {
    const whole = await areaOf(...large());
    const { positions, triangles } = await arraysOfShape('sphere', 2000);
    const position = ({ face, bary }) =>
      bary.reduce(
        (sum, weight, i) =>
          sum.addScaledVector(
            new Vector3().fromArray(positions, 3 * triangles[3 * face + i]),
            weight,
          ),
        new Vector3(),
      );
    const surface = {
      position,
      normal: (point) => position(point).normalize(),
      fromScene: (place) => place.toArray(),
      directionFromScene: (direction) => direction.toArray(),
    };
    const expansion = new page.Expansion(
      page.editor,
      page.session,
      () => surface,
      () => '',
    );
    await expansion.expand();
    const { curve, fill } = await page.settled();
    assert.ok(curve);
    // The other side has 2 less. The curve of the pen only approximates the lines.
    near(fill.region.area, whole, 0.1);
  });
});
