import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';

const karcher = await load();
const badArgument = { name: 'KarcherError', code: 'badArgument' };

/** Faces all over a torus: so far apart that means of all of them break. */
function farPoints(mesh) {
  const { triangles } = mesh.info;
  const bary = [0.2, 0.3, 0.5];
  return Array.from({ length: 7 }, (_, i) => ({ face: (i * 801 + 5) % triangles, bary }));
}

test('a curve of far points holds together by as many levels as it needs', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = farPoints(mesh);
  const spline = (levels) => mesh.curve({ kind: 'bspline', points, samples: 64, levels });
  const mean = spline(0);
  assert.equal(mean.levels, 0);
  assert.ok(mean.bridged().length > 0);
  const steady = mesh.curve({ kind: 'bspline', points, samples: 64 });
  assert.ok(steady.levels > 0);
  assert.deepEqual(steady.bridged(), []);
  assert.ok(steady.samples().status.every((status) => status === 'converged'));
  // The same number of levels gives the same curve.
  assert.deepEqual(spline(steady.levels).polyline(), steady.polyline());
  const limit = spline('limit');
  assert.deepEqual(limit.bridged(), []);
  assert.equal(limit.samples().t.length, steady.samples().t.length);
  assert.ok(Math.abs(limit.length - steady.length) < 0.02 * steady.length);
  mesh.dispose();
});

test('a curve of near points on a smooth surface is a mean of all of them', () => {
  const mesh = karcher.shape('sphere', 5000);
  const near = [0, 1, 2, 3].map((i) => ({ face: i, bary: [0.4, 0.3, 0.3] }));
  assert.equal(mesh.curve({ kind: 'bezier', points: near }).levels, 0);
  mesh.dispose();
});

test('levels are 0 to 8, auto or limit, and none for the paper and for means of all points', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = farPoints(mesh);
  for (const levels of [-1, 9, 1.5, 'all', null]) {
    assert.throws(() => mesh.curve({ kind: 'bezier', points, levels }), badArgument, `${levels}`);
  }
  const paper = { kind: 'bezier', points, samples: 9, method: 'paper', solver: 'exact' };
  assert.throws(() => mesh.curve({ ...paper, levels: 2 }), badArgument);
  assert.equal(mesh.curve(paper).levels, 0);
  assert.equal(mesh.curve({ kind: 'barycentric', points, samples: 9, levels: 3 }).levels, 0);
  mesh.dispose();
});

test('a dragged point takes its legs along, a moved one has the shortest', () => {
  // Half around the tube there are two ways; the hand goes on around it.
  const mesh = karcher.shape('torus', 2000);
  const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
  const line = mesh.curve({ kind: 'polyline', points: [start, start], samples: 2 });
  let place = start;
  let walked = 0;
  for (let step = 1; step <= 60; step++) {
    const path = mesh.straightest(start, [0, 0, 1], step * 0.05);
    place = path.end;
    walked = step * 0.05;
    line.dragPoint(1, place);
  }
  assert.equal(line.length.toFixed(9), walked.toFixed(9));
  // A leg stays while its ends do.
  line.movePoint(1, place);
  assert.equal(line.length.toFixed(9), walked.toFixed(9));
  line.movePoint(1, { vertex: 0 });
  line.movePoint(1, place);
  const shortest = mesh.shortestPath(start, place).length;
  assert.equal(line.length.toFixed(9), shortest.toFixed(9));
  assert.ok(shortest < walked / 2);
  mesh.dispose();
});
