// The curvature comb: its numbers against closed forms, and its display on the page.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { browserOfSuite, Tab } from './browser.mjs';

const unit = (place) => place.map((value) => value / Math.hypot(...place));
const up = () => [0, 0, 1];
/** A closed polyline; `place` maps a parameter from 0 to 1 to a point. */
const closedLine = (place, count) =>
  Array.from({ length: count + 1 }, (_, i) => place((i % count) / count)).flat();

describe('a curvature comb', () => {
  let model;
  before(async () => {
    const file = fileURLToPath(new URL('../../web/model/comb.ts', import.meta.url));
    ({ module: model } = await runnerImport(file, { configFile: false, logLevel: 'error' }));
  });

  /** The circle of a geodesic radius on the unit sphere, counterclockwise as seen from outside. */
  const circle = (radius, count) =>
    closedLine((part) => {
      const angle = 2 * Math.PI * part;
      const around = Math.sin(radius);
      return [around * Math.cos(angle), around * Math.sin(angle), Math.cos(radius)];
    }, count);

  for (const radius of [0.2, 0.7, 1.2, Math.PI / 2, 2.4]) {
    test(`of a circle of radius ${radius.toFixed(2)} on the unit sphere has the cotangent as its curvature`, () => {
      const line = circle(radius, 2000);
      const chord = 2 * Math.sin(radius) * Math.sin(Math.PI / 2000);
      // The window consists of whole chords, whose three vertices lie on this very circle.
      const comb = model.combOf(line, unit, () => 100, 20 * chord);
      assert.equal(comb.closed, true);
      assert.equal(comb.corners, 0);
      assert.equal(comb.teeth.length, 100);
      for (const { curvature, foot, left } of comb.teeth) {
        assert.ok(Math.abs(curvature - 1 / Math.tan(radius)) < 1e-8, `${curvature}`);
        const [along, across] = [foot, [0, 0, 1]].map((one) =>
          one.reduce((sum, value, i) => sum + value * left[i], 0),
        );
        assert.ok(Math.abs(along) < 1e-8, 'teeth lie in the tangent plane');
        assert.ok(across > 0, 'left of a counterclockwise circle is its inside');
      }
      const { teeth } = model.combOf(line, unit, () => 137, 0.1 * Math.sin(radius));
      // Feet within chords are off by up to chord² / 8ρ, over a window of 0.1 ρ.
      for (const { curvature } of teeth) {
        assert.ok(Math.abs(curvature - 1 / Math.tan(radius)) * Math.sin(radius) < 1e-3);
      }
      const back = Array.from({ length: line.length / 3 }, (_, i) =>
        line.slice(line.length - 3 * i - 3, line.length - 3 * i),
      ).flat();
      const [tooth] = model.combOf(back, unit, () => 100, 20 * chord).teeth;
      assert.ok(Math.abs(tooth.curvature + 1 / Math.tan(radius)) < 1e-8, 'turned around');
    });
  }

  test('of an ellipse in the plane has its curvature, from the least to the greatest', () => {
    const [a, b] = [2, 1];
    const place = (part) => [a * Math.cos(2 * Math.PI * part), b * Math.sin(2 * Math.PI * part), 0];
    const { teeth } = model.combOf(closedLine(place, 40_000), up, () => 400, 0.02);
    for (const { foot, curvature } of teeth) {
      const [x, y] = [foot[0] / a, foot[1] / b];
      const expected = (a * b) / (a * a * y * y + b * b * x * x) ** 1.5;
      assert.ok(Math.abs(curvature - expected) < 1e-3 * expected, `${curvature} for ${expected}`);
    }
    const usual = model.usualCurvature([{ teeth }], 1);
    assert.ok(Math.abs(usual - a / (b * b)) < 0.01);
  });

  test('has no teeth at corners, and is 0 on straight lines', () => {
    const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0];
    const comb = model.combOf(square, up, () => 80, 0.1);
    assert.equal(comb.corners, 4);
    assert.ok(comb.teeth.length >= 60 && comb.teeth.length < 80);
    assert.ok(comb.teeth.every(({ curvature }) => Math.abs(curvature) < 1e-12));
    // The line crosses an edge of a cube, whose normal there lies between those of its faces.
    const [s, normal] = [Math.SQRT1_2, ([x]) => (x < 1 ? [0, 0, 1] : [s, 0, s])];
    const over = model.combOf([0, 0, 0, 1, 0.4, 0, 1, 0.8, -1], normal, () => 9, 0.1);
    assert.equal(over.corners, 0);
    for (const nothing of [[], [1, 2, 3], [1, 2, 3, 1, 2, 3]]) {
      assert.deepEqual(model.combOf(nothing, up, () => 9, 0.1).teeth, []);
    }
  });
});

