// `karcher/statistics`: robust means and derivatives of the energy, against closed forms.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from 'karcher';
import {
  centroid,
  energyAt,
  hessianAt,
  huberMean,
  median,
  pointDerivatives,
  weightDerivatives,
} from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const cells = 10;
const near = (a, b, tolerance) =>
  assert.ok(
    a.every((x, i) => Math.abs(x - b[i]) < tolerance),
    `${a} is not ${b}`,
  );
/** A cube with this side, from the origin, whose sides have `squares` squares in each row. */
function cube(squares, side) {
  const numbers = new Map();
  const lines = [];
  const vertexAt = (place) => {
    const key = place.join(' ');
    if (!numbers.has(key)) {
      numbers.set(key, numbers.size + 1);
      lines.push(`v ${place.map((x) => (x * side) / squares).join(' ')}`);
    }
    return numbers.get(key);
  };
  for (let wall = 0; wall < 6; wall++) {
    const axis = wall % 3;
    const isFar = wall >= 3;
    for (let square = 0; square < squares * squares; square++) {
      const [a, b, c, d] = [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ].map(([x, y]) => {
        const place = [0, 0, 0];
        place[axis] = isFar ? squares : 0;
        place[(axis + (isFar ? 1 : 2)) % 3] = (square % squares) + x;
        place[(axis + (isFar ? 2 : 1)) % 3] = Math.floor(square / squares) + y;
        return vertexAt(place);
      });
      lines.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
    }
  }
  return `${lines.join('\n')}\n`;
}
const minus = (a, b) => a.map((x, k) => x - b[k]);

