// A part of a cut surface becomes the surface to work on, with what lies on it of the drawing.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

describe('work on a part', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });
  const button = (tab, name) => tab.page.getByRole('button', { name, exact: true });
  const drawingOf = async (tab) => (await tab.state()).drawing;

  /** A sphere with a circle, a curve and an offset of it inside the circle, and a line outside. */
  async function cutSphere() {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    const draw = async (...places) => {
      await page.keyboard.press('b');
      await tab.choose('polyline');
      for (const [dx, dy] of places) await page.mouse.click(x + dx, y + dy);
      await page.keyboard.press('Enter');
      await tab.settled();
    };
    await tab.drag({ x, y }, { x: x + 110, y });
    await page.keyboard.press('Enter');
    await draw([-30, 10], [0, -30], [30, 10]);
    await page.keyboard.press('v');
    await page.locator('#objects .object').first().click();
    await page.locator('#makers').getByRole('button', { name: 'Offset', exact: true }).click();
    await tab.settled();
    await draw([150, -20], [150, 20]);
    await page.keyboard.press('v');
    await page.locator('#objects .object').last().click();
    await page.locator('#makers').getByRole('button', { name: 'Cut', exact: true }).click();
    await tab.settled();
    return { tab, x, y };
  }
  const onFile = async (tab) => {
    await tab.page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('file:'));
    await tab.settled();
  };
  /** The places of a drawing's points in space, of each object. */
  const placesIn = async (tab) => {
    const { positions, triangles } = await tab.mesh();
    const { objects } = await drawingOf(tab);
    return objects.map(({ figure }) => {
      const points = figure.circle ? [figure.circle.center] : figure.points;
      return points.map(({ face, bary }) =>
        [0, 1, 2].map((k) =>
          bary.reduce((sum, w, i) => sum + w * positions[3 * triangles[3 * face + i] + k], 0),
        ),
      );
    });
  };

  test('objects on the part come along to the same places, and the whole stays as it was', async () => {
    const { tab } = await cutSphere();
    const { page } = tab;
    const whole = await drawingOf(tab);
    const [circle, line] = await placesIn(tab);
    const { cut } = await tab.view();
    await tab.pastSaving();
    await button(tab, 'Work on Part 2').click();
    await onFile(tab);
    assert.match(
      await page.locator('#messages').textContent(),
      /You work on Part 2 of Sphere\. 3 of 4 objects came along\./,
    );
    const { info } = await tab.mesh();
    assert.equal(info.triangles, cut.parts[1].triangles.length / 3);
    assert.equal(info.boundaryLoops, 1);
    const own = await drawingOf(tab);
    assert.deepEqual(
      own.objects.map(({ figure }) => figure.kind),
      ['circle', 'polyline', 'offset'],
    );
    assert.deepEqual(own.objects[2].figure.derived.sources, [own.objects[1].id]);
    const [ownCircle, ownLine] = await placesIn(tab);
    for (const [was, is] of [
      [line, ownLine],
      [circle, ownCircle],
    ]) {
      assert.equal(was.length, is.length);
      was.forEach((place, i) => {
        const apart = Math.hypot(...place.map((value, k) => value - is[i][k]));
        assert.ok(apart < 1e-9, `${apart}`);
      });
    }
    // A step back removes what came along, and the way back leads to the whole.
    await page.keyboard.press('Control+z');
    await tab.settled();
    assert.equal(
      (await drawingOf(tab)).objects.filter(({ figure }) => figure.points.length).length,
      0,
    );
    await page.keyboard.press('Control+Shift+z');
    await tab.settled();
    assert.equal(JSON.stringify(await drawingOf(tab)), JSON.stringify(own));
    await tab.pastSaving();
    await page.reload();
    await tab.settled();
    assert.deepEqual((await drawingOf(tab)).objects.length, 3);
    assert.equal((await tab.mesh()).info.triangles, info.triangles);
    await page.goBack();
    await page.waitForFunction(() => window.karcherPage.state().mesh === 'sphere:3000');
    await tab.settled();
    assert.equal((await drawingOf(tab)).objects.length, whole.objects.length);
    assert.equal((await tab.view()).cut?.parts.length ?? 2, 2);
    await tab.close();
  });

  test('the menu at a part works on it, and the way back has the same drawing to the last byte', async () => {
    const { tab, x, y } = await cutSphere();
    const { page } = tab;
    const whole = JSON.stringify(await drawingOf(tab));
    await tab.pastSaving();
    await page.mouse.click(x + 60, y + 50, { button: 'right' });
    await page.getByRole('menuitem', { name: 'Work on Part 2', exact: true }).click();
    await onFile(tab);
    await tab.pastSaving();
    await page.goBack();
    const back = async () => {
      await page.waitForFunction(() => window.karcherPage?.state().mesh === 'sphere:3000');
      await tab.settled();
      assert.equal(JSON.stringify(await drawingOf(tab)), whole);
    };
    await back();
    await tab.pastSaving();
    await page.reload();
    await back();
    await tab.close();
  });

  test('a part, which no file of the user has, stays in the browser when files need its room', async () => {
    const { tab } = await cutSphere();
    const { page } = tab;
    await button(tab, 'Work on Part 2').click();
    await onFile(tab);
    const { mesh } = await tab.state();
    const tetrahedron = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';
    // There is room for the part and one more file.
    await page.evaluate(async (length) => {
      const files = await new Promise((resolve) => {
        indexedDB.open('karcher', 1).onsuccess = ({ target }) => {
          const store = target.result.transaction('files').objectStore('files');
          store.getAll().onsuccess = (all) => resolve(all.target.result);
        };
      });
      const quota = 2 * (files[0].content.size + 1.5 * length);
      navigator.storage.estimate = async () => ({ quota, usage: 0 });
    }, tetrahedron.length);
    for (const name of ['first.obj', 'second.obj']) {
      await tab.drop(name, `# ${name}\n${tetrahedron}`);
      await page.waitForFunction((end) => window.karcherPage.state().mesh.endsWith(end), name);
      await tab.settled();
    }
    await page.getByText('first.obj is no longer kept by this browser').waitFor();
    await page.evaluate((key) => {
      location.hash = `mesh=${key}`;
    }, mesh);
    await page.waitForFunction((key) => window.karcherPage.state().mesh === key, mesh);
    await tab.settled();
    await tab.close();
  });

  test('a saved part has the curves on it, except in STL', async () => {
    const { tab } = await cutSphere();
    const { page } = tab;
    const check = page.locator('#part-curves');
    assert.ok(await check.isDisabled());
    await page.locator('#part-format').selectOption('obj');
    const linesIn = async (part) => {
      const coming = page.waitForEvent('download');
      await button(tab, `Save ${part}`).click();
      const text = readFileSync(await (await coming).path(), 'utf8');
      return text.split('\n').filter((line) => line.startsWith('l ')).length;
    };
    // The curve, its offset and the circle; outside the circle and the line.
    assert.equal(await linesIn('Part 2'), 3);
    assert.equal(await linesIn('Part 1'), 2);
    await check.uncheck();
    assert.equal(await linesIn('Part 1'), 0);
    await tab.close();
  });
});
