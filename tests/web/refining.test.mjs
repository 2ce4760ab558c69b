// The two qualities of a curve: the draft during a drag, and the exact one after it.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun, part } from './part.mjs';

const places = [
  [-110, 40],
  [-40, -10],
  [40, 50],
  [110, -10],
];
/** The largest median shift that is invisible, in mean edges. */
const unseen = 0.2;

const samplesOf = (tab) =>
  tab.page.evaluate(() => Array.from(window.karcherPage.view().curve.samples.position));

/** The median distance of two curves' samples. */
function medianShift(from, to) {
  assert.equal(from.length, to.length);
  const shifts = [];
  for (let i = 0; i < from.length; i += 3) {
    shifts.push(Math.hypot(...[0, 1, 2].map((axis) => to[i + axis] - from[i + axis])));
  }
  shifts.sort((a, b) => a - b);
  return (shifts[(shifts.length - 1) >> 1] + shifts[shifts.length >> 1]) / 2;
}

/** Points spread over a surface with holes: some samples have more than one center. */
const scattered = [3713, 2975, 4071, 3269, 3294, 1757].map((face) => `${face},0.3,0.3`).join(';');

describe('the exact curve after the draft', () => {
  const browser = browserOfSuite();

  const around = [
    [-150, 60],
    [-60, 150],
    [60, 150],
    [150, 60],
  ];
  const shapes = { 'bunny:0': places, 'torus:5000': around };
  for (const [mesh, clicks] of part(Object.entries(shapes), 1)) {
    test(`replaces it on ${mesh} when a drag ends, without a jump`, async (t) => {
      const tab = await Tab.open(browser, `mesh=${mesh}&method=karcher&levels=1`);
      const mark = tab.page.locator('#status-quality');
      await tab.click(...clicks);
      assert.equal(await mark.textContent(), 'exact');

      const from = await tab.handle('Control point 2 of 4');
      await tab.page.mouse.move(from.x, from.y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(from.x + 20, from.y - 15, { steps: 4 });
      await tab.settled();
      assert.equal(await mark.textContent(), 'draft', 'while the point is held');
      const draft = await samplesOf(tab);
      await tab.page.mouse.up();
      await tab.settled();
      assert.equal(await mark.textContent(), 'exact');
      const { shift } = await tab.view();
      const { meanEdge } = (await tab.mesh()).info;
      const measured = medianShift(draft, await samplesOf(tab)) / meanEdge;
      t.diagnostic(`median shift: ${measured.toPrecision(3)} mean edges`);
      assert.ok(Math.abs(measured - shift.median) <= 1e-9, 'the page measures the same');
      assert.ok(measured > 0 && measured <= unseen, `${measured}`);

      const exact = await tab.view();
      await tab.page.locator('#method').selectOption('karcher-exact');
      await tab.page.waitForFunction(() => window.karcherPage.state().method === 'karcher-exact');
      const direct = await tab.view();
      const { diagonal } = (await tab.mesh()).info;
      assert.equal(direct.polyline.length, exact.polyline.length);
      const off = direct.polyline.map((x, i) => Math.abs(x - exact.polyline[i]));
      assert.ok(Math.max(...off) <= 1e-6 * diagonal, 'it is the curve of the exact method');
      await tab.close();
    });
  }

  test('never delays the next drag', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&method=karcher');
    await tab.click(...places);
    const from = await tab.handle('Control point 2 of 4');
    await tab.drag(from, { x: from.x + 10, y: from.y });

    // The test holds the refining engine until the drags are over.
    let release;
    const released = new Promise((resolve) => {
      release = resolve;
    });
    await browser.context.route('**/held', async (route) => {
      await released;
      await route.fulfill({ body: '' });
    });
    const held = tab.engines()[1].evaluate(() => {
      const request = new XMLHttpRequest();
      request.open('GET', '/held', false);
      request.send();
    });
    const answered = () =>
      tab.page.waitForFunction(() => {
        const [state, view] = [window.karcherPage.state(), window.karcherPage.view()];
        return state.revision === view.revision;
      });
    const drafts = [];
    for (const step of [1, 2, 3]) {
      const place = await tab.handle('Control point 2 of 4');
      await tab.page.mouse.move(place.x, place.y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(place.x + 6, place.y + 8, { steps: 3 });
      await answered();
      drafts.push(await samplesOf(tab));
      await tab.page.mouse.up();
      await answered();
      // The page requests the exact curve in a turn of its own, after it has shown the draft.
      await tab.page.waitForFunction(() => {
        const { quality, refining } = window.karcherPage.view();
        return refining || quality !== 'draft';
      });
      const { quality } = await tab.page.evaluate(() => window.karcherPage.view());
      assert.equal(quality, 'draft', `drag ${step}`);
    }
    assert.notDeepEqual(drafts[0], drafts[2]);
    release();
    await held;
    const last = await tab.view();
    assert.equal(last.quality, 'exact');
    const { meanEdge } = (await tab.mesh()).info;
    assert.ok(
      medianShift(drafts[2], await samplesOf(tab)) <= unseen * meanEdge,
      'of the last drag',
    );
    await tab.close();
  });

  inLongRun('is a circle too', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=circle&method=karcher');
    await tab.click([0, 40]);
    const { quality, shift, curve } = await tab.view();
    assert.equal(quality, 'exact');
    assert.ok(curve && shift.median <= unseen, `${shift.median}`);
    await tab.close();
  });

  test('is computed by another engine if the first one stopped', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&method=karcher');
    await tab.click(...places);
    const refining = tab.engines()[1];
    await refining.evaluate(() => {
      setTimeout(() => {
        throw new Error('out of luck');
      });
    });
    await tab.dragHandle('Control point 2 of 4', 10, 10);
    assert.equal((await tab.view()).quality, 'exact', 'without a word');
    assert.equal(await tab.page.getByRole('alert').count(), 0);
    await tab.page.close();
  });
});

