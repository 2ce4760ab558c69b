// Sessions of people who make parts of a surface: a technician's trim line, and a badge. They take
// each step with the mouse and the keys. Places are parts of the stage, whatever its size. A
// session calls `tell` after each step with the step's name.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { clickAt, control, dragAt, placeOn } from './sittings.mjs';

/**
 * An open limb of 40 mm, slightly thicker at one end and uneven everywhere, as a file in
 * millimeters.
 */
function limb(around = 72, along = 60) {
  const place = (i, j) => {
    const [angle, height] = [(2 * Math.PI * i) / around, (j / along - 0.5) * 240];
    const uneven = 0.8 * Math.sin(3 * angle + height / 25) * Math.cos(height / 40);
    const radius = 40 + 8 * (height / 240) + uneven;
    return [radius * Math.sin(angle), height, radius * Math.cos(angle)];
  };
  const lines = [];
  const facet = (...corners) =>
    lines.push(
      'facet normal 0 0 0',
      'outer loop',
      ...corners.map((c) => `vertex ${c.join(' ')}`),
      'endloop',
      'endfacet',
    );
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < around; i++) {
      const next = (i + 1) % around;
      const [a, b, c, d] = [place(i, j), place(next, j), place(next, j + 1), place(i, j + 1)];
      facet(a, b, c);
      facet(a, c, d);
    }
  }
  return ['solid limb', ...lines, 'endsolid'].join('\n');
}

/**
 * A closed line around a scan of a limb, a cut 2 mm beside the line, and a shell for printing. Returns the number of
 * clicks and drags besides the line itself.
 */
export async function trimSitting(tab, tell = async () => {}) {
  const { page } = tab;
  let hands = 0;
  await page.locator('#tour-skip').click();
  const click = async (selector) => {
    hands++;
    await (await control(tab, selector)).click();
    await tab.settled();
  };
  const choosing = page.waitForEvent('filechooser');
  await click('#open');
  await (await choosing).setFiles({
    name: 'limb.stl',
    mimeType: 'model/stl',
    buffer: Buffer.from(limb()),
  });
  await page.waitForFunction(() => window.karcherPage.state().mesh.endsWith('limb.stl'));
  await tab.settled();
  await tab.still();
  await tell('limb');

  // The line has three places in front and three behind.
  await click('#tool-curve');
  const line = () => clickAt(tab, [-0.15, 0.05], [0, 0.05], [0.15, 0.05]);
  await line();
  hands++;
  // The view turns half around, until the hidden side is in the middle.
  const { x } = await placeOn(tab, [0, 0]);
  const from = await placeOn(tab, [-0.9, 0.5]);
  const { height } = await page.locator('#stage').boundingBox();
  await page.mouse.move(from.x, from.y);
  await page.mouse.down({ button: 'right' });
  const away = () =>
    page.evaluate((middle) => {
      const seen = window.karcherPage.seen([0, 10, -43]);
      return seen ? Math.abs(seen.x - middle) : Infinity;
    }, x);
  for (let part = 0; part < 1; part += 1 / 40) {
    await page.mouse.move(from.x + part * height, from.y);
    await tab.still();
    if ((await away()) < height / 30) break;
  }
  await page.mouse.up({ button: 'right' });
  assert.ok((await away()) < height / 30, 'the hidden side is in front');
  await line();
  hands++;
  await (await control(tab, '#closed')).check();
  await tab.settled();
  const { curve } = await tab.view();
  const round = 2 * Math.PI * 40;
  assert.ok(curve.length > round && curve.length < 1.25 * round, `${curve.length}`);
  assert.match(await page.locator('#status-length').textContent(), /^length .* mm/);
  await tell('line');

  await click('#makers button:text-is("Offset")');
  await page.keyboard.type('2');
  await page.keyboard.press('Enter');
  await tab.settled();
  assert.equal((await tab.view()).isolines.lines.length, 1);
  await tell('beside it');
  await click('#makers button:text-is("Cut")');
  const { parts } = (await tab.view()).cut;
  assert.equal(parts.length, 2);
  await click('[aria-label="Delete Part 1"]');
  await click('#thickness');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('3');
  await page.keyboard.press('Enter');
  await tab.settled();
  await tab.still();
  await tell('shell');
  const coming = page.waitForEvent('download');
  await click('#save-parts');
  const bytes = readFileSync(await (await coming).path());
  const { thick, area } = (await tab.view()).cut.parts[1];
  assert.ok(thick.closed);
  assert.equal(thick.most, null);
  assert.equal(bytes.readUInt32LE(80), thick.triangles.length / 3);
  // The volume is 3 mm times the area, and more where the surface is convex.
  assert.ok(thick.volume > 3 * area && thick.volume < 3.2 * area, `${thick.volume} ${area}`);
  return hands;
}

