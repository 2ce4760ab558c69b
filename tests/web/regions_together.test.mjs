// Groups and mirror images of booleans, offsets and filled lines: results follow their operands, and
// undo restores the same bytes.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';
import { arraysOfShape, openPage } from './engine_in_node.mjs';
import { fitsFile } from './schema.mjs';

describe('regions moved together and mirrored', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });
  const drawingOf = async (tab) => (await tab.state()).drawing;
  // A step back also restores the selection before the step.
  const bytesOf = async (tab) => JSON.stringify((await drawingOf(tab)).objects);
  const near = (value, wanted, part, what) =>
    assert.ok(Math.abs(value - wanted) < part * wanted, `${what}: ${value}, not ${wanted}`);
  const maker = (tab, name) =>
    tab.page.locator('#makers').getByRole('button', { name, exact: true });
  /** The areas of the fills of all objects of a kind. */
  const areas = async (tab, kind) => {
    const [{ objects }, view] = [await drawingOf(tab), await tab.view()];
    const { active } = await drawingOf(tab);
    return objects
      .filter(({ figure }) => figure.kind === kind)
      .map(({ id }) =>
        id === active
          ? view.fill.region.area
          : view.others.find((other) => other.id === id).region.area,
      );
  };
  const inSteps = async (tab, count, key) => {
    for (let step = 0; step < count; step++) await tab.page.keyboard.press(key);
    await tab.settled();
  };

  /** Two circles on a sphere, their union with a fill, and a filled offset of that. */
  async function withUnion({ offset = true } = {}) {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=circle');
    const { page } = tab;
    const { x, y } = await tab.middle();
    await tab.drag({ x: x - 60, y: y - 20 }, { x: x, y: y - 20 });
    await page.keyboard.press('Enter');
    await page.keyboard.press('o');
    await tab.drag({ x: x + 20, y: y + 30 }, { x: x + 80, y: y + 30 });
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await page.locator('#fill').fill('40');
    await page.keyboard.press('Enter');
    await maker(tab, 'Union').click();
    await tab.settled();
    if (offset) {
      await maker(tab, 'Offset').click();
      await tab.settled();
      await page.locator('#fill').fill('40');
      await page.keyboard.press('Enter');
      await tab.settled();
    }
    await page.keyboard.press('Escape');
    await page.locator('#stage').focus();
    return tab;
  }

  /** Mirrors the selection in the line of two clicks, and waits for the step. */
  async function mirror(tab, places, copies) {
    const { page } = tab;
    const { x, y } = await tab.middle();
    const { revision } = await tab.state();
    if ((await tab.state()).tool !== 'mirror') await page.locator('#mirror').click();
    await page.locator('#mirror-copies').setChecked(copies);
    const [first, second] = places.map(([dx, dy]) => [x + dx, y + dy]);
    await page.mouse.click(...first);
    await page.getByText('second point').waitFor();
    await page.mouse.click(...second);
    await page.waitForFunction((before) => window.karcherPage.state().revision > before, revision);
    await tab.settled();
  }
  const mirrorLine = [
    [90, -120],
    [95, 120],
  ];

  test('a group of operands and results moves as one, in one step', async () => {
    const tab = await withUnion();
    const { page } = tab;
    const bare = await bytesOf(tab);
    const [union] = await areas(tab, 'union');
    const [offset] = await areas(tab, 'offset');
    await page.keyboard.press('Control+a');
    await page.locator('#group').click();
    await tab.settled();
    const grouped = await bytesOf(tab);
    assert.equal(new Set((await drawingOf(tab)).objects.map(({ group }) => group)).size, 1);
    await page.locator('#stage').focus();
    const { revision } = await tab.state();
    await page.keyboard.press('Shift+ArrowRight');
    await page.waitForFunction((before) => {
      const state = window.karcherPage.state();
      return state.revision > before && !state.dragging;
    }, revision);
    await tab.settled();
    const moved = await bytesOf(tab);
    assert.notEqual(moved, grouped);
    near((await areas(tab, 'union'))[0], union, 0.01, 'the union');
    near((await areas(tab, 'offset'))[0], offset, 0.01, 'its offset');
    await inSteps(tab, 1, 'Control+z');
    assert.equal(await bytesOf(tab), grouped);
    await inSteps(tab, 1, 'Control+Shift+z');
    assert.equal(await bytesOf(tab), moved);
    await inSteps(tab, 2, 'Control+z');
    assert.equal(await bytesOf(tab), bare);
    await tab.close();
  });

  test('a mirrored copy of results has operands of its own; a reload and a link have the same areas', async () => {
    const tab = await withUnion();
    const { page } = tab;
    const bare = await bytesOf(tab);
    const [union] = await areas(tab, 'union');
    const [offset] = await areas(tab, 'offset');
    await page.keyboard.press('Control+a');
    await mirror(tab, mirrorLine, true);
    const { objects } = await drawingOf(tab);
    const mirrored = JSON.stringify(objects);
    assert.equal(JSON.stringify(objects.slice(0, 4)), bare);
    const ids = objects.map(({ id }) => id);
    assert.equal(new Set(ids).size, 8);
    const sources = objects.map(({ figure }) => figure.derived?.sources ?? []);
    assert.deepEqual(sources.slice(4), [[], [], [ids[4], ids[5]], [ids[6]]]);
    const check = async (one) => {
      const [unions, offsets] = [await areas(one, 'union'), await areas(one, 'offset')];
      assert.equal(unions.length, 2);
      for (const area of unions) near(area, union, 0.01, 'a union');
      for (const area of offsets) near(area, offset, 0.01, 'an offset');
    };
    await check(tab);
    const saved = await tab.save(/^JSON the whole/);
    assert.ok(fitsFile(JSON.parse(saved.text)), JSON.stringify(fitsFile.errors));
    await tab.pastSaving();
    const link = page.url().split('#')[1];
    await page.reload();
    await tab.settled();
    assert.equal(await bytesOf(tab), mirrored);
    await check(tab);
    const other = await Tab.open(browser, link);
    await check(other);
    await other.close();
    await page.locator('#stage').focus();
    await inSteps(tab, 1, 'Control+z');
    assert.equal(await bytesOf(tab), bare);
    await inSteps(tab, 1, 'Control+Shift+z');
    assert.equal(await bytesOf(tab), mirrored);
    await tab.close();
  });

  /** Selects the line of an offset, and measures how far the offset is to the right of it, in pixels. */
  async function offsetSeen(tab) {
    await tab.page.locator('#objects .object').last().click();
    const { polyline, others } = await tab.view();
    const lines = [polyline, Object.values(others[0].lines[0])];
    const middles = lines.map((line) => line.slice(3 * Math.floor(line.length / 6)).slice(0, 3));
    const [own, offset] = await tab.page.evaluate(
      (places) => places.map((place) => window.karcherPage.seen(place).x),
      middles,
    );
    return offset - own;
  }

  test('an offset of an open line is mirrored with it to its other side, and back', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=polyline');
    const { page } = tab;
    await tab.click([-60, 80], [-60, -80]);
    await maker(tab, 'Offset').click();
    await tab.settled();
    const whole = await bytesOf(tab);
    await page.keyboard.press('v');
    const right = await offsetSeen(tab);
    assert.ok(right > 5, `the offset is ${right} pixels to the right`);
    const sideOf = async () => (await drawingOf(tab)).objects[1].figure.derived.offset.side;
    const middle = [
      [0, -120],
      [0, 120],
    ];
    assert.equal(await sideOf(), 'outwards');
    await page.keyboard.press('Control+a');
    await mirror(tab, middle, false);
    assert.equal(await sideOf(), 'inwards');
    await page.keyboard.press('v');
    const left = await offsetSeen(tab);
    assert.ok(Math.abs(left + right) < 2, `${right}, and now ${left}`);
    await page.keyboard.press('Control+a');
    await mirror(tab, middle, true);
    const { objects } = await drawingOf(tab);
    assert.equal(objects.length, 4);
    assert.equal(objects[3].figure.derived.offset.side, 'outwards');
    await inSteps(tab, 2, 'Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('a filled line whose outer side is chosen keeps it in a group and in mirror images', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:3000&kind=polyline');
    const { page } = tab;
    await tab.click([-90, -60], [10, -70], [0, 60], [-80, 40]);
    await page.locator('#closed').check();
    await page.locator('#fill').fill('40');
    await page.keyboard.press('Enter');
    // The other side is that of a filling that is shown.
    await tab.settled();
    await page.locator('#other-side').click();
    await page.locator('#fill').blur();
    await tab.settled();
    const area = async () => {
      const { others, fill } = await tab.view();
      return [fill?.region, ...others.map(({ region }) => region)].flatMap((region) =>
        region ? [region.area] : [],
      );
    };
    const [outer] = await area();
    assert.ok(outer > 6, `more than half of the sphere: ${outer}`);
    const whole = await bytesOf(tab);
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await mirror(tab, mirrorLine, true);
    const both = await area();
    assert.equal(both.length, 2);
    for (const one of both) near(one, outer, 0.01, 'the area');
    await page.keyboard.press('v');
    await page.keyboard.press('Control+a');
    await page.locator('#group').click();
    await mirror(tab, mirrorLine, false);
    const again = await area();
    assert.equal(again.length, 2);
    for (const one of again) near(one, outer, 0.01, 'the area');
    await inSteps(tab, 3, 'Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });
});

