// The first minute of a new user: the page's first display, and the first actions.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

const sizes = {
  wide: { width: 1280, height: 800 },
  narrow: { width: 390, height: 844 },
};
const examples = { bunny: 7, ball: 3, windings: 2, hearts: 4 };

/** The page without a drawing in its address, as on a first visit. */
async function visit(browser) {
  const tab = new Tab(await browser.context.newPage(), browser.address);
  await tab.page.goto(`${browser.address}?antialias=off`);
  await tab.settled();
  return tab;
}

for (const [name, viewport] of Object.entries(sizes)) {
  describe(`the first minute in a ${name} window`, () => {
    const browser = browserOfSuite({ viewport });

    const inWindow = name === 'wide' ? test : inLongRun;
    inWindow('has a drawing that can be dragged at once, and a line that says so', async () => {
      const tab = await visit(browser);
      const { page } = tab;
      await page.locator('#tour-skip').click();
      assert.match(await page.locator('#hint').textContent(), /^Drag a line or a point/);
      const { drawing, tool } = await tab.state();
      assert.equal(drawing.objects.length, examples.bunny);
      assert.equal(tool, 'select');
      const view = await tab.view();
      assert.equal(view.problem, null);
      assert.ok(
        view.others.every(({ lines }) => lines.length > 0),
        'all of it is drawn',
      );
      assert.deepEqual(view.curve.lost, []);

      await tab.dragHandle('Anchor 1 of 10', 6, -8);
      const moved = await tab.state();
      const figureOf = (state, id) => state.drawing.objects.find((one) => one.id === id).figure;
      const { active } = drawing;
      assert.notDeepEqual(
        figureOf(moved, active).points[0],
        figureOf({ drawing }, active).points[0],
      );
      assert.equal(figureOf(moved, active).points.length, 10, 'and nothing is added');

      const heart = view.others.findIndex(({ id }) => id === 4);
      const from = await tab.onCurve(0.2, heart);
      await tab.drag(from, { x: from.x + 8, y: from.y + 6 });
      const again = await tab.state();
      assert.equal(again.drawing.active, 4, 'a line is dragged, too');
      assert.notDeepEqual(figureOf(again, 4).points, figureOf(moved, 4).points);
      for (let step = 0; step < 3; step++) await page.keyboard.press('Control+z');
      await tab.settled();
      assert.equal(JSON.stringify((await tab.state()).drawing), JSON.stringify(drawing));
      await tab.close();
    });

    inLongRun('a click on the surface adds nothing until a tool is chosen', async () => {
      const tab = await visit(browser);
      const { page } = tab;
      const { x, y } = await tab.middle();
      const before = await tab.state();
      await page.mouse.click(x, y - 10);
      await tab.settled();
      const bytes = (state) => JSON.stringify(state.drawing);
      assert.equal(bytes(await tab.state()), bytes(before));
      await page.locator('#tool-curve').click();
      const { figure: begun } = await tab.state();
      assert.deepEqual([begun.kind, begun.points.length], ['bspline', 0], 'another object begins');
      await page.locator('#surface').selectOption('sphere');
      await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('sphere:'));
      await tab.click([-30, 30], [0, 10], [30, 30], [40, 0]);
      const { drawing, figure } = await tab.state();
      assert.equal(drawing.objects.length, 1);
      assert.equal(figure.settings.clamped, true);
      const { polyline } = await tab.view();
      const places = await page.evaluate(
        (ends) => ends.map((end) => window.karcherPage.seen(end)),
        [polyline.slice(0, 3), polyline.slice(-3)],
      );
      for (const [i, [dx, dy]] of [
        [-30, 30],
        [40, 0],
      ].entries()) {
        const away = Math.hypot(places[i].x - (x + dx), places[i].y - (y + dy));
        assert.ok(away < 2, `a new B-spline reaches its ends: ${away} pixels away`);
      }
      await page.close();
    });
  });
}

