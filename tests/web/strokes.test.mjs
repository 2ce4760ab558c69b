// Strokes become curves of the pen: few smooth anchors within the tolerance, with corners.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { openPage } from './engine_in_node.mjs';
import { randoms, seed } from './part.mjs';
import { add, bernstein, far } from './pen_plane.mjs';

const pixel = 0.01;

describe('strokes', () => {
  console.log(`KARCHER_SEED=${seed}`);
  const numbers = randoms(seed);
  const random = () => numbers.next().value;
  let page;
  before(async () => {
    page = await openPage(500);
  });

  /** A stroke on a plane; the face of each point is its index. */
  const strokeOf = (places, tolerance = 3) =>
    places.map(([x, y], face) => ({
      point: { face, bary: [1, 0, 0] },
      place: [x, y, 0],
      normal: [0, 0, 1],
      tolerance: tolerance * pixel,
      pixel,
    }));

  const sampled = (curve, count) => Array.from({ length: count + 1 }, (_, i) => curve(i / count));

  /** The control points of each segment. */
  function segmentsOf(anchors, places, closed) {
    const placeOf = ({ face }) => [...places[face], 0];
    const handle = (anchor, side) => {
      const told = anchor.tangents?.[side];
      if (!told) return placeOf(anchor);
      const lead = told.direction ?? anchor.tangents.after.direction.map((value) => -value);
      return add(placeOf(anchor), lead, told.length);
    };
    return anchors.slice(closed ? 0 : 1).map((_, i) => {
      const [from, to] = [anchors[i], anchors[(i + 1) % anchors.length]];
      return [placeOf(from), handle(from, 'after'), handle(to, 'before'), placeOf(to)];
    });
  }

  /** The largest distance between the places of a stroke and its curve. */
  function worstOff(anchors, places, closed = false) {
    const curve = segmentsOf(anchors, places, closed).flatMap((control) =>
      Array.from({ length: 301 }, (_, i) =>
        [0, 1, 2].map((axis) =>
          bernstein(i / 300).reduce((sum, weight, k) => sum + weight * control[k][axis], 0),
        ),
      ),
    );
    return Math.max(
      ...places.map(([x, y]) => Math.min(...curve.map((place) => far(place, [x, y, 0])))),
    );
  }

  test('have few smooth anchors within the tolerance', (t) => {
    const wave = sampled((t) => [4 * t, 0.6 * Math.sin(7 * t)], 240);
    for (const tolerance of [1, 3, 8]) {
      const shaken = wave.map(([x, y]) => [
        x + 0.4 * pixel * (random() - 0.5),
        y + 0.4 * pixel * (random() - 0.5),
      ]);
      const anchors = page.anchorsOf(strokeOf(shaken, tolerance), false);
      const off = worstOff(anchors, shaken) / pixel;
      t.diagnostic(`${tolerance} px: ${anchors.length} anchors, ${off.toFixed(2)} px off`);
      // The samples of the curve are less than 0.1 pixels from it.
      assert.ok(off <= tolerance + 0.1, `${off}`);
      assert.ok(anchors.length <= 10, `${anchors.length}`);
      for (const { tangents } of anchors.slice(1, -1)) {
        assert.equal(page.jointOf(tangents), 'smooth');
      }
      assert.equal(anchors[0].point?.face ?? anchors[0].face, 0);
      assert.equal(anchors.at(-1).face, shaken.length - 1);
    }
  });

  test('that are one cubic have two anchors', () => {
    const control = [
      [0, 0, 0],
      [1, 2, 0],
      [2.5, 1.5, 0],
      [3, 0, 0],
    ];
    const places = sampled(
      (t) =>
        [0, 1].map((axis) =>
          bernstein(t).reduce((sum, weight, k) => sum + weight * control[k][axis], 0),
        ),
      150,
    );
    assert.equal(page.anchorsOf(strokeOf(places), false).length, 2);
  });

  test('keep their corners, where they turn sharply', () => {
    const side = (from, to) => sampled((t) => from.map((x, i) => x + t * (to[i] - x)), 60);
    const zigzag = [
      ...side([0, 0], [1, 1]),
      ...side([1, 1], [2, 0]).slice(1),
      ...side([2, 0], [3, 1]).slice(1),
    ];
    const anchors = page.anchorsOf(strokeOf(zigzag), false);
    assert.deepEqual(
      anchors.map(({ face }) => face),
      [0, 60, 120, 180],
    );
    for (const { tangents } of anchors) assert.equal(page.jointOf(tangents), 'corner');
    assert.ok(worstOff(anchors, zigzag) < 0.1 * pixel);
  });

  test('that return to their start are closed, smooth or with a corner there', () => {
    const round = (count) =>
      sampled((t) => [Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t)], count);
    const circle = round(200);
    const anchors = page.anchorsOf(strokeOf(circle), true);
    assert.ok(anchors.length <= 6, `${anchors.length}`);
    assert.ok(worstOff(anchors, circle, true) <= 3.1 * pixel);
    for (const { tangents } of anchors) assert.equal(page.jointOf(tangents), 'smooth');
    const drop = sampled((t) => {
      const angle = 2 * Math.PI * t;
      return [Math.sin(angle) * Math.sin(angle / 2), -Math.cos(angle)];
    }, 200);
    const tipped = page.anchorsOf(strokeOf(drop), true);
    assert.ok(worstOff(tipped, drop, true) <= 3.1 * pixel);
    const corner = sampled((t) => {
      const turn = Math.PI * (t - 0.5);
      return [Math.cos(turn) ** 2 * Math.sin(turn), Math.cos(turn) ** 2];
    }, 200);
    const [seam] = page.anchorsOf(strokeOf(corner), true);
    assert.equal(page.jointOf(seam.tangents), 'corner');
  });

  test('that return to their start have two anchors even if one cubic would do', () => {
    for (const [width, height] of [
      [100, 50],
      [150, 70],
      [60, 60],
      [60, 30],
    ]) {
      const petal = sampled((t) => {
        const angle = 2 * Math.PI * t;
        const bulge = Math.sin(angle) * Math.sin(angle / 2);
        return [((1 - Math.cos(angle)) / 2) * width * pixel, (bulge * height * pixel) / 2];
      }, 120);
      const anchors = page.anchorsOf(strokeOf(petal), true);
      assert.ok(anchors.length >= 2, `${width} by ${height}: ${anchors.length}`);
      assert.ok(worstOff(anchors, petal, true) <= 3.1 * pixel);
    }
  });

  test('are unrolled from a sphere with their lengths and turns', () => {
    // A circle of latitude turns evenly: its cone unrolls to an arc.
    const height = 0.5;
    const radius = Math.sqrt(1 - height ** 2);
    const samples = sampled((t) => {
      const place = [radius * Math.cos(2 * t), height, radius * Math.sin(2 * t)];
      return { place, normal: place };
    }, 400);
    const { places } = page.rolledOut(samples);
    const slant = radius / height;
    const [[x0, y0], [x1, y1], [x2, y2]] = [places[0], places[200], places[400]];
    const turn = 2 * height;
    const chord = 2 * slant * Math.sin(turn / 2);
    assert.ok(Math.abs(Math.hypot(x2 - x0, y2 - y0) - chord) < 1e-4);
    const half = 2 * slant * Math.sin(turn / 4);
    assert.ok(Math.abs(Math.hypot(x1 - x0, y1 - y0) - half) < 1e-4);
  });

  test('of two places are a line', () => {
    const anchors = page.anchorsOf(
      strokeOf([
        [0, 0],
        [1, 0],
      ]),
      false,
    );
    assert.equal(anchors.length, 2);
    assert.ok(anchors[0].tangents.after.length > 0);
  });
});
