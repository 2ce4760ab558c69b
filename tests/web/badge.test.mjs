// A badge made with the mouse: circles are united, cut out of each other and trimmed, then filled,
// given a rim, cut out of the surface and saved. Its area is compared with a count of points of the
// sphere.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { browserOfSuite, Tab } from './browser.mjs';
import { inLongRun } from './part.mjs';

const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

/** Points that cover the unit sphere evenly (a Fibonacci lattice). */
const lattice = Array.from({ length: 200_000 }, (_, i) => {
  const height = 1 - (2 * i + 1) / 200_000;
  const angle = i * Math.PI * (3 - Math.sqrt(5));
  const around = Math.sqrt(1 - height ** 2);
  return [around * Math.cos(angle), around * Math.sin(angle), height];
});
const areaWhere = (isInside) => (4 * Math.PI * lattice.filter(isInside).length) / lattice.length;

inLongRun('a badge of three booleans is filled, offset, cut out and saved', async () => {
  const tab = await Tab.open(browser, 'mesh=sphere:6000');
  const { page } = tab;
  const { x, y } = await tab.middle();
  const near = (value, wanted, part, what) =>
    assert.ok(Math.abs(value - wanted) < part * wanted, `${what}: ${value}, not ${wanted}`);
  const make = async (name) => {
    await page.locator('#makers').getByRole('button', { name, exact: true }).click();
    await tab.settled();
  };
  const { positions, triangles } = await tab.mesh();
  const placeOf = ({ face, bary }) =>
    [0, 1, 2].map((k) =>
      bary.reduce((sum, part, i) => sum + part * positions[3 * triangles[3 * face + i] + k], 0),
    );
  const drawCircle = async (dx, dy, reach) => {
    await page.keyboard.press('o');
    await tab.drag({ x: x + dx, y: y + dy }, { x: x + dx + reach, y: y + dy });
    const { radius } = (await tab.view()).circle;
    const { center } = (await tab.state()).figure.circle;
    await page.keyboard.press('Enter');
    return { center: placeOf(center), radius };
  };
  const isIn = (point, { center, radius }) => {
    const [a, b] = [point, center].map((v) => v.map((value) => value / Math.hypot(...v)));
    return Math.acos(Math.min(1, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])) < radius;
  };
  /** Selects objects by their places in the list, from the top: the newest first. */
  const choose = async (...places) => {
    await page.keyboard.press('v');
    for (const [i, place] of places.entries()) {
      const entry = page.locator('#objects .object').nth(place);
      await entry.click(i > 0 ? { modifiers: ['Shift'] } : {});
    }
    await tab.settled();
  };
  const filled = async () => (await tab.view()).fill.region.area;

  const left = await drawCircle(-50, -20, 80);
  const right = await drawCircle(50, -20, 80);
  await choose(0, 1);
  await make('Union');
  const hole = await drawCircle(0, -20, 30);
  await choose(1, 0);
  await make('Difference');
  const frame = await drawCircle(0, 30, 110);
  await choose(1, 0);
  await make('Intersection');
  await page.locator('#fill').fill('60');
  await page.keyboard.press('Enter');
  await tab.settled();
  const isBadge = (point) =>
    (isIn(point, left) || isIn(point, right)) && !isIn(point, hole) && isIn(point, frame);
  near(await filled(), areaWhere(isBadge), 0.02, 'the badge');
  assert.equal((await tab.state()).drawing.objects.length, 7);

  const { text } = await tab.save('SVG');
  assert.ok(/<path fill="[^"]+" fill-opacity="0.6" d="M/.test(text), 'painted in the picture');

  await make('Offset');
  await page.keyboard.type('0.05');
  await page.keyboard.press('Enter');
  await tab.settled();
  assert.equal((await tab.view()).isolines.lines.length, 2, 'a rim outside, and one in the hole');
  await make('Cut');
  const { parts } = (await tab.view()).cut;
  assert.equal(parts.length, 3, 'the rest, the badge and what its hole leaves');
  await page.getByRole('button', { name: 'Delete Part 1', exact: true }).click();
  await tab.settled();
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save Part 2', exact: true }).click();
  const bytes = readFileSync(await (await coming).path());
  assert.equal(bytes.readUInt32LE(80), parts[1].triangles.length / 3);
  // The badge and a band of width 0.05 around it.
  const wider = (circle, by) => ({ ...circle, radius: circle.radius + by });
  const isWider = (point) =>
    (isIn(point, wider(left, 0.05)) || isIn(point, wider(right, 0.05))) &&
    !isIn(point, wider(hole, -0.05)) &&
    isIn(point, wider(frame, 0.05));
  near(parts[1].area, areaWhere(isWider), 0.03, 'the part');
  if (process.env.KARCHER_PICTURE) await page.screenshot({ path: process.env.KARCHER_PICTURE });
  await tab.close();
});
