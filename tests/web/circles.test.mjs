// Circles and their constructions.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from '../../dist/index.js';
import { browserOfSuite, Tab } from './browser.mjs';
import { flatGrid, linesOf, typeRadius } from './circle_views.mjs';
import { farthestFromSurface, nearestOnSurface } from './on_surface.mjs';
import { inLongRun } from './part.mjs';
import { far, vertices } from './polylines.mjs';

const onSurface = 2e-6;

const choose = async (tab, type) => {
  await tab.page.getByLabel('Type').selectOption(type);
  return tab.view();
};

/**
 * Distances on the surface from a point to some vertices of lines, by an engine in this process.
 */
async function distancesAlong(lines, center, surface, every) {
  const karcher = await load();
  const mesh = karcher.meshFromArrays(surface.positions, surface.triangles);
  try {
    return lines.flatMap((line) =>
      vertices(line)
        .filter((_, i) => i % every === 0)
        .map((place) => mesh.shortestPath(center, nearestOnSurface(place, surface)).length),
    );
  } finally {
    mesh.dispose();
  }
}

describe('circles', () => {
  const browser = browserOfSuite();

  test('on a plane are circles, of each type', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.page.keyboard.press('7');
    await tab.click([3, 5]);
    const { circle: handles, curve } = await typeRadius(tab, '4.5');
    assert.ok(curve && Math.abs(handles.radius - 4.5) < 1e-12);
    const center = Object.values(handles.path).slice(0, 3);
    const deviations = {};
    for (const type of ['arcs', 'linear', 'exact']) {
      const view = await choose(tab, type);
      const lines = linesOf(view);
      assert.equal(lines.length, 1, type);
      const off = vertices(lines[0]).map((place) => Math.abs(far(place, center) - 4.5));
      deviations[type] = Math.max(...off);
    }
    // The lines are in single precision, and chords of arcs lie within a thousandth of an edge.
    assert.ok(deviations.exact < 1e-5, `${deviations.exact}`);
    assert.ok(deviations.arcs < 2e-3, `${deviations.arcs}`);
    assert.ok(deviations.linear < 0.1 && deviations.linear > 1e-3, `${deviations.linear}`);
    await tab.close();
  });

  inLongRun('are isolines with all their loops, on the surface and at the radius', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:2000&kind=circle');
    // The radius exceeds half the tube's circumference, so that the line has two loops.
    await tab.click([0, 120]);
    const surface = await tab.mesh();
    const { diagonal } = surface.info;
    await choose(tab, 'exact');
    const view = await typeRadius(tab, '1.6');
    const lines = linesOf(view);
    assert.equal(lines.length, 2);
    assert.ok(view.isolines.lines.every(({ closed }) => closed));
    assert.equal(await tab.page.locator('#status-samples').textContent(), '2 loops');
    assert.equal(view.quality, 'exact');
    for (const line of lines) {
      assert.ok(farthestFromSurface(line, surface) <= onSurface * diagonal);
      assert.ok(far(line.slice(0, 3), line.slice(-3)) <= onSurface * diagonal);
    }
    const { center } = (await tab.state()).figure.circle;
    for (const distance of await distancesAlong(lines, center, surface, 25)) {
      assert.ok(Math.abs(distance - 1.6) <= 1e-5 * diagonal, `${distance}`);
    }
    const linear = await choose(tab, 'linear');
    assert.equal(linear.isolines.lines.length, 2);
    for (const line of linesOf(linear)) {
      assert.ok(farthestFromSurface(line, surface) <= onSurface * diagonal);
    }
    const { meanEdge } = surface.info;
    for (const distance of await distancesAlong(linesOf(linear), center, surface, 9)) {
      // The engine interpolates distances in triangles.
      assert.ok(Math.abs(distance - 1.6) <= 0.25 * meanEdge, `${distance}`);
    }
    await tab.close();
  });

  test('of each type follow their handles, and a drag shows a draft', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=circle');
    await tab.click([0, 40]);
    const surface = await tab.mesh();
    for (const type of ['arcs', 'linear', 'exact']) {
      const first = await choose(tab, type);
      const from = await tab.handle('Radius of the circle');
      await tab.page.mouse.move(from.x, from.y);
      await tab.page.mouse.down();
      await tab.page.mouse.move(from.x + 12, from.y + 4, { steps: 3 });
      await tab.page.waitForFunction(() => {
        const { state, view } = window.karcherPage;
        return state().dragging && view().revision === state().revision;
      });
      const held = await tab.page.evaluate(() => window.karcherPage.view());
      assert.equal(held.quality, 'draft', type);
      assert.ok(held.circle.radius > first.circle.radius);
      await tab.page.mouse.up();
      const after = await tab.view();
      assert.equal(after.quality, 'exact', type);
      assert.notDeepEqual(linesOf(after), linesOf(first));
      assert.ok(
        farthestFromSurface(linesOf(after)[0], surface) <= onSurface * surface.info.diagonal,
      );
      await tab.page.keyboard.press('Control+z');
      assert.deepEqual(linesOf(await tab.view()), linesOf(first), `${type}: as one step`);
    }
    await tab.close();
  });

  inLongRun('have as many arcs as are asked for, live and as one step', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:5000&kind=circle');
    await tab.click([0, 0]);
    const { radius } = (await typeRadius(tab, '0.8')).circle;
    const before = await tab.view();
    const segments = ({ curve }) => new Set(Object.values(curve.samples.segment)).size;
    assert.ok(segments(before) > 7 && before.curve.deviation <= 1e-3);
    assert.equal(await tab.page.locator('#arcs-count').textContent(), 'auto');
    assert.match(
      await tab.page.locator('#circle-note').textContent(),
      /at most 0\.\d+ percent off/,
    );
    const slider = tab.page.getByRole('slider', { name: 'Arcs' });
    await slider.focus();
    await slider.fill('3');
    const few = await tab.view();
    assert.equal(segments(few), 3);
    await slider.fill('20');
    const many = await tab.view();
    assert.equal(segments(many), 20);
    assert.equal(await tab.page.locator('#arcs-count').textContent(), '20');
    const { center } = (await tab.state()).figure.circle;
    const surface = await tab.mesh();
    const spread = async (view) => {
      const ways = await distancesAlong(linesOf(view), center, surface, 17);
      return Math.max(...ways.map((way) => Math.abs(way - radius)));
    };
    assert.ok((await spread(many)) < (await spread(few)), 'more arcs are nearer to the radius');
    await tab.page.locator('#stage').focus();
    await tab.page.keyboard.press('Control+z');
    await tab.page.keyboard.press('Control+z');
    assert.deepEqual((await tab.view()).polyline, before.polyline);
    await tab.close();
  });

  inLongRun('take a radius that is typed, and nothing else', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle');
    const field = tab.page.getByRole('textbox', { name: 'Radius' });
    assert.equal(await field.isDisabled(), true, 'there is no circle yet');
    await tab.click([20, 10]);
    const first = await tab.view();
    const shown = await field.inputValue();
    assert.equal(Number(shown), Number(first.circle.radius.toPrecision(4)));
    for (const wrong of ['-1', '0', 'wide', '']) {
      const view = await typeRadius(tab, wrong);
      assert.deepEqual(view.polyline, first.polyline, wrong);
      assert.equal(await field.inputValue(), shown);
    }
    await field.fill('0.7');
    await tab.page.keyboard.press('Escape');
    assert.equal(await field.inputValue(), shown);
    // A digit outside fields chooses a kind of curve.
    await field.press('Control+a');
    await tab.page.keyboard.type('0,35');
    await field.press('Enter');
    const wider = await tab.view();
    assert.equal((await tab.state()).figure.kind, 'circle');
    assert.equal(wider.circle.radius, 0.35);
    assert.deepEqual(wider.circle.direction, first.circle.direction);
    await field.press('Control+z');
    assert.deepEqual((await tab.view()).polyline, first.polyline);

    for (const type of ['linear', 'exact', 'arcs']) {
      await choose(tab, type);
      const { problem, curve, isolines } = await typeRadius(tab, '9');
      assert.ok(problem && !curve && !isolines, type);
      assert.match(await tab.page.locator('#hint').textContent(), /^[A-Z].*\.$/);
      await tab.page.getByRole('button', { name: 'Undo' }).click();
      assert.equal((await tab.view()).problem, null);
    }
    await tab.close();
  });

  inLongRun('are saved with all their loops, and opened again', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:2000&kind=circle');
    await tab.click([0, 120]);
    await choose(tab, 'exact');
    const view = await typeRadius(tab, '1.6');
    const lines = linesOf(view);
    const obj = (await tab.save('OBJ')).text.trimEnd().split('\n');
    const elements = obj.filter((line) => line.startsWith('l '));
    assert.deepEqual(
      elements.map((line) => line.split(' ').length - 1),
      lines.map((line) => line.length / 3),
    );
    const places = obj.filter((line) => line.startsWith('v ')).map((line) => line.split(' '));
    assert.deepEqual(
      places.flatMap(([, ...place]) => place.map((value) => Math.fround(value))),
      lines.flat(),
    );
    const svg = (await tab.save('SVG')).text;
    const lasting = svg.match(/<path [^>]*stroke-width="4"/g);
    assert.ok(lasting.length >= 2 && !svg.includes('NaN'));

    const { figure: document } = await tab.state();
    const { name, text } = await tab.save('JSON');
    const content = JSON.parse(text);
    assert.deepEqual([content.kind, content.type, content.radius], ['circle', 'exact', 1.6]);
    assert.deepEqual(content.circle, document.circle);
    assert.equal(content.lines.length, 2);
    assert.deepEqual(
      content.lines.map(({ polyline }) => polyline.map(Math.fround)),
      lines,
    );
    await tab.page.getByRole('button', { name: 'Clear' }).click();
    await tab.drop(name, text);
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.circle !== null);
    assert.deepEqual((await tab.state()).figure, document);
    assert.deepEqual(linesOf(await tab.view()), lines);
    await tab.close();
  });

  inLongRun('come back with the link, and go back', async () => {
    const tab = await Tab.open(browser, 'mesh=bunny:0&kind=circle');
    await tab.click([0, 40]);
    await tab.page.getByRole('slider', { name: 'Arcs' }).fill('5');
    await choose(tab, 'exact');
    const view = await tab.view();
    await tab.page.waitForFunction(() => location.hash.includes('circletype=exact&arcs=5'));
    await tab.page.reload();
    const again = await tab.view();
    assert.deepEqual(linesOf(again), linesOf(view));
    assert.deepEqual((await tab.state()).figure.circleForm, { type: 'exact', arcs: 5 });
    const address = await tab.page.evaluate(() => location.href);
    await tab.page.evaluate(() => {
      location.hash = 'mesh=bunny:0&kind=bspline&points=';
    });
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.kind === 'bspline');
    await tab.page.evaluate((href) => {
      location.href = href;
    }, address);
    await tab.page.waitForFunction(() => window.karcherPage.state().figure.kind === 'circle');
    assert.deepEqual(linesOf(await tab.view()), linesOf(view));
    await tab.close();
  });

  test('keep their rim if a click would begin one more object than a drawing may have', async () => {
    const tab = await Tab.open(browser, 'mesh=sphere:1500&kind=circle');
    await tab.click([-60, 0], [-20, 0]);
    const [circle] = (await tab.state()).drawing.objects;
    const { center } = circle.figure.circle;
    const point = { ...circle.figure, kind: 'polyline', circle: null, points: [center] };
    const others = Array.from({ length: 1999 }, (_, i) => ({
      ...{ ...circle, id: i + 1, visible: false },
      figure: point,
    }));
    const objects = [...others, { ...circle, id: 2000 }];
    const drawing = { format: 'karcher-drawing', version: 1, active: 2000, objects };
    const link = 'mesh=sphere:1500&kind=circle&method=karcher';
    const text = JSON.stringify({ format: 'karcher-curve', version: 2, link, drawing });
    await tab.drop('full.json', text);
    await tab.page.waitForFunction(
      () => window.karcherPage.state().drawing.objects.length === 2000,
    );
    await tab.settled();
    await tab.page.keyboard.press('Escape');
    await tab.page.keyboard.press('Escape');
    await tab.page.locator('#tool-circle').click();
    await tab.settled();
    const { x, y } = await tab.middle();
    await tab.page.mouse.click(x + 60, y + 40);
    await tab.page.getByText('A drawing may have up to 2000 objects.').first().waitFor();
    await tab.settled();
    const after = (await tab.state()).drawing.objects;
    assert.equal(after.length, 2000);
    assert.deepEqual(after.at(-1).figure.circle, circle.figure.circle);
    await tab.close();
  });
});
