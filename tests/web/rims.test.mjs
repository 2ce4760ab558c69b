// Gestures that start at vertices of the rim, with the magnet and a real mouse.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { linesOf } from './circle_views.mjs';
import { far, vertices } from './polylines.mjs';

/**
 * A square of 8 x 8 without its upper right quarter, as OBJ text. At its reentrant corner (4, 4)
 * the faces turn by 3 pi / 2. Straight lines lead from there to all of the sheet, as in the plane.
 */
function sheetWithCorner() {
  const lines = [];
  const at = (i, j) => 1 + i + 9 * j;
  for (let j = 0; j <= 8; j++) for (let i = 0; i <= 8; i++) lines.push(`v ${i} ${j} 0`);
  for (let j = 0; j < 8; j++) {
    for (let i = 0; i < 8; i++) {
      if (i >= 4 && j >= 4) continue;
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

const rims = [
  { name: 'a reentrant corner', vertex: [4, 4, 0], turn: 1.5 * Math.PI },
  { name: 'a straight rim', vertex: [0, 4, 0], turn: Math.PI },
];

describe('from a vertex of the rim', () => {
  const browser = browserOfSuite();

  let sheets = 0;

  /** Drops the sheet as another file each time, since the page keeps a drawing for each file. */
  async function openSheet() {
    const tab = await Tab.open(browser);
    await tab.drop('sheet.obj', `# ${++sheets}\n${sheetWithCorner()}`);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 96);
    await tab.still();
    if ((await tab.page.locator('#snap').getAttribute('aria-pressed')) !== 'true') {
      await tab.page.keyboard.press('g');
    }
    const seen = (place) => tab.page.evaluate((at) => window.karcherPage.seen(at), place);
    const near = async (place) => {
      const { x, y } = await seen(place);
      return { x: x + 2, y: y + 1 };
    };
    const placeOf = async ({ face, bary }) => {
      const { positions, triangles } = await tab.mesh();
      return [0, 1, 2].map((axis) =>
        bary.reduce((sum, w, i) => sum + w * positions[3 * triangles[3 * face + i] + axis], 0),
      );
    };
    const click = async (place) => {
      const { x, y } = await near(place);
      await tab.page.mouse.move(x, y);
      await tab.page.mouse.click(x, y);
    };
    const drag = async (from, to) => {
      const [a, b] = [await near(from), await near(to)];
      await tab.page.mouse.move(a.x, a.y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(b.x, b.y, { steps: 6 });
      await tab.page.mouse.up();
      await tab.settled();
    };
    return { tab, page: tab.page, click, drag, placeOf };
  }

  for (const { name, vertex, turn } of rims) {
    test(`the pen’s handles give the planar curve at ${name}`, async () => {
      const { tab, page, click, drag, placeOf } = await openSheet();
      await page.keyboard.press('p');
      const [handle, end] = [
        [2, 3, 0],
        [1, 1, 0],
      ];
      await drag(vertex, handle);
      await click(end);
      const { polyline, problem } = await tab.view();
      assert.equal(problem, null);
      const { points } = (await tab.state()).drawing.objects[0].figure;
      assert.ok(far(await placeOf(points[0]), vertex) < 1e-12);
      const line = vertices(polyline);
      for (const [i, place] of line.entries()) {
        // The nearest place of the cubic whose last two control points are its end.
        const off = Math.min(
          ...Array.from({ length: 1001 }, (_, k) => {
            const t = k / 1000;
            const weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t) + t ** 3];
            return far(
              place,
              [vertex, handle, end].reduce(
                (sum, p, j) => sum.map((value, axis) => value + weights[j] * p[axis]),
                [0, 0, 0],
              ),
            );
          }),
        );
        assert.ok(off < 0.02, `vertex ${i} of the line is ${off} from the planar curve`);
      }
      assert.ok(far(line[0], vertex) < 1e-6 && far(line.at(-1), end) < 1e-6);
      await tab.close();
    });

    test(`circles keep their radius at ${name}`, async () => {
      const { tab, page, drag, placeOf } = await openSheet();
      await page.keyboard.press('7');
      await drag(vertex, [2, 3, 0]);
      const radius = Math.hypot(vertex[0] - 2, vertex[1] - 3);
      await page.getByLabel('Type').selectOption('exact');
      const view = await tab.view();
      const { circle } = (await tab.state()).figure;
      assert.ok(far(await placeOf(circle.center), vertex) < 1e-12);
      assert.ok(Math.abs(view.circle.radius - radius) < 1e-9, `${view.circle.radius}`);
      let length = 0;
      for (const line of linesOf(view)) {
        const places = vertices(line);
        for (const [i, place] of places.entries()) {
          assert.ok(Math.abs(far(place, vertex) - radius) < 1e-4);
          if (i > 0) length += far(place, places[i - 1]);
        }
      }
      assert.ok(Math.abs(length - turn * radius) < 0.02 * radius, `${length}`);
      await tab.close();
    });

    test(`a mirror’s line is that of the plane at ${name}`, async () => {
      const { tab, page, click, placeOf } = await openSheet();
      await page.keyboard.press('p');
      const places = [vertex, [1, 2, 0], [3, 1, 0]];
      for (const place of places) await click(place);
      await page.keyboard.press('Enter');
      await page.keyboard.press('Escape');
      await page.keyboard.press('v');
      await page.keyboard.press('Control+a');
      await page.keyboard.press('i');
      await page.locator('#mirror-copies').check();
      await click(vertex);
      await page.getByText('second point').waitFor();
      await click([2, 2, 0]);
      await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
      await tab.settled();
      const [, image] = (await tab.state()).drawing.objects;
      const along = [2 - vertex[0], 2 - vertex[1]];
      const square = along[0] ** 2 + along[1] ** 2;
      for (const [i, point] of image.figure.points.entries()) {
        const off = [places[i][0] - vertex[0], places[i][1] - vertex[1]];
        const part = (2 * (off[0] * along[0] + off[1] * along[1])) / square;
        const expected = [
          vertex[0] + part * along[0] - off[0],
          vertex[1] + part * along[1] - off[1],
          0,
        ];
        const error = far(await placeOf(point), expected);
        assert.ok(error < 1e-9, `point ${i + 1} is ${error} off`);
      }
      await tab.close();
    });

    test(`a move is that of the plane at ${name}`, async () => {
      const { tab, page, click, drag, placeOf } = await openSheet();
      await page.keyboard.press('p');
      const places = [vertex, [1, 2, 0], [3, 1, 0]];
      for (const place of places) await click(place);
      await page.keyboard.press('Enter');
      await page.keyboard.press('v');
      // The pointer hits the line only once it is drawn.
      await tab.settled();
      await drag([2, 1.5, 0], vertex[0] > 0 ? [1.5, 1, 0] : [2.5, 1, 0]);
      const { points } = (await tab.state()).drawing.objects[0].figure;
      const moved = await Promise.all(points.map(placeOf));
      const step = moved[0].map((value, axis) => value - vertex[axis]);
      assert.ok(Math.hypot(...step) > 0.3, `${step}`);
      for (const [i, place] of moved.entries()) {
        const error = far(
          place,
          places[i].map((value, axis) => value + step[axis]),
        );
        assert.ok(error < 1e-9, `point ${i + 1} is ${error} off`);
      }
      await tab.close();
    });
  }
});
