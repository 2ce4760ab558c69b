// Lines under the pointer and in a selection box, on shapes that hide points in closed form.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { PerspectiveCamera, Vector3 } from 'three';
import { load } from './figures.mjs';

const size = { width: 800, height: 600 };
const style = { width: 2, dash: 'solid', onSurface: false, opacity: 1, color: null };

/** The unit ball, for rays from outside. */
const ball = {
  frame: { scale: 1 },
  depth({ origin, direction }) {
    const along = -origin.dot(direction);
    const inside = 1 - origin.lengthSq() + along * along;
    return inside > 0 ? along - Math.sqrt(inside) : Infinity;
  },
};

/** The plane z = 0, and above it a lid from x = `edge` on. */
const lidded = (edge) => ({
  frame: { scale: 1 },
  depth({ origin, direction }) {
    const to = (z) => (z - origin.z) / direction.z;
    const isUnderLid = origin.x + to(0.1) * direction.x > edge;
    return isUnderLid ? to(0.1) : to(0);
  },
});

describe('on the stage', () => {
  let modules;
  before(async () => {
    const files = ['lines_at', 'vantage', 'regions', 'hidden_lines'];
    const loaded = await Promise.all(files.map((file) => load(`viewer/${file}.ts`)));
    modules = Object.assign({}, ...loaded);
  });
  const viewOf = (surface, away) => {
    const camera = new PerspectiveCamera(30, size.width / size.height, 0.01, 100);
    camera.position.set(0, 0, away);
    camera.updateMatrixWorld();
    return new modules.Vantage(surface, camera, size);
  };
  const pickable = (line) => ({
    ...{ curve: line, own: [line], style, shorter: [] },
    objects: [{ id: 7, style, locked: false, lines: [line], dots: [] }],
  });

  test('a hidden stretch of a line does not keep its visible stretch from the pointer', () => {
    // A curve around the ball: in the view, its back crosses its front at half the ball's height.
    const count = 720;
    const places = Array.from({ length: count + 1 }, (_, i) => {
      const t = (2 * Math.PI * i) / count;
      return new Vector3(0.15 * Math.cos(3 * t), Math.sin(t), Math.cos(t)).normalize();
    });
    const line = Float32Array.from(places.flatMap((place) => place.toArray()));
    const away = 6;
    const vantage = viewOf(ball, away);
    const seen = places.map((place) => {
      const { x, y } = vantage.onStage(place.clone());
      // A point p of the unit sphere is visible from e if p · e > 1.
      return { x, y, isFront: place.z * away > 1 };
    });
    const within = 7;
    let crossed = 0;
    for (const { x, y, isFront } of seen) {
      // Both stretches are far from the rim here.
      if (Math.hypot(x - size.width / 2, y - size.height / 2) > 150) continue;
      for (const dx of [-5, -2, 2, 5]) {
        const place = { x: x + dx, y };
        const nearest = (front) =>
          Math.min(
            ...seen
              .filter((one) => one.isFront === front)
              .map((one) => Math.hypot(one.x - place.x, one.y - place.y)),
          );
        const [front, back] = [nearest(true), nearest(false)];
        // The samples are less than 2 pixels apart.
        if (Math.abs(front - within) < 1) continue;
        const lines = new modules.LinesAt(vantage, pickable(line), place);
        const found = lines.curve(within);
        assert.equal(found !== null, front < within, `${place.x}, ${place.y}: ${front}, ${back}`);
        assert.equal(lines.own(within), front < within);
        assert.equal(lines.object(within), front < within ? 7 : null);
        const other = lines.nearestOnObjects(within);
        if (!found) assert.equal(other, null);
        else {
          assert.deepEqual(other.toArray(), found.toArray());
          const at = vantage.project(found);
          assert.equal(at.hidden, false);
          const distance = Math.hypot(at.x - place.x, at.y - place.y);
          assert.ok(distance <= front + 1e-3 && distance > front - 1, `${distance} for ${front}`);
        }
        if (!isFront && front < within && back < front) crossed++;
      }
    }
    assert.ok(crossed > 20, `${crossed} places where the back is nearer`);
  });

  test('a dot takes clicks on its whole disc, which is wider than a line of its object', () => {
    const vantage = viewOf(ball, 6);
    const front = new Vector3(0, 0, 1);
    const wide = { ...style, width: 20 };
    const [dot] = [[0, 0, 1, 1e-4, 0, 1]].map((line) => Float32Array.from(line));
    const objects = [{ id: 7, style: wide, locked: false, lines: [], dots: [dot] }];
    const { x, y } = vantage.onStage(front.clone());
    const found = (dx) =>
      new modules.LinesAt(vantage, { ...pickable(dot), objects }, { x: x + dx, y }).object(5);
    const radius = (2.4 * wide.width) / 2;
    assert.deepEqual([0, 12, radius - 1, radius + 1].map(found), [7, 7, 7, null]);
  });

  /** Open space, for lines and triangles that nothing hides. */
  const open = {
    ...{ frame: { scale: 1 }, depth: () => Infinity, toScene: (line) => line },
    inScene: (place) => new Vector3(...place),
  };
  const near = 0.01;

  /** The parts of a line of these places on the stage, where it is in view with its width. */
  const partsOf = (vantage, places, width = 200, onSurface = false) => [
    ...vantage.seenParts(Float32Array.from(places.flat()), { width, onSurface }),
  ];
  const scale = size.height / 2 / Math.tan(Math.PI / 12);
  /** The place on the stage of a place in front of the camera of `viewOf(open, 0)`. */
  const seenAt = ([x, y, z]) => [
    size.width / 2 - (scale * x) / z,
    size.height / 2 + (scale * y) / z,
  ];

  test('the parts of a line in front of the camera end at its near plane, and are seen where they are', () => {
    // The camera is at the origin and looks down the z axis.
    const vantage = viewOf(open, 0);
    // The line starts behind the camera, and passes it on two sides of the stage's middle.
    const places = [1, 1, -1, -1].map((x, i) => [x / 500, 1e-3, [1, -3, -3, 1][i]]);
    const [part, ...more] = partsOf(vantage, places);
    assert.deepEqual(more, []);
    assert.ok(part.hidden.every((hidden) => !hidden));
    assert.deepEqual([...new Set(part.segments)], [0, 1, 2]);
    const cut = [0, 3].map((i) => [...places[i].slice(0, 2), -near]);
    const wanted = [cut[0], places[1], places[2], cut[1]].map(seenAt);
    const corners = [0, 1, 2].map((segment) => part.segments.indexOf(segment));
    for (const [i, vertex] of [...corners, part.x.length - 1].entries()) {
      const off = Math.hypot(part.x[vertex] - wanted[i][0], part.y[vertex] - wanted[i][1]);
      // Places have 24 bits.
      assert.ok(off < 1e-3, `${part.x[vertex]}, ${part.y[vertex]}, not ${wanted[i]}`);
    }
    const back = places.map(([x, y, z]) => [x, y, -z]);
    assert.deepEqual(
      partsOf(vantage, back).map(({ segments }) => [...new Set(segments)]),
      [[0], [2]],
    );
    const behind = places.map(([x, y, z]) => [x, y, z + 4]);
    assert.deepEqual(partsOf(vantage, behind), []);
  });

  test('the parts of a line that passes beside the camera end at the sides of the stage', () => {
    const vantage = viewOf(open, 0);
    const margin = 8;
    // Three sides of a square around the camera, which cross the view in front of it.
    const places = [1, -3, -3, 1].map((z, i) => [[-3, -3, 3, 3][i], 0.2, z]);
    const [part, ...more] = partsOf(vantage, places, 2 * margin);
    assert.deepEqual(more, []);
    assert.deepEqual([...new Set(part.segments)], [1]);
    assert.ok(Math.abs(part.x[0] + margin) < 1e-3, `${part.x[0]}`);
    assert.ok(Math.abs(part.x.at(-1) - size.width - margin) < 1e-3, `${part.x.at(-1)}`);
    const [, y] = seenAt(places[1]);
    for (const seen of part.y) assert.ok(Math.abs(seen - y) < 1e-3, `${seen}, not ${y}`);
    assert.ok(part.x.length < 500, `${part.x.length} places`);
    const above = places.map(([x, , z]) => [x, 3, z]);
    assert.deepEqual(partsOf(vantage, above, 2 * margin), []);
  });

  test('a long segment is seen as far as nothing covers it', () => {
    const edge = 0.4;
    const vantage = viewOf({ ...lidded(edge), toScene: (line) => line }, 6);
    const places = [
      [-1, -0.2, 0],
      [1, 0.3, 0],
    ];
    const [visible, covering, ...more] = partsOf(vantage, places);
    assert.deepEqual(more, []);
    assert.deepEqual([...new Set([...visible.segments, ...covering.segments])], [0]);
    const [x, y, hidden] = ['x', 'y', 'hidden'].map((of) => [
      ...visible[of],
      ...covering[of].slice(1),
    ]);
    // The ray to the lid's edge meets the plane z = 0 beyond the edge.
    const covered = (edge * 6) / 5.9;
    const at = vantage.onStage(new Vector3(covered, -0.2 + ((covered + 1) / 2) * 0.5, 0));
    for (const [i, isHidden] of hidden.entries()) {
      const away = Math.hypot(x[i] - at.x, y[i] - at.y);
      if (away > 1e-3) assert.equal(isHidden, x[i] > at.x, `${x[i]}, ${y[i]}`);
    }
    const first = hidden.indexOf(true);
    assert.ok(x[first] - x[first - 1] < 5, `${x[first - 1]} to ${x[first]}`);
  });

  test('each visible part of a line is as wide, and has such dashes, as it is near', async () => {
    const vantage = viewOf(open, 0);
    // The line passes the camera: its ends appear at the distances 2 and 4, and its middle nowhere.
    const places = [
      [-0.1, 0, -2],
      [0.1, 0, -2],
      [0.1, 5, -2],
      [0.1, 5, -4],
      [0.1, 0, -4],
      [-0.1, 0, -4],
    ];
    const line = Float32Array.from(places.flat());
    const parts = [...vantage.seenParts(line, { width: 0.02, onSurface: true })];
    assert.equal(parts.length, 2);
    const looks = parts.map(({ middle }) => [
      vantage.widthOf({ width: 0.02, onSurface: true }, middle),
      ...vantage.dashesOf([0.03, 0.02], middle).split(' ').map(Number),
    ]);
    for (const [k, length] of [0.02, 0.03, 0.02].entries()) {
      for (const [part, away] of [2, 4].entries()) {
        const wanted = (scale * length) / away;
        const off = Math.abs(looks[part][k] - wanted) / wanted;
        assert.ok(off < 0.02, `${looks[part][k]}, not ${wanted}`);
      }
    }
    const { panelSvg } = await load('paper/view/panel_svg.ts');
    const svg = panelSvg({
      ...{ vantage, seen: () => {}, places: [], picture: '', numbers: '{}' },
      colorOf: () => '#123456',
      lines: [{ id: 'exactPath', polylines: [line], status: [new Uint8Array(6).fill(1)] }],
    });
    const [first, second] = [...svg.matchAll(/stroke-dasharray="([\d.]+) /g)].map(([, dash]) =>
      Number(dash),
    );
    assert.ok(Math.abs(first - 2 * second) < 0.05, `${first}, ${second}`);
  });

  test('a hidden part of a line is measured where it is, and so is the visible one', () => {
    const vantage = viewOf({ ...lidded(0), toScene: (line) => line }, 6);
    const parts = partsOf(vantage, [
      [-0.5, 0, 0],
      [0.5, 0, 0],
    ]);
    assert.deepEqual(
      parts.map(({ hidden }) => hidden.every(Boolean)),
      [false, true],
    );
    const [visible, hidden] = parts.map(({ middle }) => middle);
    assert.ok(visible.x < -0.2 && hidden.x > 0.2, `${visible.x}, ${hidden.x}`);
  });

  test('the SVG of a figure’s panel has only what lies in front of the camera', async () => {
    const { panelSvg } = await load('paper/view/panel_svg.ts');
    const vantage = viewOf(open, 0);
    const seen = (place) => vantage.project(new Vector3(...place));
    const svgOf = (line, marker, places, status = []) =>
      panelSvg({
        ...{ vantage, seen, places, picture: '', numbers: '{}' },
        colorOf: () => '#123456',
        lines: [{ id: 'exactPath', polylines: [Float32Array.from(line.flat())], status, marker }],
      });
    const front = [1, 1, 2, 2].map((x, i) => [x / 8, 0.1, [1, -3, -3, 1][i]]);
    const behind = front.map(([x, y, z]) => [x, y, z + 4]);
    const passing = svgOf(front, front[1], [front[1], front[0]]);
    assert.equal(passing.match(/<path/g).length, 1);
    assert.equal(passing.match(/<circle/g).length, 2);
    // All places in front of the camera are above it, in the upper half of the stage.
    const [, path] = passing.match(/ d="([^"]*)"/);
    const ys = path.match(/-?[\d.]+/g).filter((_, i) => i % 2);
    for (const y of ys) assert.ok(y < size.height / 2, `${y} is below the middle: ${path}`);
    assert.doesNotMatch(svgOf(behind, behind[1], [behind[2]]), /<path|<circle/);
    // The last segment is lost, also after a part behind the camera.
    const back = front.map(([x, y, z]) => [x, y, -z]);
    const lost = svgOf(back, undefined, [], [Uint8Array.of(0, 0, 0, 1)]);
    assert.deepEqual(
      lost.match(/<path[^>]*>/g).map((path) => path.includes('stroke-dasharray')),
      [false, true],
    );
    // Half as far, the dashes of a lost line are twice as long.
    const [far, near] = [4, 2].map((away) => {
      const line = [-0.1, 0, 0.1].map((x) => [x, 0, -away]);
      const text = svgOf(line, undefined, [], [Uint8Array.of(0, 1, 1)]);
      return Number(/stroke-dasharray="([\d.]+) /.exec(text)[1]);
    });
    assert.ok(Math.abs(near - 2 * far) < 0.02, `${near}, ${far}`);
  });

  test('a painted triangle that passes the camera is painted in front of it only', () => {
    const vantage = viewOf(open, 0);
    // The half plane below the camera, y = -1, appears in the lower half of the stage.
    const corners = [-5, -1, -20, 5, -1, -20, 0, -1, 30];
    const seen = modules.seenTriangles(corners, vantage, null);
    assert.equal(seen.length, 12, 'the part in front has four corners');
    for (let i = 0; i < seen.length; i += 2) {
      assert.ok(seen[i + 1] > size.height / 2, `${seen.slice(i, i + 2)}`);
    }
    const behind = corners.map((value, i) => (i % 3 === 2 ? value + 21 : value));
    assert.equal(modules.seenTriangles(behind, vantage, null).length, 0);
  });

  test('a box selects a line of which it holds a visible part, and no vertex', () => {
    const vantage = viewOf(lidded(0.4), 6);
    const [from, to] = [new Vector3(-1, -0.2, 0), new Vector3(1, 0.3, 0)];
    const line = Float32Array.from([...from.toArray(), ...to.toArray()]);
    const selects = (left, top, right, bottom) => {
      const box = { left, top, width: right - left, height: bottom - top };
      const { others, edited } = modules.objectsIn(vantage, pickable(line), box);
      assert.deepEqual(others, edited ? [7] : []);
      return edited;
    };
    const at = (part) => vantage.onStage(from.clone().lerp(to, part));
    const around = (part, aside = 0) => {
      const { x, y } = at(part);
      return [x - 20, y - 20 + aside, x + 20, y + 20 + aside];
    };
    assert.ok(selects(...around(0.5)), 'across');
    assert.ok(selects(...around(0.3)));
    assert.ok(!selects(...around(0.5, 40)), 'below');
    assert.ok(!selects(...around(0.5, -40)), 'above');
    assert.ok(!selects(...around(0.9)), 'under the lid');
    // The box of a segment's ends contains more than the segment.
    const [left, right] = [at(0.2), at(0.4)];
    assert.ok(!selects(left.x, right.y, left.x + 2, right.y + 2), 'beside its corner');
    assert.ok(selects(...around(0)), 'at an end');
    // From near, the line leads from the stage to behind the camera.
    const beside = viewOf(null, 0.5);
    const past = Float32Array.from([0, 0, 0, 0, 0.1, 1]);
    const all = { left: 0, top: 0, ...size };
    assert.ok(modules.objectsIn(beside, pickable(past), all).edited);
  });
});