describe('the mirror image of an offset of loops around a tube', () => {
  let page;
  let arrays;
  before(async () => {
    arrays = await arraysOfShape('torus', 5000);
    page = await openPage(arrays);
  });

  /** The torus's vertex nearest to the place with an angle about the axis and one around the tube. */
  function vertexAt(about, around) {
    const { positions, triangles } = arrays;
    const out = 1 + 0.4 * Math.cos(around);
    const place = [out * Math.cos(about), out * Math.sin(about), 0.4 * Math.sin(around)];
    const far = (corner) =>
      Math.hypot(...place.map((value, axis) => value - positions[3 * triangles[corner] + axis]));
    let best = 0;
    for (let corner = 1; corner < triangles.length; corner++) {
      if (far(corner) < far(best)) best = corner;
    }
    const bary = [0, 1, 2].map((i) => (i === best % 3 ? 1 : 0));
    return { face: Math.floor(best / 3), bary };
  }
  const loopAt = (about) => ({
    ...page.emptyDrawing.objects[0].figure,
    kind: 'polyline',
    points: [0, 1, 2, 3].map((i) => vertexAt(about, (i * Math.PI) / 2)),
    settings: { ...page.emptyDrawing.objects[0].figure.settings, closed: true },
  });
  const drawn = (id, figure, more = {}) => ({
    ...page.emptyDrawing.objects[0],
    ...{ id, name: `${id}`, figure, ...more },
  });
  const offset = (of, distance) => ({
    ...page.emptyDrawing.objects[0].figure,
    kind: 'offset',
    derived: { sources: [of], offset: { distance, side: 'outwards' } },
  });
  const drawingOf = (...objects) => ({ ...page.emptyDrawing, objects, active: objects[0].id });
  let opened = 0;
  /** The angle about the axis of the middle of an object's lines. */
  async function angleOf(drawing, id) {
    // Surfaces keep their drawings, by their keys.
    page.editor.open(`arrays ${opened++}`, drawing);
    await page.settled();
    const [{ paths }] = await page.session.linesOf([id]);
    const sum = [0, 0];
    for (const path of paths) {
      path.polyline().forEach((value, i) => {
        if (i % 3 < 2) sum[i % 3] += value;
      });
    }
    return Math.atan2(sum[1], sum[0]);
  }

  test('lies on the other side of the mirrored loop, also if it is an offset of an offset', async () => {
    const drawing = drawingOf(
      drawn(1, loopAt(0.5)),
      drawn(2, offset(1, 0.3)),
      drawn(3, offset(2, 0.2)),
    );
    const before = [await angleOf(drawing, 2), await angleOf(drawing, 3)];
    const images = await Promise.all(
      drawing.objects.slice(1).map((one) => page.mirroredDerived(page.session, drawing, one)),
    );
    const mirrored = drawingOf(
      drawn(1, loopAt(-0.5)),
      ...images.map((figure, i) => drawn(2 + i, figure)),
    );
    for (const [i, angle] of before.entries()) {
      // The loop, at 0.5, is 0.2 or more away from its offsets.
      assert.ok(Math.abs(angle - 0.5) > 0.15, `${angle}`);
      const image = await angleOf(mirrored, 2 + i);
      assert.ok(Math.abs(image + angle) < 0.03, `object ${2 + i}: ${image}, not ${-angle}`);
    }
  });

  test('stays on its side if the line is locked, so that it stays too', async () => {
    const line = loopAt(0.5);
    const open = { ...line, settings: { ...line.settings, closed: false } };
    const drawing = drawingOf(drawn(1, open, { locked: true }), drawn(2, offset(1, 0.3)));
    const [, own] = drawing.objects;
    assert.equal(await page.mirroredDerived(page.session, drawing, own), own.figure);
  });
});
