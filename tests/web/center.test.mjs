// The center of mass of points with weights.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { farthestFromSurface } from './on_surface.mjs';
import { inLongRun } from './part.mjs';
import { lengthOf } from './polylines.mjs';

describe('a center of mass', () => {
  const browser = browserOfSuite();

  test('of two points moves along their shortest path with the weights', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=center');
    const hint = tab.page.locator('#hint');
    assert.equal(await hint.textContent(), 'Click the surface to place a point');
    await tab.click([-60, 30], [70, 60]);
    const middle = await tab.view();
    assert.equal(middle.curve, null);
    assert.deepEqual([middle.center.status, middle.quality], ['converged', 'exact']);
    const [a, b] = middle.legs.map(lengthOf);
    // A quadratic interpolates exact distances between vertices, with errors of a few hundredths of
    // an edge.
    const { meanEdge } = (await tab.mesh()).info;
    assert.ok(Math.abs(a - b) <= 0.1 * meanEdge, `${a} ${b}`);
    const distance = a + b;
    const half = (distance / 2) ** 2;
    assert.ok(Math.abs(middle.center.energy - half) <= 0.01 * half, 'weights are shared out');
    const shown = await tab.page.locator('#status').textContent();
    // The numbers of the refined answer, by exact paths.
    assert.match(shown, /energy [\d.]+ · residual [\d.e-]+/);
    const { certificate } = middle.center;
    assert.ok(Math.abs(certificate.energy - half) <= 1e-3 * half, `${certificate.energy} ${half}`);
    assert.ok(certificate.residual <= 0.1 * meanEdge, `${certificate.residual}`);

    // A slider's 64 steps run from 1/16 to 16: 16 of them from 1 to 4.
    const slider = tab.page.getByRole('slider', { name: 'Weight of point 1' });
    await slider.fill(`${32 + 16}`);
    await tab.settled();
    const weighted = await tab.view();
    assert.deepEqual(
      (await tab.state()).figure.points.map(({ weight = 1 }) => weight),
      [4, 1],
    );
    const [near, far] = weighted.legs.map(lengthOf);
    assert.ok(Math.abs(near - distance / 5) <= 0.1 * meanEdge, `${near} of ${distance}`);
    assert.ok(Math.abs(near + far - distance) <= 1e-3 * distance, 'on the path');
    const rows = await tab.page.locator('#points li').allTextContents();
    assert.deepEqual(rows, ['180.0 %', '220.0 %'], 'numbers and shares');

    await tab.page.keyboard.press('Escape');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+z');
    const back = await tab.view();
    assert.deepEqual(back.center.position, middle.center.position);
    await tab.close();
  });

  test('of many points is drawn, follows a drag, and comes back with the link', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500');
    await tab.page.keyboard.press('9');
    await tab.click([-80, -60], [80, -50], [60, 90], [-70, 80], [10, -100]);
    const first = await tab.view();
    assert.equal(first.legs.length, 5);
    const mark = tab.page.locator('.mass-center');
    assert.ok(await mark.isVisible());
    const surface = await tab.mesh();
    const tolerance = 2e-6 * surface.info.diagonal;
    for (const leg of first.legs) assert.ok(farthestFromSurface(leg, surface) <= tolerance);

    const before = await mark.boundingBox();
    await tab.dragHandle('Point 3 of 5', 30, 20);
    const after = await mark.boundingBox();
    assert.ok(after.x > before.x + 2 && after.y > before.y + 1, 'it is drawn towards the point');
    await tab.page.getByRole('slider', { name: 'Weight of point 2' }).fill('60');
    await tab.settled();
    const { center } = await tab.view();
    await tab.page.waitForFunction(() => /points=[^&]*,11\.31/.test(location.hash));
    await tab.page.reload();
    const again = await tab.view();
    assert.deepEqual(again.center.position, center.position);
    assert.equal(again.legs.length, 5);
    await tab.close();
  });

  test('that is one of several is reported as such', async () => {
    // Points lie all around the sphere, so that the end of a search depends on its start.
    const tab = await Tab.open(browser, 'mesh=sphere:5000&kind=center');
    const { triangles } = (await tab.mesh()).info;
    const faces = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6].map((part) => Math.floor(part * triangles));
    const points = faces.map((face) => `${face},0.3,0.3`).join(';');
    await tab.page.evaluate((text) => {
      location.hash = `mesh=sphere:5000&kind=center&points=${text}`;
    }, points);
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.points.length === 6);
    const { center } = await tab.view();
    assert.equal(center.uniqueness, 'notUnique');
    const hint = await tab.page.locator('#hint').textContent();
    assert.match(hint, /Not the only center: \d+ other minim(um|a), of energy [\d.]+/);
    assert.match(await tab.page.locator('#status-length').textContent(), /not the only center/);
    // The page draws each minimum with its energy.
    const tags = await tab.page
      .locator('.mass-center.other')
      .evaluateAll((all) => all.map(({ dataset }) => Number(dataset.tag)));
    assert.equal(tags.length, center.otherMinima.length);
    for (const tag of tags) assert.ok(tag >= Number(center.energy.toPrecision(4)), `${tag}`);
    await tab.close();
  });

  inLongRun('says whether it is the only one while points are dragged', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=center');
    await tab.click([-30, -30], [30, -25], [20, 40]);
    const words = () => tab.page.locator('#status-length').textContent();
    assert.match(await words(), /· certainly the only center$/);
    assert.equal(await tab.page.locator('.mass-center.other').count(), 0);
    await tab.dragHandle('Point 3 of 3', 10, 100);
    const { center } = await tab.view();
    const expected = {
      certain: 'certainly the only center',
      likely: 'likely the only center',
      notUnique: 'not the only center',
    }[center.uniqueness];
    assert.ok((await words()).endsWith(`· ${expected}`), await words());
    await tab.close();
  });
});