describe('parts of a curve without a center', () => {
  const browser = browserOfSuite({ viewport: { width: 1100, height: 760 } });

  test('do not exist with as many levels as needed, which a drag keeps', async () => {
    const tab = await Tab.open(browser, `mesh=genus3:5000&kind=bspline&points=${scattered}`);
    const { curve } = await tab.view();
    assert.ok(curve.levels > 0);
    assert.deepEqual(curve.lost, []);
    const from = await tab.handle('Control point 2 of 6');
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(from.x + 12, from.y - 9, { steps: 4 });
    await tab.settled();
    // A drag keeps the levels, or at least two of them if they take too long.
    const held = (await tab.view()).curve;
    assert.ok(held.levels >= Math.min(curve.levels, 2), `${held.levels}`);
    assert.deepEqual(held.lost, []);
    await tab.page.mouse.up();
    await tab.settled();
    const { curve: released } = await tab.view();
    assert.deepEqual(released.lost, []);
    assert.ok(released.levels > 0);
    // The curve without levels breaks here: the mean of all points.
    await tab.page.locator('#levels').selectOption('0');
    await tab.settled();
    const { curve: mean } = await tab.view();
    assert.equal(mean.levels, 0);
    assert.ok(mean.lost.length > 0);
    await tab.page.waitForFunction(() => location.hash.includes('levels=0'));
    await tab.close();
  });

  test('are counted and listed, and a click shows the place', async () => {
    const tab = await Tab.open(
      browser,
      `mesh=genus3:5000&kind=bspline&points=${scattered}&levels=0`,
    );
    const { curve } = await tab.view();
    const lost = curve.lost.reduce((sum, { samples }) => sum + samples, 0);
    assert.ok(lost > 0 && lost < curve.samples.count, `${lost}`);
    for (const { segment, from, to, samples } of curve.lost) {
      assert.ok(segment >= 0 && segment < 3 && 0 <= from && from <= to && to <= 1);
      assert.ok(samples <= (to - from) * 127 + 1);
    }
    const drawn = Object.values(curve.polylineStatus);
    assert.ok(drawn.includes(0) && drawn.includes(1), 'it is drawn otherwise');
    const badge = tab.page.locator('#status-lost');
    // Between two good samples the line is fine, and the page reports nothing.
    const seen = curve.lost.filter(({ samples, reason }) => samples > 0 || reason === 'jump');
    const count = seen.length === 1 ? '1 place' : `${seen.length} places`;
    assert.equal(await badge.textContent(), `${count} to check`);

    const list = tab.page.locator('#lost');
    assert.equal(await list.locator('#lost-count').textContent(), `${seen.length}`);
    const rows = list.locator('li button');
    assert.equal(await rows.count(), seen.length);
    assert.equal(await list.locator('h3').count(), new Set(seen.map(({ reason }) => reason)).size);

    const from = await tab.handle('Control point 1 of 6');
    await rows.first().click();
    const beacon = tab.page.locator('.beacon');
    await beacon.waitFor();
    // The view flies there, until the mark rests in the middle of the stage.
    await tab.still();
    const box = await beacon.boundingBox();
    const middle = await tab.middle();
    assert.ok(Math.hypot(box.x + 22 - middle.x, box.y + 22 - middle.y) < 2);
    const to = await tab.handle('Control point 1 of 6');
    assert.ok(Math.hypot(to.x - from.x, to.y - from.y) > 5, 'the view has turned');
    await badge.click();
    await tab.page.keyboard.press('Home');
    await tab.close();
  });
});
