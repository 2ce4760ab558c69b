import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { exactFields, grid, partsOf } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const paper = { method: 'paper', solver: 'exact' };
const cells = 16;
const center = { vertex: 8 + (cells + 1) * 8 };

test('on a plane a geodesic circle is a circle', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  for (const [arcs, field] of [3, 7].flatMap((n) => exactFields.map((f) => [n, f]))) {
    const radius = arcs === 3 ? 2 : 4.5;
    const circle = mesh.circle(center, { radius, arcs, samples: 40, ...field });
    const { samples } = circle;
    assert.equal(samples.count, 40 * arcs);
    assert.deepEqual(new Set(samples.segment), new Set(Array.from({ length: arcs }, (_, i) => i)));
    for (let i = 0; i < samples.count; i++) {
      const [x, y, z] = samples.position.slice(3 * i, 3 * i + 3);
      assert.ok(Math.abs(Math.hypot(x - 8, y - 8) - radius) < 1e-9 && z === 0);
    }
    // The chords of n equal angles fall short by a part of (pi / n)^2 / 6; these angles are less
    // equal.
    const perimeter = 2 * Math.PI * radius;
    const { path } = circle;
    assert.ok(path.length < perimeter && path.length > 0.999 * perimeter);
    assert.equal(path.closed, true);
    assert.equal(path.count, circle.unconverged.length);
    assert.ok(circle.unconverged.every((mark) => mark === 0));
    assert.deepEqual(circle.notShortest, []);
  }
});

test('on a plane circles and ellipses are the same at every level', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const ellipse = { radii: [4.5, 3], direction: [1, 0, 0] };
  for (const levels of [0, 3, 'auto', 'limit']) {
    const round = mesh.circle(center, { radius: 4.5, levels });
    const long = mesh.ellipse(center, { ...ellipse, levels });
    // A plane needs no level.
    const expected = levels === 'auto' ? 0 : levels;
    if (levels !== 'limit') assert.deepEqual([round.levels, long.levels], [expected, expected]);
    else assert.ok(round.levels > 0 && long.levels > 0);
    for (const [{ samples }, radius] of [
      [round, 4.5],
      [long, 3],
    ]) {
      assert.equal(samples.count, 7 * 32);
      for (let i = 0; i < samples.count; i++) {
        const [x, y] = samples.position.slice(3 * i, 3 * i + 2);
        assert.ok(Math.abs(Math.hypot((x - 8) / 4.5, (y - 8) / radius) - 1) < 1e-9);
      }
    }
  }
  assert.throws(() => mesh.circle(center, { radius: 3, levels: 9 }), { code: 'badArgument' });
  assert.throws(() => mesh.circle(center, { radius: 3, levels: 2, ...paper }), {
    code: 'badArgument',
  });
});

test('on a sphere a circle keeps its distance, and says how far it is off', () => {
  const mesh = karcher.shape('sphere', 8000);
  const around = { face: 1234, bary: [0.2, 0.3, 0.5] };
  const offOf = ({ samples }) => {
    let worst = 0;
    for (let i = 0; i < samples.count; i += 5) {
      const bary = Array.from(samples.bary.slice(3 * i, 3 * i + 3));
      const { length } = mesh.shortestPath(around, { face: samples.face[i], bary });
      worst = Math.max(worst, Math.abs(length / 0.7 - 1));
    }
    return worst;
  };
  const circle = mesh.circle(around, { radius: 0.7 });
  assert.ok(circle.deviation <= 1e-3 && offOf(circle) <= circle.deviation + 1e-9);
  const seven = mesh.circle(around, { radius: 0.7, arcs: 7 });
  assert.equal(seven.samples.count, 7 * 32);
  assert.ok(seven.deviation > 0.01 && offOf(seven) > 0.9 * seven.deviation);
  assert.ok(mesh.circle(around, { radius: 0.7, tolerance: 1e-4 }).deviation <= 1e-4);
  assert.equal(mesh.circle(around, { radius: 0.7, samples: 2, arcs: 3 }).samples.count, 6);
});