for (const [where, loadEngine] of Object.entries({
  'in this thread': load,
  'in a worker': loadInWorker,
})) {
  describe(`on a plane, with the engine ${where}`, () => {
    let engine;
    let mesh;
    before(async () => {
      engine = await loadEngine();
      mesh = await engine.meshFromObj(grid(cells));
    });
    after(() => engine.dispose?.());

    /** The point of the plane's surface at a place. */
    const at = async (x, y) => (await mesh.nearestPoint([x, y, 0])).point;
    const all = (places) => Promise.all(places.map(([x, y]) => at(x, y)));

    test('the median of a triangle is its Fermat point', async () => {
      const places = [
        [1.3, 1.2],
        [8.1, 2.3],
        [4.2, 7.7],
      ];
      const { position, converged, value } = await median(mesh, await all(places));
      assert.ok(converged);
      // From the median, the corners are 120 degrees apart.
      const units = places.map(([x, y]) => {
        const [dx, dy] = [x - position[0], y - position[1]];
        return [dx / Math.hypot(dx, dy), dy / Math.hypot(dx, dy)];
      });
      near(
        [0, 1].map((k) => units.reduce((sum, u) => sum + u[k], 0)),
        [0, 0],
        1e-4,
      );
      const sum = places.reduce(
        (total, [x, y]) => total + Math.hypot(x - position[0], y - position[1]),
        0,
      );
      assert.ok(Math.abs(value - sum) < 1e-9);
    });

    test('the median is a point itself if the point is heavy enough, or its angle is wide', async () => {
      const wide = [
        [1.2, 2.1],
        [5.1, 2.9],
        [9.2, 2.2],
      ];
      near((await median(mesh, await all(wide))).position, [5.1, 2.9, 0], 1e-9);
      const heavy = [
        [1.3, 1.2],
        [8.1, 2.3],
        [4.2, 7.7],
      ];
      near((await median(mesh, await all(heavy), [2.5, 1, 1])).position, [1.3, 1.2, 0], 1e-9);
      // A search from another start finds it, too.
      const from = await median(mesh, await all(heavy), [1, 1, 1], { start: await at(1.3, 1.2) });
      near(from.position, (await median(mesh, await all(heavy))).position, 1e-3);
    });

    test('a search leaves a point whose weight is little less than the pull of the others', async () => {
      const right = await all([
        [1.3, 1.2],
        [8.3, 1.2],
        [1.3, 8.2],
      ]);
      const fermat = await median(mesh, right, undefined, { start: right[0] });
      assert.ok(fermat.converged);
      // On the axis of this right triangle with legs of 7, the median is 7 (1 - 1 / sqrt(3)) / 2
      // from both legs.
      const leg = (7 * (1 - 1 / Math.sqrt(3))) / 2;
      near(fermat.position, [1.3 + leg, 1.2 + leg, 0], 1e-4);
      assert.ok(Math.abs(fermat.value - (7 * (Math.SQRT2 + Math.sqrt(6))) / 2) < 1e-8);
      // The center of mass, where this search starts, is the first point.
      const places = [
        [5, 5],
        [8, 5],
        [3.5, 6.5],
        [3.5, 3.5],
      ];
      const light = await median(mesh, await all(places), [0.3, 1, 1, 1]);
      assert.ok(light.converged);
      // With x on the line y = 5: 2 (x - 3.5) / sqrt((x - 3.5)^2 + 1.5^2) = 1 + 0.3.
      near(light.position, [3.5 + (1.5 * 0.65) / Math.sqrt(1 - 0.65 ** 2), 5, 0], 1e-4);
    });

    test('Huber’s mean has its closed form on a line, and is a mean for a large threshold', async () => {
      const line = await all([
        [0.4, 5],
        [0.9, 5],
        [9.4, 5],
      ]);
      // From the first point, x + (x - .5) = 1.
      const { position } = await huberMean(mesh, line, undefined, { threshold: 1 });
      near(position, [0.4 + 0.75, 5, 0], 1e-5);
      const places = [
        [1.3, 1.2],
        [8.1, 2.3],
        [4.2, 7.7],
      ];
      const weights = [1, 2, 3];
      const wide = await huberMean(mesh, await all(places), weights, { threshold: 100 });
      const mean = [0, 1].map((k) =>
        places.reduce((sum, p, i) => sum + (weights[i] * p[k]) / 6, 0),
      );
      near(wide.position, [...mean, 0], 1e-6);
    });

    test('energy, Hessian and the center’s derivatives by weights are those of the plane', async () => {
      const places = [
        [1.3, 1.2],
        [8.1, 2.3],
        [4.2, 7.7],
        [2.2, 6.1],
      ];
      const weights = [0.5, 1, 2, 0.25];
      const points = await all(places);
      const { position, point } = await mesh.centerOfMass(points, weights, { normalize: true });
      const here = await at(3.15, 4.6);
      const { energy, gradient } = await energyAt(mesh, points, weights, here);
      const ways = places.map((place) => minus([...place, 0], [3.15, 4.6, 0]));
      const expected = ways.reduce((sum, way, i) => sum + weights[i] * Math.hypot(...way) ** 2, 0);
      assert.ok(Math.abs(energy - expected) < 1e-8);
      near(
        gradient,
        [0, 1, 2].map((k) => ways.reduce((sum, w, i) => sum - 2 * weights[i] * w[k], 0)),
        1e-8,
      );
      const total = weights.reduce((sum, weight) => sum + weight, 0);
      near((await hessianAt(mesh, points, weights, here)).matrix, [2 * total, 0, 2 * total], 1e-6);
      const derivatives = await weightDerivatives(mesh, points, weights, point);
      for (const [i, derivative] of derivatives.entries()) {
        near(
          derivative,
          minus([...places[i], 0], position).map((x) => x / total),
          1e-5,
        );
      }
      // The center of a plane moves by the point's share of the weights.
      const byPoints = await pointDerivatives(mesh, points, weights, point);
      for (const [i, { axes, moves }] of byPoints.entries()) {
        for (const k of [0, 1]) {
          near(
            moves[k],
            axes[k].map((x) => (weights[i] / total) * x),
            1e-7,
          );
        }
      }
    });

    test('wrong arguments are reported', async () => {
      const points = await all([
        [1.3, 1.2],
        [8.1, 2.3],
      ]);
      await assert.rejects(median(mesh, points, [1, -1]), /must be positive/);
      for (const start of [undefined, points[0]]) {
        const tooFew = { code: 'tooFewPoints' };
        await assert.rejects(median(mesh, [], [], { start }), tooFew);
        await assert.rejects(huberMean(mesh, [], [], { start, threshold: 1 }), tooFew);
      }
      await assert.rejects(median(mesh, points, [1, 1], { begin: 1 }), /no option 'begin'/);
      await assert.rejects(huberMean(mesh, points, [1, 1], { threshold: 0 }), /positive/);
      for (const weights of [[1], [1, 1, 1]]) {
        for (const call of [
          median,
          (...given) => huberMean(...given.slice(0, 3), { threshold: 1 }),
          ...[energyAt, hessianAt, weightDerivatives, pointDerivatives].map(
            (of) =>
              (...given) =>
                of(...given, points[0]),
          ),
        ]) {
          const badWeights = { code: 'badWeights', message: /2 points but \d weights/ };
          await assert.rejects(call(mesh, points, weights), badWeights);
        }
      }
      await assert.rejects(energyAt(mesh, points, [1, Number.NaN], points[0]), {
        code: 'notFinite',
      });
      await assert.rejects(hessianAt(mesh, points, [1, 1], { vertex: 3 }), /inside faces/);
      const atVertex = [points[0], { vertex: 3 }];
      await assert.rejects(pointDerivatives(mesh, atVertex, [1, 1], points[1]), /inside faces/);
    });
  });
}