describe('the comb on the page', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, asUsers: true });

  test('is initially off, has the numbers and the scale of a circle, and one click removes it', async () => {
    // A circle of radius 0.6 about a point of the sphere.
    const sphere = 'mesh=sphere:20000&kind=circle&circletype=exact&method=karcher-exact&points=';
    const tab = await Tab.open(browser, `${sphere}&circle=300,0.3,0.3;0.6,0,0,1`);
    const { page } = tab;
    const legend = page.locator('#comb-legend');
    const picture = async () => {
      await tab.still();
      const clip = { x: 420, y: 220, width: 500, height: 440 };
      return createHash('sha1')
        .update(await page.screenshot({ clip, animations: 'disabled' }))
        .digest('hex');
    };
    await page.locator('#stage').focus();
    await page.keyboard.press('Escape');
    assert.equal(await legend.isVisible(), false);
    const plain = await picture();
    await page.locator('#view').click();
    await page.getByRole('menuitemcheckbox', { name: 'Curvature' }).click();
    await legend.waitFor();
    const { positions } = await tab.mesh();
    const radius = Math.hypot(...positions.slice(0, 3));
    const expected = 1 / Math.tan(0.6 / radius) / radius;
    const note = await page.locator('#comb-note').innerText();
    const [, greatest] = /Greatest ([\d.]+) per unit/.exec(note);
    // The greatest of all teeth shows the facets of the mesh.
    assert.ok(Number(greatest) > 0.97 * expected && Number(greatest) < 1.25 * expected, note);
    const first = await picture();
    assert.notEqual(first, plain);
    const scale = page.getByRole('slider', { name: 'Teeth' });
    await scale.focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
    assert.equal(await scale.getAttribute('aria-valuetext'), '2 ×');
    assert.notEqual(await picture(), first, 'longer teeth');
    await page.getByRole('button', { name: 'Hide the curvature' }).click();
    await legend.waitFor({ state: 'hidden' });
    assert.equal(await picture(), plain);
    assert.equal(await page.locator('#comb').getAttribute('aria-checked'), 'false');
    await tab.close();
  });

  test('follows the selection, and has large targets for fingers', async () => {
    const tab = await Tab.open(
      browser,
      'mesh=sphere:1500&kind=bspline&method=karcher-fast&points=',
    );
    const { page } = tab;
    await page.setViewportSize({ width: 390, height: 844 });
    await page.locator('#stage').focus();
    await page.keyboard.press('u');
    await page.getByText('There is no curve here: select one.').waitFor();
    await tab.click([-40, -30], [-10, 40], [30, -30], [50, 30]);
    await page.locator('#comb-note').getByText('Greatest').waitFor();
    for (const id of ['comb-off', 'comb-scale']) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.width >= 44 && box.height >= 44, id);
      assert.ok(box.x >= 0 && box.x + box.width <= 390, id);
    }
    await page.locator('#new-object').click();
    await page.getByText('There is no curve here: select one.').waitFor();
    await page.locator('#comb-off').click();
    await page.locator('#comb-legend').waitFor({ state: 'hidden' });
    await tab.close();
  });
});
