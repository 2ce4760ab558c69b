import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';

const karcher = await load();

test('a curve round the torus has bridges where it has no center, and says where', () => {
  const mesh = karcher.shape('torus', 2000);
  const { triangles } = mesh.info;
  // Faces spread over the torus.
  const points = Array.from({ length: 7 }, (_, i) => ({
    face: (i * 801 + 5) % triangles,
    bary: [0.2, 0.3, 0.5],
  }));
  const curve = mesh.curve({ kind: 'bspline', points, samples: 64, levels: 0 });
  const bridged = curve.bridged();
  const samples = curve.samples();
  const marks = curve.unconverged();
  assert.ok(bridged.length > 0);
  for (const { segment, t0, t1, reason } of bridged) {
    assert.ok(segment >= 0 && segment < 4);
    assert.ok(0 <= t0 && t0 < t1 && t1 <= 1);
    assert.ok(['jump', 'indefinite', 'noProgress', 'limit'].includes(reason), reason);
  }
  samples.status.forEach((status, i) => {
    const inside = bridged.some(
      ({ segment, t0, t1 }) =>
        segment === samples.segment[i] && t0 <= samples.t[i] && samples.t[i] <= t1,
    );
    if (status === 'bridged') assert.ok(inside);
    else assert.equal(status, 'converged');
  });
  assert.equal(marks.length, curve.polyline().length / 3);
  assert.ok(marks.includes(1) && marks.includes(0));
  mesh.dispose();
});
