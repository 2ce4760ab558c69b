// Distances along the surface from a point: as values, as lines, and on the page.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load as loadEngine } from 'karcher';
import { runnerImport } from 'vite';
import { browserOfSuite, Tab } from './browser.mjs';

const load = async (path) => {
  const file = fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
  const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
  return module;
};

const placesOf = (line) =>
  Array.from({ length: line.length / 3 }, (_, i) => Array.from(line.slice(3 * i, 3 * i + 3)));
const far = (p, q) => Math.hypot(...p.map((value, axis) => value - q[axis]));
const isClosed = (line) => far(placesOf(line)[0], placesOf(line).at(-1)) === 0;

describe('lines of equal value', () => {
  let lines;
  let planeArrays;
  before(async () => {
    lines = await load('model/level_lines.ts');
    ({ planeArrays } = await load('model/planes.ts'));
  });

  test('have steps of 1, 2 or 5 times a power of ten', () => {
    for (const most of [3e-7, 0.4, 1.93, 10.05, 99, 1e6]) {
      const step = lines.roundStep(most, 12);
      const digit = Number(step.toExponential()[0]);
      assert.ok([1, 2, 5].includes(digit), `${step}`);
      assert.equal(`${step}`.replace(/[0.]|e.*/g, '').length, 1, `${step}`);
      assert.ok(most / step <= 12.1 && most / step > 4.7, `${most} in steps of ${step}`);
    }
  });

  test('of distances on a plane are circles, whole ones closed and cut ones from side to side', async () => {
    const { tracedDistances } = await load('worker/distances.ts');
    const karcher = await loadEngine();
    const { positions, triangles } = planeArrays({ tessellation: 'delaunay', triangles: 5000 });
    const mesh = karcher.meshFromArrays(positions, triangles);
    const from = mesh.surfacePoint(mesh.info.triangles >> 1, [0.2, 0.3, 0.5]);
    const center = mesh.position(from);
    const traced = tracedDistances(mesh, from, { solver: 'fast' });
    const room = Math.min(center[0], center[1], 1 - center[0], 1 - center[1]);
    // The length h of the longest edge, along which distances are interpolated linearly: by Taylor,
    // the error is h * h / 8r.
    let h = 0;
    for (let i = 0; i < triangles.length; i++) {
      const next = i % 3 === 2 ? i - 2 : i + 1;
      const [p, q] = [triangles[i], triangles[next]].map((v) => positions.slice(3 * v, 3 * v + 3));
      h = Math.max(h, far(Array.from(p), Array.from(q)));
    }
    assert.ok(traced.lines.length >= 5);
    assert.ok(traced.complete);
    for (const [i, level] of traced.lines.entries()) {
      const radius = (i + 1) * traced.step;
      if (radius < 2 * h) continue;
      if (radius < room - h) assert.equal(level.length, 1, `one circle of radius ${radius}`);
      for (const line of level) {
        const ends = [placesOf(line)[0], placesOf(line).at(-1)];
        const onSide = ([x, y]) => [x, y, 1 - x, 1 - y].some((value) => Math.abs(value) < 1e-6);
        assert.ok(isClosed(line) || ends.every(onSide), `radius ${radius} from end to end`);
        for (const place of placesOf(line)) {
          assert.ok(Math.abs(far(place, center) - radius) < (h * h) / (8 * (radius - h)) + 1e-6);
        }
      }
    }
    mesh.dispose();
  });

  test('pass once through vertices, and end at values that are not numbers', () => {
    const { positions, triangles } = planeArrays({ tessellation: 'grid', triangles: 200 });
    const x = (corner) => positions[3 * triangles[corner]];
    const [[line, ...others]] = lines.levelLines(positions, triangles, x, [0.5]);
    assert.deepEqual(others, []);
    const places = placesOf(line);
    assert.ok(places.every(([at]) => Math.abs(at - 0.5) < 1e-7));
    assert.ok(Math.abs(far(places[0], places.at(-1)) - 1) < 1e-7, 'from side to side');
    const partly = (corner) => (positions[3 * triangles[corner] + 1] > 0.55 ? NaN : x(corner));
    for (const cut of lines.levelLines(positions, triangles, partly, [0.5])[0]) {
      assert.ok(placesOf(cut).every(([, y]) => y <= 0.55));
    }
    assert.deepEqual(lines.levelLines(positions, triangles, x, [2]), [[]]);
  });

  test('are absent where no path leads', async () => {
    const { tracedDistances } = await load('worker/distances.ts');
    const karcher = await loadEngine();
    const apart = [0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0];
    const mesh = karcher.meshFromArrays(apart, [0, 1, 2, 3, 4, 5]);
    const traced = tracedDistances(mesh, { vertex: 0 }, { solver: 'exact' });
    assert.equal(traced.complete, false);
    assert.deepEqual(Array.from(traced.values), [0, 1, 1, -1, -1, -1]);
    assert.ok(traced.lines.flat().every((line) => placesOf(line).every(([at]) => at <= 1)));
    mesh.dispose();
  });
});

