// The user stops a computation that takes too long, and the page continues with the same surface.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

const places = [
  [-150, 60],
  [-60, 150],
  [60, 150],
  [150, 60],
];

describe('a computation without an end', () => {
  const browser = browserOfSuite();

  const open = async () => {
    const tab = await Tab.open(browser, 'mesh=torus:5000&method=karcher-fast');
    await tab.click(...places);
    return tab;
  };
  const stop = (tab) => tab.page.getByRole('button', { name: 'Stop', exact: true });

  test('of a curve is stopped by a button, and an edit traces it anew', async () => {
    const tab = await open();
    const { page } = tab;
    const { info, triangles } = await tab.mesh();
    const from = await tab.handle('Control point 2 of 4');
    await tab.holdEngine();
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 10, from.y + 10);
    await page.mouse.up();
    await page.getByText('computing…', { exact: true }).waitFor();
    await stop(tab).click();
    await page.getByText('It was stopped; an edit or another method').waitFor();
    await stop(tab).waitFor({ state: 'hidden' });
    // Another worker replaces the one that no longer responds.
    await tab.dragHandle('Control point 3 of 4', 6, 8);
    const { polyline, problem } = await tab.view();
    assert.equal(problem, null);
    assert.deepEqual(await tab.mesh().then((mesh) => [mesh.info, mesh.triangles]), [
      info,
      triangles,
    ]);
    assert.deepEqual(tab.logged, []);
    const { drawing } = await tab.state();
    await page.reload();
    assert.deepEqual((await tab.view()).polyline, polyline);
    assert.deepEqual((await tab.state()).drawing, drawing);
    await page.close();
  });

  test('of distances is cancelled when they are no longer wanted', async () => {
    const tab = await open();
    const { page } = tab;
    const { polyline } = await tab.view();
    await page.locator('#points button').first().click();
    await tab.holdEngine();
    await page.keyboard.press('d');
    await page.locator('#distance-legend[aria-busy="true"]').waitFor();
    await page.getByText('computing…', { exact: true }).waitFor();
    await page.keyboard.press('d');
    await page.getByText('computing…', { exact: true }).waitFor({ state: 'hidden' });
    await page.keyboard.press('d');
    await page.locator('#distance-legend[aria-busy="false"]').waitFor();
    assert.deepEqual((await tab.view()).polyline, polyline);
    await tab.dragHandle('Control point 2 of 4', 10, 10);
    assert.notDeepEqual((await tab.view()).polyline, polyline);
    await tab.close();
  });

  inLongRun('on a phone shows a button with a target of 44 pixels', async () => {
    const tab = await open();
    const { page } = tab;
    const from = await tab.handle('Control point 2 of 4');
    await tab.holdEngine();
    await tab.page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 10, from.y + 10);
    await page.mouse.up();
    await page.setViewportSize({ width: 390, height: 844 });
    await stop(tab).waitFor();
    const rows = await stop(tab).evaluate((button) => {
      const { left, width, top } = button.getBoundingClientRect();
      const isHit = (y) => document.elementFromPoint(left + width / 2, y) === button;
      return Array.from({ length: 80 }, (_, i) => isHit(top - 40 + i)).filter(Boolean).length;
    });
    assert.ok(rows >= 44, `${rows} rows of pixels`);
    await page.close();
  });
});
