// Objects turned, scaled and mirrored: by the engine alone, and on the page with a mouse and
// numbers.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { Vector3 } from 'three';
import { browserOfSuite, Tab, touchOf } from './browser.mjs';
import { flatGrid } from './circle_views.mjs';
import { openPage } from './engine_in_node.mjs';
import { inLongRun } from './part.mjs';

/** The places of surface points. */
const placesOf = (points, { positions, triangles }) =>
  points.map(({ face, bary }) =>
    [0, 1, 2].map((axis) =>
      bary.reduce(
        (sum, weight, i) => sum + weight * positions[3 * triangles[3 * face + i] + axis],
        0,
      ),
    ),
  );
const minus = (a, b) => a.map((value, axis) => value - b[axis]);
const far = (a, b) => Math.hypot(...minus(a, b));
/** Distances between all pairs of places. */
const pairs = (places) => places.flatMap((a, i) => places.slice(i + 1).map((b) => far(a, b)));
const angleOf = ([x, y]) => Math.atan2(y, x);

/** A flat square of 16 by 16 unit squares. */
function flatArrays(cells) {
  const positions = [];
  const triangles = [];
  for (let j = 0; j <= cells; j++) for (let i = 0; i <= cells; i++) positions.push(i, j, 0);
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      const a = i + (cells + 1) * j;
      const c = a + cells + 1;
      triangles.push(a, a + 1, c + 1, a, c + 1, c);
    }
  }
  return { positions: Float64Array.from(positions), triangles: Int32Array.from(triangles) };
}

/** The parts of the viewer's surface that a move needs, for a plane seen from above. */
const flatSurface = {
  frame: { scale: 1 },
  position: (point, target) => target.fromArray(placesOf([point], flatArrays(16))[0]),
  normal: () => new Vector3(0, 0, 1),
  directionFromScene: (direction) => direction.toArray?.() ?? direction,
};

const at = (i, j, u = 0.2, v = 0.3) => ({ face: 2 * (i + 16 * j), bary: [1 - u - v, u, v] });