describe('the tour and the examples', () => {
  const browser = browserOfSuite({ viewport: sizes.wide });

  test('five steps lead through the page, once', async () => {
    const tab = await visit(browser);
    const { page } = tab;
    const card = page.locator('#tour');
    const titles = [];
    for (let step = 1; step <= 5; step++) {
      assert.equal(await page.locator('#tour-count').textContent(), `${step} of 5`);
      titles.push(await page.locator('#tour-title').textContent());
      const [box, toured] = [await card.boundingBox(), await page.locator('.toured').boundingBox()];
      assert.ok(box.x >= 0 && box.x + box.width <= 1280 && box.y >= 0 && box.y + box.height <= 800);
      const apart =
        box.x >= toured.x + toured.width || box.y >= toured.y + toured.height || step === 1;
      assert.ok(apart, `step ${step} does not cover what it speaks of`);
      await page.locator('#tour-next').click();
    }
    assert.equal(new Set(titles).size, 5);
    assert.equal(await card.isVisible(), false);
    await page.reload();
    await tab.settled();
    assert.equal(await card.isVisible(), false, 'it is not shown again');
    const { tool, drawing } = await tab.state();
    assert.deepEqual([tool, drawing.objects.length], ['select', examples.bunny]);
    await page.locator('#help').click();
    await page.locator('#tour-start').click();
    // The tour appears only on request.
    await card.waitFor();
    await page.keyboard.press('Escape');
    await card.waitFor({ state: 'hidden' });
    await tab.close();
  });

  inLongRun(
    'the tour continues from dragging to drawing when a file leaves no curve to drag',
    async () => {
      const tab = await visit(browser);
      const { page } = tab;
      const step = () => page.locator('#tour-count').textContent();
      const begin = async () => {
        await page.locator('#help').click();
        await page.locator('#tour-start').click();
        await page.locator('#tour').waitFor();
      };
      await begin();
      assert.equal(await step(), '1 of 5');
      await tab.drop('own.obj', 'v 0 0 0\nv 4 0 0\nv 4 6 0\nv 0 6 0\nf 1 2 3\nf 1 3 4\n');
      await page.waitForFunction(() => window.karcherPage.triangles === 2);
      await tab.settled();
      assert.equal(await page.locator('#tour').isVisible(), true);
      assert.equal(await step(), '2 of 5');
      assert.equal(await page.locator('#tool-rail.toured').count(), 1);
      await page.locator('#tour-skip').click();
      await begin();
      assert.equal(await step(), '2 of 5', 'nor does it begin with that');
      await tab.close();
    },
  );

  inLongRun(
    'each example opens whole, and undo brings back what it took the place of',
    async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:20000');
      await tab.click([-40, 0], [40, 0]);
      for (const [id, count] of Object.entries(examples)) {
        await tab.page.locator('#examples').click();
        await tab.page.locator(`[data-example="${id}"]`).click();
        await tab.page.waitForFunction(
          (wanted) => window.karcherPage.state().drawing.objects.length === wanted,
          count,
        );
        const { curve, others, problem } = await tab.view();
        assert.equal(problem, null);
        assert.ok(curve && others.length === count - 1);
        assert.deepEqual(curve.lost, [], `${id}: all of it is a center of mass`);
        assert.equal((await tab.state()).tool, 'select');
      }
      await tab.page.locator('#examples').click();
      await tab.page.locator('[data-example="ball"]').click();
      await tab.page.waitForFunction(() => window.karcherPage.state().mesh === 'sphere:20000');
      await tab.settled();
      await tab.page.keyboard.press('Control+z');
      await tab.settled();
      const { figure, drawing } = await tab.state();
      assert.deepEqual([drawing.objects.length, figure.points.length], [1, 2]);
      await tab.close();
    },
  );

  test('a B-spline of an older link does not change', async () => {
    const points = [10, 200, 400, 600].map((face) => `${face},0.3,0.3`).join(';');
    const tab = await Tab.open(browser, `mesh=sphere:1500&kind=bspline&points=${points}`);
    assert.equal((await tab.state()).figure.settings.clamped, false);
    await tab.page.close();
  });
});