test('at a corner of a cube the median moves along an edge', async () => {
  const mesh = (await load()).meshFromObj(cube(12, 2));
  const places = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const points = places.map((place) => mesh.nearestPoint(place).point);
  // At t along an edge the value is t w + (1 - t) + 2 sqrt(1 + t^2).
  const t = 0.25 / Math.sqrt(1 - 0.25 ** 2);
  const least = 1 - t / 2 + 2 * Math.sqrt(1 + t * t);
  const corner = [{ vertex: 0 }, ...points.slice(1)];
  near(mesh.position({ vertex: 0 }), [0, 0, 0], 1e-12);
  for (const own of [points, corner]) {
    for (const start of [own[0], own[1], undefined]) {
      const { value, position } = await median(mesh, own, [0.5, 1, 1, 1], { start });
      // Fields smooth the creases of the cube.
      assert.ok(Math.abs(value - least) < 1e-3, `${value} is not ${least}`);
      assert.ok(Math.abs(Math.hypot(...position) - t) < 0.03, `${position}`);
      // The pull along an edge is 1 + 2 cos(90 degrees).
      const heavy = await median(mesh, own, [1.01, 1, 1, 1], { start });
      assert.ok(Math.abs(heavy.value - 3) < 1e-6, `${heavy.value}`);
    }
  }
});

test('a median beside several vertices divides the mesh once', async () => {
  const mesh = (await load()).shape('torus', 600);
  const points = [0, 15, 30, 60].map((vertex) => ({ vertex }));
  const { cut } = mesh;
  let cuts = 0;
  mesh.cut = (...given) => {
    cuts++;
    return cut.apply(mesh, given);
  };
  const { steps } = await median(mesh, points, undefined, { start: points[0] });
  assert.ok(steps > 0);
  assert.equal(cuts, 1);
});