describe('distances on the page', () => {
  const link = 'mesh=sphere:20000&kind=bspline&method=karcher-fast';
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, asUsers: true });

  const shown = (tab) => tab.page.locator('#distance-legend[aria-busy="false"]').waitFor();
  const traced = (tab) => tab.page.evaluate(() => window.karcherPage.distances());
  /** The visible surface, away from elements over it. */
  const picture = async (tab) => {
    await tab.still();
    const clip = { x: 500, y: 220, width: 400, height: 400 };
    return createHash('sha1')
      .update(await tab.page.screenshot({ clip, animations: 'disabled' }))
      .digest('hex');
  };

  test('start at the selected point, follow it, and disappear with one click', async () => {
    const tab = await Tab.open(browser, link);
    const { page } = tab;
    await tab.click([-120, -60], [-40, 90], [60, -80], [120, 60]);
    await page.keyboard.press('Escape');
    await page.keyboard.press('d');
    await page.getByRole('status').getByText('Select a point or a center first').waitFor();
    await page.locator('#points button').first().click();
    const before = await picture(tab);
    await page.locator('#view').click();
    await page.getByRole('menuitemcheckbox', { name: 'Distances' }).click();
    await shown(tab);
    const { most, step, lines } = (await traced(tab)).traced;
    const mesh = await tab.mesh();
    const radius = Math.hypot(...mesh.positions.slice(0, 3));
    // The antipode is half a great circle away, and the solver's largest distance is near that.
    assert.ok(Math.abs(most / (Math.PI * radius) - 1) < 0.02, `${most}`);
    const legend = await page.locator('#distance-legend').innerText();
    assert.match(legend, /^From point 1 of B-spline 1/);
    assert.match(legend, new RegExp(`Line every ${step}, farthest .* \\(surface’s unit\\)`));
    const numbers = await page.locator('#distance-ticks li').allInnerTexts();
    assert.ok(numbers.length >= 3 && numbers[0] === '0');
    assert.ok(numbers.every((number) => Number(number) <= most));
    const place = await page.evaluate(async () => {
      const { from } = window.karcherPage.distances();
      const { positions, triangles } = await window.karcherPage.mesh();
      const corners = [0, 1, 2].map((i) => 3 * triangles[3 * from.face + i]);
      return [0, 1, 2].map((axis) =>
        corners.reduce((sum, corner, i) => sum + from.bary[i] * positions[corner + axis], 0),
      );
    });
    const angle = (p, q) =>
      Math.acos(
        p.reduce((sum, value, i) => sum + value * q[i], 0) / Math.hypot(...p) / Math.hypot(...q),
      );
    for (const [i, level] of lines.entries()) {
      for (const line of level) {
        const values = Object.values(line);
        for (let at = 0; at < values.length; at += 3) {
          const away = radius * angle(place, values.slice(at, at + 3));
          assert.ok(Math.abs(away - (i + 1) * step) < 0.02 * radius, `${away} on line ${i + 1}`);
        }
      }
    }
    assert.notEqual(await picture(tab), before, 'the surface has colors');
    const start = (await traced(tab)).from;
    await tab.dragHandle('Control point 1 of', 30, 20);
    await page.waitForFunction((was) => {
      const { from, current } = window.karcherPage.distances();
      return current && `${from.face} ${from.bary}` !== was;
    }, `${start.face} ${start.bary}`);
    await tab.settled();
    const [moved] = (await tab.state()).figure.points;
    assert.deepEqual((await traced(tab)).from.face, moved.face, 'they follow the point');
    await page.locator('#points li').nth(2).locator('button').first().click();
    await page.getByText('From point 3 of B-spline 1').waitFor();
    await shown(tab);
    await page.keyboard.press('Control+z');
    await tab.settled();
    await page.locator('#points button').first().click();
    await page.getByText('From point 1 of B-spline 1').waitFor();
    await shown(tab);
    await page.getByRole('button', { name: 'Hide the distances' }).click();
    await page.locator('#distance-legend').waitFor({ state: 'hidden' });
    assert.equal(await page.locator('#distances').getAttribute('aria-checked'), 'false');
    assert.equal(await traced(tab), null);
    assert.equal(await picture(tab), before, 'the surface is as it was');
    await tab.close();
  });

  test('start at a circle’s center, and disappear with their point and their surface', async () => {
    const circle = '&points=&circle=300,0.3,0.3;0.3,0,0,1';
    const tab = await Tab.open(
      browser,
      `mesh=sphere:1500&kind=circle&method=karcher-fast${circle}`,
    );
    const { page } = tab;
    await page.setViewportSize({ width: 390, height: 844 });
    await page.locator('#stage').focus();
    await page.keyboard.press('d');
    await shown(tab);
    await page.getByText('From the center of Circle').waitFor();
    assert.equal((await traced(tab)).from.face, 300);
    const close = await page.locator('#distance-off').boundingBox();
    assert.ok(close.width >= 44 && close.height >= 44);
    await page.locator('#delete-object').click();
    await page.locator('#distance-legend').waitFor({ state: 'hidden' });
    await page.keyboard.press('Control+z');
    await tab.settled();
    await page.locator('#stage').focus();
    await page.keyboard.press('d');
    await shown(tab);
    await page.locator('#surface').selectOption('torus');
    await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('torus:'));
    await page.locator('#distance-legend').waitFor({ state: 'hidden' });
    await tab.close();
  });
});