/** Points that cover the unit sphere evenly (a Fibonacci lattice). */
const lattice = Array.from({ length: 200_000 }, (_, i) => {
  const height = 1 - (2 * i + 1) / 200_000;
  const angle = i * Math.PI * (3 - Math.sqrt(5));
  const around = Math.sqrt(1 - height ** 2);
  return [around * Math.cos(angle), around * Math.sin(angle), height];
});
const areaWhere = (isInside) => (4 * Math.PI * lattice.filter(isInside).length) / lattice.length;

/**
 * Unites circles, cuts them out of each other and trims them, then fills the result, gives it a
 * rim, cuts it out of the surface and saves it. A count of points of the sphere checks the area.
 */
export async function badgeSitting(tab, tell = async () => {}) {
  const { page } = tab;
  await page.locator('#tour-skip').click();
  await (await control(tab, '#surface')).selectOption('sphere');
  await page.waitForFunction(() => window.karcherPage.state().mesh.startsWith('sphere:'));
  await tab.settled();
  await tab.still();
  const near = (value, wanted, part, what) =>
    assert.ok(Math.abs(value - wanted) < part * wanted, `${what}: ${value}, not ${wanted}`);
  const make = async (name) => {
    await (await control(tab, `#makers button:text-is("${name}")`)).click();
    await tab.settled();
  };
  const { positions, triangles } = await tab.mesh();
  const placeOf = ({ face, bary }) =>
    [0, 1, 2].map((k) =>
      bary.reduce((sum, part, i) => sum + part * positions[3 * triangles[3 * face + i] + k], 0),
    );
  const drawCircle = async ([h, v], reach) => {
    await page.locator('#tool-circle').click();
    await dragAt(tab, [h, v], [h + reach, v]);
    const { radius } = (await tab.view()).circle;
    const { center } = (await tab.state()).figure.circle;
    await page.keyboard.press('Enter');
    return { center: placeOf(center), radius };
  };
  const isIn = (point, { center, radius }) => {
    const [a, b] = [point, center].map((v) => v.map((value) => value / Math.hypot(...v)));
    return Math.acos(Math.min(1, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])) < radius;
  };
  /** Selects objects by their places in the list, from the topmost, which is the newest. */
  const choose = async (...places) => {
    await page.locator('#tool-select').click();
    for (const [i, place] of places.entries()) {
      const entry = page.locator('#objects .object').nth(place);
      await entry.scrollIntoViewIfNeeded();
      await entry.click(i > 0 ? { modifiers: ['Shift'] } : {});
    }
    await tab.settled();
  };
  const filled = async () => (await tab.view()).fill.region.area;

  const left = await drawCircle([-0.2, -0.08], 0.32);
  const right = await drawCircle([0.2, -0.08], 0.32);
  await choose(0, 1);
  await tell('circles');
  await make('Union');
  const hole = await drawCircle([0, -0.08], 0.12);
  await choose(1, 0);
  await make('Difference');
  const frame = await drawCircle([0, 0.1], 0.45);
  await choose(1, 0);
  await make('Intersection');
  await (await control(tab, '#fill')).fill('60');
  await page.keyboard.press('Enter');
  await tab.settled();
  await tell('badge');
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
  await (await control(tab, '[aria-label="Delete Part 1"]')).click();
  await tab.settled();
  await tab.still();
  await tell('cut out');
  const coming = page.waitForEvent('download');
  await (await control(tab, '[aria-label="Save Part 2"]')).click();
  const bytes = readFileSync(await (await coming).path());
  assert.equal(bytes.readUInt32LE(80), parts[1].triangles.length / 3);
  // The badge and a band of width 0.05 around it.
  const wider = (circle, by) => ({ ...circle, radius: circle.radius + by });
  const isWider = (point) =>
    (isIn(point, wider(left, 0.05)) || isIn(point, wider(right, 0.05))) &&
    !isIn(point, wider(hole, -0.05)) &&
    isIn(point, wider(frame, 0.05));
  near(parts[1].area, areaWhere(isWider), 0.03, 'the part');
}