test('at a corner of the boundary that points inwards the median moves along the boundary', async () => {
  // The square without its upper right quarter. Seen from the corner, the first two points are three
  // quarters of a turn apart, and the third is at 135 degrees from both.
  const size = 20;
  const lines = grid(2 * size)
    .split('\n')
    .filter((line) => {
      const [kind, ...corners] = line.split(' ');
      if (kind !== 'f') return true;
      const places = corners.map((i) => [(i - 1) % (2 * size + 1), (i - 1) / (2 * size + 1)]);
      const isBeyond = (k) =>
        places.reduce((sum, place) => sum + Math.floor(place[k]), 0) / corners.length > size;
      return !(isBeyond(0) && isBeyond(1));
    });
  const mesh = (await load()).meshFromObj(lines.join('\n'));
  assert.equal(mesh.info.triangles, 6 * size ** 2);
  const places = [
    [size, size + 1, 0],
    [size + 1, size, 0],
    [6, 6, 0],
    [size, size, 0],
  ];
  const points = places.map((place) => mesh.nearestPoint(place).point);
  const vertex = mesh.positions().findIndex((_, i, all) => {
    return i % 3 === 0 && all[i] === size && all[i + 1] === size;
  });
  for (const own of [points, [...points.slice(0, 3), { vertex: vertex / 3 }]]) {
    for (const start of [own[1], own[3], undefined]) {
      // Towards the first point the others pull with 1 - 0.5 - 0.1 / sqrt(2) = 0.43.
      const { position } = await median(mesh, own, [1, 0.5, 0.1, 0.35], { start });
      near(position, places[0], 1e-9);
      // The sum of the pulls as vectors would exceed this weight, but points off the surface.
      const heavy = await median(mesh, own, [1, 0.5, 0.1, 0.6], { start });
      near(heavy.position, places[3], 1e-9);
    }
  }
});

test('on a torus derivatives equal difference quotients, and medians have no gradient', async (t) => {
  t.diagnostic(`seed ${seed}`);
  const random = randomFrom(seed);
  const karcher = await load();
  const mesh = karcher.shape('torus', 2000);
  const points = [12, 60, 150, 230, 41].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  const weights = points.map(() => 0.5 + random());
  const exact = { solver: 'exact', normalize: true };
  const { point, position } = mesh.centerOfMass(points, weights, exact);
  const { gradient } = await energyAt(mesh, points, weights, point);
  assert.ok(Math.hypot(...gradient) < 1e-2 * mesh.info.diagonal);
  const derivatives = await weightDerivatives(mesh, points, weights, point);
  for (const i of points.keys()) {
    const size = Math.hypot(...derivatives[i]);
    // After a step along the derivative, the gradient with the new weight is the same, on the
    // polyhedron itself.
    const short = (1e-5 * mesh.info.diagonal) / size;
    const gradientAt = async (change) => {
      const place = position.map((x, k) => x + change * derivatives[i][k]);
      const changed = weights.map((w, k) => w + (k === i ? change : 0));
      const at = mesh.nearestPoint(place).point;
      assert.equal(at.face, point.face);
      return (await energyAt(mesh, points, changed, at)).gradient;
    };
    const [before, beyond] = await Promise.all([gradientAt(-short), gradientAt(short)]);
    const pulled = Math.hypot(...mesh.logMap(point, [points[i]]).vectors);
    const left = Math.hypot(...minus(beyond, before)) / (4 * short * pulled);
    assert.ok(left < 1e-4, `point ${i}: ${left} of the pull of its weight is left`);
    const step = 1e-3;
    const moved = mesh.centerOfMass(
      points,
      weights.map((w, k) => w + (k === i ? step : 0)),
      exact,
    );
    const change = minus(moved.position, position).map((x) => x / step);
    // Derivatives are those of the polyhedron, centers those of smoothed fields.
    near(change, derivatives[i], 0.2 * size);
  }
  const { point: center, converged } = await median(mesh, points);
  assert.ok(converged);
  const { vectors } = mesh.logMap(center, points);
  const sum = [0, 0, 0];
  for (let i = 0; i < points.length; i++) {
    const vector = vectors.slice(3 * i, 3 * i + 3);
    for (let k = 0; k < 3; k++) sum[k] += vector[k] / Math.hypot(...vector);
  }
  assert.ok(Math.hypot(...sum) < 0.05, `${sum}`);
});

