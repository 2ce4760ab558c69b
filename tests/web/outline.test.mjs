// The surface's outline and its visible parts: against closed forms, and in a saved file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load as loadEngine } from 'karcher';
import { BufferAttribute, BufferGeometry, Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { runnerImport } from 'vite';
import { browserOfSuite, Tab } from './browser.mjs';

const load = async (path) => {
  const file = fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
  const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
  return module;
};

const placesOf = (line, size = 3) =>
  Array.from({ length: line.length / size }, (_, i) =>
    Array.from(line.slice(size * i, size * (i + 1))),
  );
const far = (p, q) => Math.hypot(...p.map((value, axis) => value - q[axis]));
const lengthOf = (line, size = 3) =>
  placesOf(line, size)
    .slice(1)
    .reduce((sum, place, i) => sum + far(place, placesOf(line, size)[i]), 0);
const total = (lines, size) => lines.reduce((sum, line) => sum + lengthOf(line, size), 0);

const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
  (i & 1) - 0.5,
  ((i >> 1) & 1) - 0.5,
  (i >> 2) - 0.5,
]);
const cube = {
  positions: Float32Array.from(corners.flat()),
  triangles: Uint32Array.from([
    ...[0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4],
    ...[2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5],
  ]),
};

const treeOf = ({ positions, triangles }) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return new MeshBVH(geometry, { indirect: true });
};

const stage = { width: 800, height: 600 };
function sightFrom(eye) {
  const camera = new PerspectiveCamera(30, stage.width / stage.height, 0.01, 100);
  camera.position.set(...eye);
  camera.lookAt(new Vector3());
  camera.updateMatrixWorld();
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  // The number of pixels for a slope of 1 from the middle.
  const pixels = stage.height / 2 / Math.tan((15 * Math.PI) / 180);
  return { sight: { eye, matrix: matrix.toArray(), ...stage }, pixels };
}