describe('objects that are placed anew', () => {
  let page;
  const arrays = flatArrays(16);
  before(async () => {
    page = await openPage(arrays);
  });

  const objectOf = (figure, id = 1) => ({ ...page.emptyDrawing.objects[0], id, figure });
  const place = (point) => placesOf([point], arrays)[0];
  const figureOf = ({ command }) => command.steps[0].edit.to;

  const pen = () => ({
    ...page.emptyDrawing.objects[0].figure,
    kind: 'pen',
    points: [
      {
        ...at(4, 5),
        tangents: { after: { direction: [0.6, 0.8, 0], length: 1.5 }, before: { length: null } },
      },
      { ...at(7, 6), tangents: { before: { length: 0.5 }, after: at(8, 7) } },
      at(6, 9),
    ],
  });
  const circle = (across) => ({
    ...page.emptyDrawing.objects[0].figure,
    kind: 'ellipse',
    circle: { center: at(6, 6), rim: { radius: 1, direction: [0, 1, 0] }, across },
  });

  const moveOf = (objects, pivot) =>
    page.Move.of(page.session, flatSurface, { drawing: page.emptyDrawing, objects }, pivot);

  test('turn and grow about the pivot, with handles, radii and axes', async () => {
    const objects = [objectOf(pen()), objectOf(circle({ radius: 0.5 }), 2)];
    const pivot = at(5, 7, 0.5, 0.1);
    const move = await moveOf(objects, pivot);
    const [angle, scale] = [0.7, 1.4];
    const { command } = await move.placed({ angle, scale });
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const turned = ([x, y, z]) => [c * x - s * y, s * x + c * y, z];
    const wanted = (point) => {
      const from = place(pivot);
      return turned(minus(place(point), from)).map((value, axis) => from[axis] + scale * value);
    };
    const [line, round] = command.steps.map(({ edit }) => edit.to);
    for (const [i, point] of objects[0].figure.points.entries()) {
      assert.ok(far(place(line.points[i]), wanted(point)) < 1e-12);
    }
    const { after: lead, before: other } = line.points[0].tangents;
    assert.ok(far(lead.direction, turned([0.6, 0.8, 0])) < 1e-12);
    assert.ok(Math.abs(lead.length - 1.5 * scale) < 1e-12);
    assert.deepEqual(other, { length: null });
    assert.ok(far(place(line.points[1].tangents.after), wanted(at(8, 7))) < 1e-12);
    assert.ok(Math.abs(line.points[1].tangents.before.length - 0.5 * scale) < 1e-12);
    assert.ok(Math.abs(round.circle.rim.radius - scale) < 1e-12);
    assert.ok(far(round.circle.rim.direction, turned([0, 1, 0])) < 1e-12);
    assert.ok(Math.abs(round.circle.across.radius - 0.5 * scale) < 1e-12);
  });

  test('return to their place after two opposite placements, up to rounding', async () => {
    const pivot = at(5, 7, 0.5, 0.1);
    const there = at(8, 4, 0.3, 0.3);
    const figure = pen();
    const first = await moveOf([objectOf(figure)], pivot);
    const moved = figureOf(await first.placed({ point: there, angle: 1, scale: 0.5 }));
    const second = await moveOf([objectOf(moved)], there);
    const back = figureOf(await second.placed({ point: pivot, angle: -1, scale: 2 }));
    for (const [i, point] of figure.points.entries()) {
      assert.ok(far(place(back.points[i]), place(point)) < 1e-9);
    }
    assert.ok(far(back.points[0].tangents.after.direction, [0.6, 0.8, 0]) < 1e-9);
    const same = await first.placed({ point: pivot, angle: 0, scale: 1 });
    assert.deepEqual(same.command, { type: 'steps', steps: [] });
  });

  test('stop before one would leave the surface', async () => {
    const move = await moveOf([objectOf(pen())], at(5, 7));
    assert.match(await move.placed({ scale: 5 }), /leave the surface/);
    assert.match(await move.to(at(15, 15)), /leave the surface/);
  });

  test('mirrored in a line are its reflections, and turn the other way', async () => {
    const { client } = page.session;
    const line = await page.mirrorLine(client, { face: 16, bary: [1, 0, 0] }, at(8, 9, 0, 0));
    const figure = circle({ radius: 0.5 });
    figure.circle.rim.direction = [0.6, 0.8, 0];
    const [mirrored] = await page.mirroredFigures(client, line, [objectOf(figure)]);
    const [x, y] = place(figure.circle.center);
    assert.ok(far(place(mirrored.circle.center), [16 - x, y, 0]) < 1e-9);
    assert.ok(far(mirrored.circle.rim.direction, [-0.6, 0.8, 0]) < 1e-9);
    assert.equal(mirrored.circle.rim.radius, 1);
    const [again] = await page.mirroredFigures(client, line, [objectOf(mirrored)]);
    assert.ok(far(place(again.circle.center), [x, y, 0]) < 1e-9);
    const near = await page.mirrorLine(client, at(2, 2, 0, 0), at(2, 9, 0, 0));
    assert.equal(await page.mirroredFigures(client, near, [objectOf(figure)]), null);
  });
});