test('on a torus the gradient stays where the center follows a point', async (t) => {
  t.diagnostic(`seed ${seed}`);
  const random = randomFrom(seed);
  const mesh = (await load()).shape('torus', 2000);
  const points = [12, 60, 150, 230, 41].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  const weights = points.map(() => 0.5 + random());
  const { point: center } = mesh.centerOfMass(points, weights, { normalize: true });
  const step = 1e-5 * mesh.info.diagonal;
  const moved = (point, way, length) => {
    const place = mesh.position(point).map((x, k) => x + length * way[k]);
    const at = mesh.nearestPoint(place).point;
    assert.equal(at.face, point.face);
    return at;
  };
  for (const [i, { axes, moves }] of (
    await pointDerivatives(mesh, points, weights, center)
  ).entries()) {
    for (const k of [0, 1]) {
      const gradientAt = async (length) => {
        const others = points.map((one, l) => (l === i ? moved(one, axes[k], length) : one));
        return (await energyAt(mesh, others, weights, moved(center, moves[k], length))).gradient;
      };
      const change = minus(await gradientAt(step), await gradientAt(-step));
      const left = Math.hypot(...change) / (4 * weights[i] * step);
      assert.ok(left < 1e-4, `point ${i}: ${left} of its pull is left`);
    }
  }
});

describe('the centroid of a region', async () => {
  const engine = await load();
  const remote = await loadInWorker();
  after(() => remote.dispose());

  /** The outline of a polygon on a plane. */
  const outline = (mesh, corners) =>
    corners.flatMap(([x, y], i) => {
      const to = corners[(i + 1) % corners.length];
      const [a, b] = [[x, y], to].map((at) => mesh.nearestPoint([...at, 0]).point);
      return mesh
        .shortestPath(a, b)
        .points()
        .slice(i === 0 ? 0 : 1);
    });

  test('on a plane is that of the polygon and its hole, up to rounding', async () => {
    const mesh = engine.meshFromObj(grid(cells));
    const whole = outline(mesh, [
      [1.3, 1.2],
      [8.4, 1.2],
      [1.3, 7.7],
    ]);
    const hole = outline(mesh, [
      [2.1, 2.2],
      [3.6, 2.2],
      [3.6, 3.1],
      [2.1, 3.1],
    ]);
    const [region] = mesh.regions([{ outlines: [whole, hole] }]);
    const [triangle, square] = [(7.1 * 6.5) / 2, 1.5 * 0.9];
    const wanted = [
      [1.3 + 7.1 / 3, 2.85],
      [1.2 + 6.5 / 3, 2.65],
    ].map(([of, out]) => (triangle * of - square * out) / (triangle - square));
    for (const on of [mesh, await remote.meshFromObj(grid(cells))]) {
      const found = await centroid(on, region);
      assert.ok(found.converged);
      near(found.position, [...wanted, 0], 1e-6);
    }
    const few = await centroid(mesh, region, { samples: 20 });
    assert.equal(few.samples, 20);
    near(few.position, [...wanted, 0], 0.3);
  });

  test('of a cap of a sphere is its middle', async () => {
    const mesh = engine.shape('sphere', 20_000);
    const pole = mesh.nearestPoint([0.2, 0.5, 0.8]).point;
    const place = mesh.position(pole);
    const outlines = mesh.isolines(pole, { radius: 0.8, type: 'exact' });
    const [cap] = mesh.regions([{ outlines, inside: 'left' }]);
    const { position, converged, samples } = await centroid(mesh, cap);
    assert.ok(converged);
    assert.equal(samples, 1000);
    near(position, place, 2e-3);
    const all = await centroid(mesh, cap, { samples: 1e5 });
    near(all.position, place, 1e-4);
  });

  test('requires samples and an area', async () => {
    const mesh = engine.meshFromObj(grid(cells));
    const corners = [
      [1.3, 1.2],
      [8.4, 1.2],
      [1.3, 7.7],
    ];
    const [region] = mesh.regions([outline(mesh, corners)]);
    await assert.rejects(centroid(mesh, region, { samples: 0 }), { code: 'badArgument' });
    await assert.rejects(centroid(mesh, region, { sample: 3 }), { code: 'badArgument' });
  });
});