test('impossible circles are refused', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const good = { radius: 3, ...paper };
  const shown = () => {
    const { path, ...rest } = mesh.circle(center, good);
    return { ...rest, path: partsOf(path) };
  };
  const expected = shown();
  assert.equal(expected.samples.count, 7 * 32);
  const wrong = [
    [{ radius: 7.9 }, 'boundary', /arc \d+ .* boundary/],
    [{ radius: 100 }, 'radiusTooLarge', /100 .* farthest/],
    [{ radius: 0 }, 'badArgument', /radius/],
    [{ radius: -1 }, 'badArgument', /radius/],
    [{ radius: Number.NaN }, 'notFinite', /radius/],
    [{ radius: '3' }, 'badArgument', /radius/],
    [{ arcs: 2 }, 'badArgument', /3 to 64 arcs/],
    [{ arcs: 65 }, 'badArgument', /3 to 64 arcs/],
    [{ arcs: 0 }, 'badArgument', /3 to 64 arcs, not 0/],
    [{ arcs: '7' }, 'badArgument', /number of arcs/],
    [{ tolerance: 0 }, 'badArgument', /tolerance must be a positive number, not 0/],
    [{ samples: 1 }, 'badArgument', /samples/],
    [{}, 'badIndex', /vertex -5/, { vertex: -5 }],
    [{}, 'badArgument', /the center/, null],
  ];
  for (const [change, code, message, about = center] of wrong) {
    assert.throws(() => mesh.circle(about, { ...good, ...change }), {
      name: 'KarcherError',
      code,
      message,
    });
    assert.deepEqual(shown(), expected);
  }
  const sphere = karcher.shape('sphere', 2000);
  assert.throws(() => sphere.circle({ vertex: 0 }, { radius: 3.2, ...paper }), {
    code: 'radiusTooLarge',
  });
});

test('an arc beyond the cut locus is marked', () => {
  // The mesh is a torus, with the center on its tube: geodesics round the hole meet behind it.
  const mesh = karcher.shape('torus', 6000);
  const circle = mesh.circle({ vertex: 0 }, { radius: 1.6, ...paper });
  assert.ok(circle.notShortest.length > 0);
  for (const arc of circle.notShortest) assert.ok(arc >= 0 && arc < 7);
});

test('on a plane an ellipse is an ellipse', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const options = { radii: [4, 1.5], direction: [1, 1, 0], samples: 20, ...paper };
  const { samples } = mesh.ellipse(center, options);
  const named = { ...options, direction: { x: 1, y: 1, z: 0 } };
  assert.deepEqual(mesh.ellipse(center, named).samples, samples);
  assert.equal(samples.count, 7 * 20);
  for (let i = 0; i < samples.count; i++) {
    const [x, y] = samples.position.slice(3 * i, 3 * i + 2).map((value) => value - 8);
    const [along, across] = [x + y, y - x].map((value) => value / Math.SQRT2);
    assert.ok(Math.abs(Math.hypot(along / 4, across / 1.5) - 1) < 1e-9);
  }
  for (const wrong of [
    { radii: [1] },
    { radii: [1, 0] },
    { direction: [0, 0, 1] },
    { direction: [1, 0] },
  ]) {
    assert.throws(() => mesh.ellipse(center, { ...options, ...wrong }), { code: 'badArgument' });
  }
});

test('isolines: the exact one on a plane is the circle, the linear one near it', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const [exact, ...more] = mesh.isolines(center, { radius: 4.5 });
  assert.deepEqual(more, []);
  assert.equal(exact.closed, true);
  assert.ok(Math.abs(exact.length - 9 * Math.PI) < 1e-6);
  const polyline = exact.polyline({ bits: 64 });
  const lengths = exact.lengths();
  assert.equal(lengths[0], 0);
  assert.equal(lengths.at(-1), exact.length);
  for (let i = 0; i < polyline.length; i += 3) {
    const [x, y] = polyline.slice(i, i + 2);
    if (i > 0) assert.ok(lengths[i / 3] > lengths[i / 3 - 1]);
    assert.ok(Math.abs(Math.hypot(x - 8, y - 8) - 4.5) < 1e-9);
  }
  for (const solver of ['fast', 'exact', 'graph']) {
    const [linear] = mesh.isolines(center, { radius: 4.5, type: 'linear', solver });
    assert.equal(linear.closed, true);
    assert.ok(Math.abs(linear.length / (9 * Math.PI) - 1) < 0.03);
  }
  assert.deepEqual(mesh.isolines(center, { radius: 100 }), []);
  assert.throws(() => mesh.isolines(center, { radius: -1 }), { code: 'badArgument' });
  assert.throws(() => mesh.isolines(center, { radius: 1, type: 'round' }), {
    code: 'badArgument',
  });
});