describe('the frame around the selection', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  const bytesOf = async (tab) => JSON.stringify((await tab.state()).drawing);
  const dragging = (tab, is) =>
    tab.page.waitForFunction((want) => window.karcherPage.state().dragging === want, is);
  const frameShown = (tab) =>
    tab.page.getByRole('button', { name: 'Turn the selection' }).waitFor();

  /** A curve on a plane, with the frame around it. */
  async function open() {
    const tab = await Tab.open(browser);
    await tab.drop('flat.obj', flatGrid(16));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.click([-60, 20], [-20, -20], [20, 30], [50, -10]);
    await tab.page.locator('#tool-transform').click();
    await frameShown(tab);
    await tab.still();
    return tab;
  }
  const places = async (tab) => placesOf((await tab.state()).figure.points, await tab.mesh());

  /** Drags a handle of the frame, through other places. */
  async function dragTo(tab, name, ...offsets) {
    const from = await tab.handle(name);
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    for (const [dx, dy] of offsets) {
      await tab.page.mouse.move(from.x + dx, from.y + dy, { steps: 3 });
    }
    await dragging(tab, true);
    await tab.page.mouse.up();
    await dragging(tab, false);
    await tab.settled();
  }

  test('turns, scales and moves as a step each, and undo restores every byte', async () => {
    const tab = await open();
    const { keyboard } = tab.page;
    const before = await places(tab);
    const whole = await bytesOf(tab);
    const sides = pairs(before);
    await keyboard.down('Shift');
    await dragTo(tab, 'Turn the selection', [60, 30]);
    await keyboard.up('Shift');
    const turned = await places(tab);
    for (const [i, side] of pairs(turned).entries()) assert.ok(Math.abs(side - sides[i]) < 1e-9);
    const angle = angleOf(minus(turned[1], turned[0])) - angleOf(minus(before[1], before[0]));
    const steps = angle / (Math.PI / 12);
    assert.ok(Math.abs(steps - Math.round(steps)) < 1e-9 && Math.round(steps) !== 0, `${steps}`);

    await dragTo(tab, 'Scale the selection, second', [-10, -5]);
    const scaled = pairs(await places(tab));
    const scale = scaled[0] / sides[0];
    assert.ok(Math.abs(scale - 1) > 0.01);
    for (const [i, side] of scaled.entries()) assert.ok(Math.abs(side - scale * sides[i]) < 1e-9);

    const held = await places(tab);
    await dragTo(tab, 'Move the selection', [15, 12]);
    const step = minus((await places(tab))[0], held[0]);
    assert.ok(Math.hypot(...step) > 0.1);
    for (const [i, place] of (await places(tab)).entries()) {
      assert.ok(far(minus(place, held[i]), step) < 1e-9);
    }
    for (let i = 0; i < 3; i++) await keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('has no step for a drag there and back; the pivot moves alone', async () => {
    const tab = await open();
    const whole = await bytesOf(tab);
    for (const name of ['Turn the selection', 'Scale the selection, first', 'Move the selection']) {
      await dragTo(tab, name, [25, -14], [0, 0]);
      assert.equal(await bytesOf(tab), whole, name);
    }
    const from = await tab.handle('Pivot of turning');
    await tab.page.mouse.move(from.x, from.y);
    await tab.page.mouse.down();
    await tab.page.mouse.move(from.x - 40, from.y + 10, { steps: 3 });
    await tab.page.mouse.up();
    await tab.page.waitForFunction((x) => {
      const box = document.querySelector('[data-look="pivot"]').getBoundingClientRect();
      return Math.abs(box.left + box.width / 2 - x) < 2;
    }, from.x - 40);
    assert.equal(await bytesOf(tab), whole);
    // On another surface, the pivot of the same object is in the middle again.
    await tab.drop('coarse.obj', flatGrid(4));
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 32);
    await tab.page.keyboard.press('b');
    await tab.click([-60, 20], [-20, -20], [20, 30], [50, -10]);
    await tab.page.locator('#tool-transform').click();
    await frameShown(tab);
    await tab.still();
    const [pivot, ...corners] = await Promise.all(
      ['Pivot of', ...['first', 'second', 'third', 'fourth'].map((one) => `selection, ${one}`)].map(
        (name) => tab.handle(name),
      ),
    );
    for (const axis of ['x', 'y']) {
      const middle = corners.reduce((sum, corner) => sum + corner[axis] / 4, 0);
      assert.ok(Math.abs(pivot[axis] - middle) < 2, `${pivot[axis]}, not ${middle}`);
    }
    await tab.close();
  });

  test('takes numbers and keys', async () => {
    const tab = await open();
    const { page } = tab;
    const before = await places(tab);
    const sides = pairs(before);
    const whole = await bytesOf(tab);
    const type = async (id, text) => {
      const { revision } = await tab.state();
      await page.locator(id).fill(text);
      await page.locator(id).press('Enter');
      await page.waitForFunction((last) => {
        const state = window.karcherPage.state();
        return state.revision > last && !state.dragging;
      }, revision);
      await tab.settled();
    };
    await type('#turn', '90');
    const turned = await places(tab);
    const angle = angleOf(minus(turned[1], turned[0])) - angleOf(minus(before[1], before[0]));
    assert.ok(Math.abs(Math.cos(angle)) < 1e-9);
    await type('#scale', '50');
    for (const [i, side] of pairs(await places(tab)).entries()) {
      assert.ok(Math.abs(side - sides[i] / 2) < 1e-9);
    }
    const held = await places(tab);
    await type('#move-x', '0.5');
    for (const [i, place] of (await places(tab)).entries()) {
      assert.ok(Math.abs(far(place, held[i]) - 0.5) < 1e-9);
    }
    const handle = page.getByRole('button', { name: 'Turn the selection' });
    await handle.focus();
    const last = await places(tab);
    const { revision } = await tab.state();
    await page.keyboard.press('Shift+ArrowLeft');
    await page.waitForFunction((from) => {
      const state = window.karcherPage.state();
      return state.revision > from && !state.dragging;
    }, revision);
    const keyed = await places(tab);
    const by = angleOf(minus(keyed[1], keyed[0])) - angleOf(minus(last[1], last[0]));
    assert.ok(Math.abs(Math.abs(by) - Math.PI / 12) < 1e-9, `${by}`);
    // The focus leaves before the key is released.
    const beforeKey = (await tab.state()).revision;
    await page.keyboard.down('ArrowLeft');
    await page.waitForFunction(() => window.karcherPage.state().dragging);
    await handle.evaluate((element) => element.blur());
    await page.waitForFunction((from) => {
      const state = window.karcherPage.state();
      return state.revision > from && !state.dragging;
    }, beforeKey);
    await page.keyboard.up('ArrowLeft');
    for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await page.keyboard.press('Escape');
    assert.equal((await tab.state()).tool, 'select');
    await tab.close();
  });

  /** Makes each answer of the engine late, so that an edit comes before the answer to another. */
  const slow = (tab) =>
    tab.engines()[0].evaluate(() => {
      const post = globalThis.postMessage;
      globalThis.postMessage = (...reply) => setTimeout(() => post.apply(globalThis, reply), 60);
    });
  test('takes numbers and drags that follow each other before the engine answers', async () => {
    const tab = await open();
    const { page } = tab;
    const before = await places(tab);
    const whole = await bytesOf(tab);
    const revision = async () => (await tab.state()).revision;
    /** Waits until this number of steps have been recorded since a revision, and shown. */
    const recorded = async (from, count) => {
      await page.waitForFunction(
        ([last, steps]) => {
          const state = window.karcherPage.state();
          return state.revision >= last + steps && !state.dragging;
        },
        [from, count],
      );
      await tab.pastSaving();
      await tab.settled();
    };
    await slow(tab);
    for (const [id, text] of [
      ['#move-x', '0.5'],
      ['#turn', '90'],
    ]) {
      await page.locator(id).fill(text);
      await page.locator(id).press('Enter');
    }
    await recorded(0, 2);
    const after = await places(tab);
    const angle = angleOf(minus(after[1], after[0])) - angleOf(minus(before[1], before[0]));
    assert.ok(Math.abs(Math.cos(angle)) < 1e-9, 'it is turned');
    await page.keyboard.press('Control+z');
    for (const [i, place] of (await places(tab)).entries()) {
      assert.ok(Math.abs(far(place, before[i]) - 0.5) < 1e-9, 'it was moved before');
    }
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);

    await tab.settled();
    await tab.still();
    const start = await revision();
    const { x, y } = await tab.handle('Move the selection');
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 20, y + 10);
    await dragging(tab, true);
    const at = await tab.handle('Move the selection');
    await page.mouse.move(x + 40, y + 20);
    await page.mouse.up();
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x, at.y - 30);
    await page.mouse.up();
    await recorded(start, 2);
    await page.keyboard.press('Control+z');
    assert.notEqual(await bytesOf(tab), whole, 'each drag is a step');
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('takes keys again after the user has stopped one', async () => {
    const tab = await open();
    const { page } = tab;
    const whole = await bytesOf(tab);
    await page.getByRole('button', { name: 'Pivot of turning' }).focus();
    await tab.holdEngine();
    await page.keyboard.press('ArrowRight');
    await page.getByRole('button', { name: 'Stop', exact: true }).click();
    await page.getByRole('button', { name: 'Stop', exact: true }).waitFor({ state: 'hidden' });
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);
    await page.getByRole('button', { name: 'Move the selection' }).focus();
    await page.keyboard.down('ArrowRight');
    await dragging(tab, true);
    await page.keyboard.up('ArrowRight');
    await dragging(tab, false);
    assert.notEqual(await bytesOf(tab), whole);
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('has the size of the lines, to read and to type', async () => {
    const tab = await open();
    const { page } = tab;
    const side = (name) => page.locator(`#size-${name}`);
    const size = async () =>
      (await Promise.all([side('width').inputValue(), side('height').inputValue()])).map(Number);
    const apart = (a, b) => Math.abs(a - b);
    const polyline = async () => Object.values((await tab.view()).curve.polyline);
    /** The extents of the traced line. The plane is seen from above: the first axis is the view's right. */
    const extents = async () => {
      const all = await polyline();
      return [0, 1].map((axis) => {
        const values = all.filter((_, i) => i % 3 === axis);
        return Math.max(...values) - Math.min(...values);
      });
    };
    const wanted = await extents();
    const whole = await bytesOf(tab);
    for (const [i, value] of (await size()).entries()) {
      assert.ok(apart(value, wanted[i]) < 1e-3 * wanted[i], `${value} for ${wanted[i]}`);
    }
    const type = async (name, text) => {
      await side(name).fill(text);
      await side(name).press('Enter');
      await page.waitForFunction(() => !window.karcherPage.state().dragging);
      await tab.settled();
    };
    for (const [name, axis, text] of [
      ['width', 0, '2,5'],
      ['height', 1, '0.5'],
    ]) {
      const [from, before] = [await size(), pairs(await places(tab))];
      await type(name, text);
      await page.waitForFunction(
        ([id, value]) => document.getElementById(id).value === value,
        [`size-${name}`, `${Number(text.replace(',', '.'))}`],
      );
      const to = await size();
      const scale = to[axis] / (await extents())[axis];
      assert.ok(apart(scale, 1) < 1e-3, `the ${name} is ${to[axis]}, and drawn ${scale} as large`);
      const ratios = pairs(await places(tab)).map((length, i) => length / before[i]);
      for (const ratio of ratios) assert.ok(apart(ratio, ratios[0]) < 1e-9, 'in proportion');
      assert.ok(apart(to[1 - axis] / from[1 - axis], ratios[0]) < 1e-3);
    }
    for (let i = 0; i < 2; i++) await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole, 'a step each');
    await tab.close();
  });

  test('measures circles by their diameter', async () => {
    const tab = await Tab.open(browser);
    await tab.drop('round.obj', `# round\n${flatGrid(16)}`);
    await tab.page.waitForFunction(() => window.karcherPage.triangles === 512);
    await tab.settled();
    await tab.page.locator('#tool-circle').click();
    const { x, y } = await tab.middle();
    await tab.drag({ x, y }, { x: x + 50, y: y + 20 });
    await tab.page.locator('#tool-transform').click();
    await frameShown(tab);
    const { drawing } = await tab.state();
    const { circle } = drawing.objects.find(({ figure }) => figure.circle).figure;
    const mesh = await tab.mesh();
    const radius = circle.rim.radius ?? far(...placesOf([circle.center, circle.rim], mesh));
    for (const side of ['width', 'height']) {
      const value = Number(await tab.page.locator(`#size-${side}`).inputValue());
      assert.ok(Math.abs(value / (2 * radius) - 1) < 1e-3, `${value} for ${2 * radius}`);
    }
    await tab.close();
  });

  inLongRun('closes for a menu when a finger rests on a handle', async () => {
    const tab = await open();
    const { page } = tab;
    const whole = await bytesOf(tab);
    const { x, y } = await tab.handle('Move the selection');
    const { touch } = await touchOf(page);
    await touch('touchStart', { x, y });
    await page.getByRole('menu').waitFor();
    for (const step of [15, 30]) await touch('touchMove', { x: x + step, y: y + step });
    await touch('touchEnd');
    await tab.pastSaving();
    await tab.settled();
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });

  test('two clicks mirror a copy', async () => {
    const tab = await open();
    const { page } = tab;
    const whole = await bytesOf(tab);
    await page.locator('#mirror').click();
    await page.locator('#mirror-copies').check();
    const { x, y } = await tab.middle();
    await page.mouse.click(x - 90, y + 60);
    await page.getByText('second point').waitFor();
    await page.mouse.click(x + 90, y + 61);
    await page.waitForFunction(() => window.karcherPage.state().drawing.objects.length === 2);
    const { drawing } = await tab.state();
    const [own, copy] = drawing.objects.map(({ figure }) => figure.points);
    const mesh = await tab.mesh();
    const sides = pairs(placesOf(own, mesh));
    for (const [i, side] of pairs(placesOf(copy, mesh)).entries()) {
      assert.ok(Math.abs(side - sides[i]) < 1e-9);
    }
    await page.keyboard.press('Control+z');
    assert.equal(await bytesOf(tab), whole);
    await tab.close();
  });
});
