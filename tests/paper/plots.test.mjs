// The plots of convergence and roughness.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { load } from './load.mjs';

let peers;
let study;
let rough;
let plots;
before(async () => {
  peers = await loadPeers();
  study = await load('claims/convergence.ts');
  rough = await load('claims/roughness.ts');
  plots = await load('plots/plots.ts');
});

describe('the smooth curves', () => {
  test('on the sphere the center is where the weighted logarithms cancel', () => {
    const { points, center } = study.sphereCurve();
    const weights = [0.1, 0.4, 0.3, 0.2];
    const mean = center(weights);
    assert.ok(Math.abs(Math.hypot(...mean) - 1) < 1e-15);
    const dot = (a, b) => a.reduce((sum, x, c) => sum + x * b[c], 0);
    const sum = [0, 0, 0];
    for (const [i, p] of points.entries()) {
      const angle = Math.acos(dot(mean, p));
      for (let c = 0; c < 3; c++) {
        sum[c] += (weights[i] * angle * (p[c] - Math.cos(angle) * mean[c])) / Math.sin(angle);
      }
    }
    assert.ok(Math.hypot(...sum) < 1e-13, `${sum}`);
    assert.deepEqual(
      center([0, 1, 0, 0]).map((x) => Number(x.toFixed(12))),
      points[1].map((x) => Number(x.toFixed(12))),
    );
  });

  test('on the torus the center lies on the circle of the points, which is projected to itself', () => {
    const { points, center, project } = study.torusCurve();
    const near = (a, b) => assert.ok(Math.hypot(...a.map((x, c) => x - b[c])) < 1e-14);
    near(center([1, 0, 0, 0]), points[0]);
    const mean = center([0.25, 0.25, 0.25, 0.25]);
    near(project(mean), mean);
    assert.ok(
      Math.abs(Math.atan2(mean[1], mean[0]) - Math.atan2(points[0][1], points[0][0])) < 1e-15,
    );
  });
});

describe('the studies', () => {
  test('on finer meshes ours comes nearer, and the order is that of the slope', async () => {
    const told = [];
    const found = await study.convergence(peers, {
      sizes: [500, 2000, 8000],
      methods: ['paper', 'karcher', 'karcherExact'],
      tell: (points) => told.push(points.length),
    });
    assert.equal(found.length, 2 * 3 * 3);
    assert.deepEqual(
      told,
      [...Array(18).keys()].map((k) => k + 1),
    );
    for (const surface of ['sphere', 'torus']) {
      const plot = plots.convergencePlot(found, surface);
      assert.equal(plot.x.length, 3);
      const order = (method) => {
        const { values } = plot.lines.find((line) => line.method === method);
        assert.ok(
          values.every((value) => value > 0),
          method,
        );
        return plots.orderOf(plot, values);
      };
      for (const method of ['karcher', 'karcherExact']) {
        assert.ok(order(method) > 1, `${surface}, ${method}: ${order(method)}`);
      }
    }
    for (const { error, meanEdge, method } of found) {
      if (method !== 'paper') assert.ok(error < 0.02 * meanEdge, `${method}: ${error / meanEdge}`);
    }
    assert.equal(plots.orderOf({ x: [1, 2, 4], lines: [] }, [3, 12, 48]), 2);
    assert.equal(plots.orderOf({ x: [1, 2], lines: [] }, [3, null]), null);
  });

  test('noise makes residuals grow', async () => {
    const found = await rough.roughness(peers, { triangles: 5000, methods: ['karcher', 'paper'] });
    const { x, lines } = plots.roughnessPlot(found);
    assert.deepEqual(x, [...rough.noises]);
    for (const { method, values } of lines) {
      assert.equal(values.length, x.length);
      assert.ok(values.at(-1) > values[0], `${method}: ${values}`);
    }
  });
});