describe('the outline', () => {
  let parts;
  let sphere;
  before(async () => {
    parts = { ...(await load('viewer/outline.ts')), ...(await load('viewer/hidden_lines.ts')) };
    const karcher = await loadEngine();
    const mesh = karcher.shape('sphere', 5000);
    const radius = Math.hypot(...mesh.positions().slice(0, 3));
    sphere = {
      positions: Float32Array.from(mesh.positions(), (value) => value / radius),
      triangles: Uint32Array.from(mesh.triangles()),
    };
    mesh.dispose();
  });

  test('of a sphere is the circle of its tangents from the eye', () => {
    for (const eye of [
      [0, 0, 3],
      [1, -2, 4],
      [-6, 1, 0.5],
    ]) {
      const away = Math.hypot(...eye);
      const { contours, creases, boundary } = parts.outlineOf(sphere, eye);
      assert.deepEqual([creases, boundary], [[], []]);
      assert.equal(contours.length, 1, 'one line');
      const [line] = contours;
      assert.equal(far(placesOf(line)[0], placesOf(line).at(-1)), 0, 'closed');
      for (const place of placesOf(line)) {
        // The circle has p · (e − p) = 0 on the unit sphere. Facets of 5000 triangles lie 1e-3
        // below it.
        const along = place.reduce((sum, value, i) => sum + value * eye[i], 0) / away;
        assert.ok(Math.abs(along - 1 / away) < 0.01, `${along} for ${1 / away}`);
      }
      const { sight, pixels } = sightFrom(eye);
      const seen = parts.seenOutline(sphere, treeOf(sphere), sight);
      const radius = pixels / Math.sqrt(away * away - 1);
      for (const [x, y] of seen.flatMap((part) => placesOf(part, 2))) {
        const off = Math.hypot(x - stage.width / 2, y - stage.height / 2);
        assert.ok(Math.abs(off - radius) < 0.004 * radius, `${off} for ${radius}`);
      }
      // The whole circle is visible: no other part of a sphere hides it.
      assert.ok(Math.abs(total(seen, 2) / (2 * Math.PI * radius) - 1) < 0.02);
    }
  });

  test('of a cube consists of its edges, and those at the back are hidden', () => {
    const eye = [2.1, 1.7, 3.3];
    const { contours, creases, boundary } = parts.outlineOf(cube, eye);
    assert.deepEqual([contours, boundary], [[], []]);
    assert.ok(Math.abs(total(creases) - 12) < 1e-6, 'twelve edges, without diagonals');
    const { sight } = sightFrom(eye);
    const tree = treeOf(cube);
    const visible = creases.flatMap((line) => parts.visibleParts(line, tree, sight, 0));
    // The three edges at the corner away from the eye are hidden, except for their very ends.
    assert.ok(Math.abs(total(visible) - 9) < 0.12, `${total(visible)}`);
    const away = [-0.5, -0.5, -0.5];
    for (const place of visible.flatMap((line) => placesOf(line))) {
      assert.ok(far(place, away) > 0.9, 'nothing near the hidden corner');
    }
    // From the front the cube is a square, which hides the depth behind it.
    const front = sightFrom([0, 0, 4]);
    const seen = parts.seenOutline(cube, tree, front.sight);
    const side = front.pixels / 3.5;
    for (const [x, y] of seen.flatMap((part) => placesOf(part, 2))) {
      const off = Math.max(Math.abs(x - stage.width / 2), Math.abs(y - stage.height / 2));
      assert.ok(Math.abs(off - side / 2) < 0.02 * side);
    }
    assert.ok(Math.abs(total(seen, 2) / (4 * side) - 1) < 0.05);
  });

  test('of an open sheet includes its boundary, and nothing behind the camera', () => {
    const positions = Float32Array.from([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
    const square = { positions, triangles: Uint32Array.from([0, 1, 2, 0, 2, 3]) };
    const { boundary, creases, contours } = parts.outlineOf(square, [0.2, 0.1, 5]);
    assert.deepEqual([creases, contours], [[], []]);
    assert.equal(total(boundary), 8);
    const { sight } = sightFrom([0.2, 0.1, 5]);
    const away = Float32Array.from([0, 0, 6, 0, 1, 7]);
    assert.deepEqual(parts.visibleParts(away, treeOf(square), sight, 0), []);
    const passing = Float32Array.from([0.7, 0.1, 4, 0.7, 0.1, 6]);
    const seen = parts.visibleParts(passing, treeOf(square), sight, 0);
    assert.ok(total(seen) > 0.9);
    for (const [x, y, z] of seen.flatMap((part) => placesOf(part))) {
      // The camera looks at the origin from (0.2, 0.1, 5).
      assert.ok(0.2 * (0.2 - x) + 0.1 * (0.1 - y) + 5 * (5 - z) > 0, `${[x, y, z]}`);
    }
  });
});

describe('a saved outline', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  /** The distances of the outline's points from the stage's middle, and the other lines' opacities. */
  async function savedOutline({ page }) {
    const coming = page.waitForEvent('download');
    await page.locator('#save').click();
    // The open menu takes the focus, which must not happen between the focus and the key.
    await page.waitForFunction(() => document.activeElement?.role === 'menuitem');
    await page.getByRole('menuitem', { name: 'with the surface’s outline' }).press('Enter');
    const download = await coming;
    assert.match(download.suggestedFilename(), /\.svg$/);
    const svg = readFileSync(await download.path(), 'utf8');
    const { outline, others } = await page.evaluate((text) => {
      const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
      // Points all along the curves of a path.
      const read = (path) => {
        const length = path.getTotalLength();
        return Array.from({ length: 200 }, (_, i) => {
          const { x, y } = path.getPointAtLength((i * length) / 199);
          return [x, y];
        });
      };
      return {
        outline: [...root.querySelectorAll('#outline path')].flatMap(read),
        others: [...root.querySelectorAll('g > path:not(#outline path)')].map((path) =>
          path.getAttribute('opacity'),
        ),
      };
    }, svg);
    const { width, height } = await page.locator('#stage').boundingBox();
    return { radii: outline.map(([x, y]) => Math.hypot(x - width / 2, y - height / 2)), others };
  }

  test('surrounds the surface, and leaves out hidden parts', async () => {
    const points = '&points=&circle=300,0.3,0.3;0.5,0,0,1';
    const tab = await Tab.open(
      browser,
      `mesh=sphere:5000&kind=circle&method=karcher-fast${points}`,
    );
    await tab.still();
    const { radii, others } = await savedOutline(tab);
    assert.ok(radii.length >= 200);
    const [least, most] = [Math.min(...radii), Math.max(...radii)];
    assert.ok(most / least < 1.02 && least > 150, `a circle, from ${least} to ${most}`);
    assert.ok(
      others.every((opacity) => opacity === null),
      'nothing faint',
    );
    await tab.close();
  });

  test('is that of the visible parts of a cut, with their rim', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:6000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    // The circle around the stage's middle appears as a circle.
    await tab.drag({ x, y }, { x: x + 90, y });
    const button = (name) => page.getByRole('button', { name, exact: true });
    await button('Cut').click();
    await tab.settled();
    const lines = async () => {
      const { radii } = await savedOutline(tab);
      return {
        rim: radii.some((radius) => Math.abs(radius - 90) < 3),
        contour: radii.some((radius) => radius > 150),
        between: radii.some((radius) => Math.abs(radius - 90) >= 3 && radius <= 150),
      };
    };
    assert.deepEqual(await lines(), { rim: false, contour: true, between: false }, 'both parts');
    await button('Show or hide Part 2').click();
    await tab.settled();
    assert.deepEqual(await lines(), { rim: true, contour: true, between: false }, 'the rest');
    await button('Show or hide Part 2').click();
    await button('Show or hide Part 1').click();
    await tab.settled();
    assert.deepEqual(await lines(), { rim: true, contour: false, between: false }, 'the cap');
    await button('Delete Part 2').click();
    await tab.settled();
    assert.deepEqual(await lines(), { rim: false, contour: false, between: false }, 'nothing');
    await tab.close();
  });
});
