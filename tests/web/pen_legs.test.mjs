// The legs of the pen's segments follow the pointer. These tests check it with the page's modules
// in Node, and by drags on the page.
import assert from 'node:assert/strict';
import { beforeEach, describe, test } from 'node:test';
import { load } from 'karcher';
import { browserOfSuite, Tab } from './browser.mjs';
import { arraysOfShape, openPage } from './engine_in_node.mjs';

/** Points along a geodesic around the tube of a torus; half of it is 1.25 long. */
const mesh = (await load()).shape('torus', 2000);
const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
const along = (length) => {
  const { end } = mesh.straightest(start, [0, 0, Math.sign(length) || 1], Math.abs(length));
  const [, u, v] = end.bary;
  // The form of points in links.
  return { face: end.face, bary: [Math.max(0, 1 - u - v), u, v] };
};
const smooth = (at) => ({
  ...along(at),
  tangents: { after: along(at + 0.1), before: { length: null } },
});

const lengthOf = (line) => {
  let length = 0;
  for (let i = 3; i < line.length; i += 3) {
    length += Math.hypot(...[0, 1, 2].map((k) => line[i + k] - line[i - 3 + k]));
  }
  return length;
};

const isNear = (a, b, off = 2e-3) => assert.ok(Math.abs(a - b) < off, `${a}, not ${b}`);

describe('legs of the pen', () => {
  let page;
  let figure;
  const length = () => page.session.view.curve.length;
  const legs = () => figure().points.map(({ leg }) => leg !== undefined);

  beforeEach(async () => {
    page = await openPage(await arraysOfShape('torus', 2000));
    page.editor.onEnded = (figure) => page.session.ended(figure);
    figure = () => page.editor.state.figure;
    page.editor.setKind('pen');
  });

  async function draw(points, settings = {}) {
    page.editor.replace({ ...figure(), points, settings: { ...figure().settings, ...settings } });
    await page.settled();
  }

  async function drag(index, anchors) {
    for (const to of anchors) {
      const from = page.editor.state.base.points[index];
      page.editor.preview({ type: 'change', index, from, to: { leg: from.leg, ...to } });
      await page.settled();
    }
  }

  async function release() {
    page.editor.commitDrag();
    await page.settled();
  }

  const places = (from, to) =>
    Array.from({ length: Math.round((to - from) / 0.05) }, (_, i) => from + 0.05 * (i + 1));

  /** A corner and a smooth anchor after a further drag around the tube. */
  async function drawnOut(more = []) {
    await draw([along(0), smooth(0.3), ...more]);
    for (const at of places(0.3, 1.9)) {
      await drag(1, [smooth(at)]);
      if (more.length === 0) isNear(length(), at);
    }
  }

  test('are continued while an anchor is dragged, and stay as drawn', async () => {
    await drawnOut();
    await release();
    assert.deepEqual(legs(), [true, false]);
    isNear(length(), 1.9);
    const [{ index, part }, ...others] = page.session.view.shorter;
    assert.deepEqual([index, others], [0, []]);
    assert.ok(part < 0.9, `${part}`);
    // The drag is one step, including its legs.
    const drawn = figure();
    page.editor.undo();
    await page.settled();
    isNear(length(), 0.3);
    assert.deepEqual(legs(), [false, false]);
    page.editor.redo();
    await page.settled();
    assert.deepEqual(figure(), drawn);
    isNear(length(), 1.9);
    page.edits.takeShortest(0);
    await page.settled();
    assert.ok(length() < 1.3, `${length()} long`);
    assert.deepEqual(page.session.view.shorter, []);
  });

  test('are continued while a handle is dragged, as are those at the other handle', async () => {
    const points = [along(0.9), smooth(0), along(-0.9)];
    await draw(points);
    const whole = length();
    // The opposite handles turn around the tube and grow.
    const led = (at) => ({
      ...points[1],
      tangents: { after: along(at), before: { length: null } },
    });
    await drag(1, places(0.1, 1).map(led));
    await release();
    const { shorter, curve } = page.session.view;
    assert.ok(length() > whole, 'the segments go back over their anchor');
    assert.deepEqual(legs(), [true, true, false]);
    assert.equal(shorter.length, 2);
    // The page draws the saved legs again.
    const { drawing, method } = page.editor.state;
    const { drawing: read } = page.parseLink(page.formatLink('torus:2000', method, drawing));
    assert.deepEqual(read.objects[0].figure, figure());
    assert.deepEqual(page.readDrawing(page.savedDrawing(drawing)), drawing);
    page.editor.clear();
    await page.settled();
    page.editor.draw(read);
    await page.settled();
    assert.deepEqual(page.session.view.curve.polyline, curve.polyline);
  });

  test('are continued while a segment is bent, which moves both of its handles', async () => {
    const handles = (before, after) => [
      { ...along(0), tangents: { after: along(before) } },
      { ...along(1.1), tangents: { before: along(after) } },
    ];
    /** The length along the geodesic, there and back. */
    const wayOf = (b, c) => {
      const at = (t) => 3 * t * (1 - t) ** 2 * b + 3 * t * t * (1 - t) * c + 1.1 * t ** 3;
      const steps = Array.from({ length: 1000 }, (_, i) => at((i + 1) / 1000) - at(i / 1000));
      return steps.reduce((sum, step) => sum + Math.abs(step), 0);
    };
    await draw(handles(-0.02, 1.12));
    isNear(length(), wayOf(-0.02, 1.12));
    for (let step = 1; step <= 8; step++) {
      const [b, c] = [-0.02 - 0.04 * step, 1.12 + 0.02 * step];
      const { base } = page.editor.state;
      const to = { ...base, points: handles(b, c) };
      page.editor.preview({ type: 'replace', from: base, to }, [0, 1]);
      await page.settled();
      // In the end the distance of the handles exceeds half-way around the tube.
      isNear(length(), wayOf(b, c));
    }
    const bent = length();
    await release();
    // Slow steps of a drag draw a draft.
    isNear(length(), bent);
    assert.deepEqual(legs(), [true, false]);
    assert.deepEqual(
      page.session.view.shorter.map(({ index }) => index),
      [0],
    );
  });

  test('are continued while an anchor is drawn out, as one step', async () => {
    await draw([along(0)]);
    const anchor = along(1.1);
    const place = async (point) => {
      page.editor.preview({ type: 'insert', index: 1, point });
      await page.settled();
    };
    await place(anchor);
    // The leg before the anchor follows its opposite handle around the tube.
    for (const at of places(0, 0.8)) {
      await place({ ...anchor, tangents: { after: along(1.1 - at), before: { length: null } } });
      isNear(lengthOf(page.session.view.curve.legs[1]), 1.1 + at);
    }
    await release();
    assert.deepEqual(legs(), [true, false]);
    isNear(lengthOf(page.session.view.curve.legs[1]), 1.9);
    page.editor.undo();
    assert.deepEqual(figure().points, [along(0)]);
    page.editor.redo();
    assert.deepEqual(legs(), [true, false]);
  });

  test('to a handle are the geodesics that end there', async () => {
    const handle = (length) => ({ direction: [0, 0, 1], length });
    // One handle is more than half around the tube, the other within one face.
    for (const size of [2, 1e-3]) {
      const tangents = { after: handle(size), before: { length: null } };
      await draw([{ ...along(0), tangents }, along(0.5)]);
      isNear(lengthOf(page.session.view.curve.legs[0]), size, 1e-5);
    }
  });

  test('of a closed curve go around its first anchor', async () => {
    await draw([smooth(0), along(-0.6), along(-0.7)], { closed: true });
    for (const at of places(0, 1.5)) await drag(0, [smooth(at)]);
    const drawn = length();
    await release();
    assert.deepEqual(legs(), [true, false, true]);
    isNear(length(), drawn);
    page.editor.setSettings({ closed: false });
    assert.deepEqual(legs(), [true, false, false]);
  });

  test('of a drag do not hinder the removal of an anchor at once', async () => {
    await drawnOut([along(-0.3)]);
    page.editor.commitDrag();
    await page.edits.removeAnchor(1);
    await page.settled();
    assert.deepEqual(legs(), [false, false]);
    page.editor.undo();
    assert.deepEqual(legs(), [true, true, false]);
  });

  test('move with their end, and stay if it is only written differently', async () => {
    await drawnOut([along(-0.3)]);
    await release();
    assert.deepEqual(legs(), [true, true, false]);
    const { points } = figure();
    // The test inserts and removes anchors.
    const { samples } = page.session.view.curve;
    const before = length();
    for (const part of [0.06, 0.25, 0.44]) {
      const at = 3 * Math.floor(part * samples.count);
      await page.edits.atCurve('insert', Array.from(samples.position.subarray(at, at + 3)));
      await page.settled();
      assert.deepEqual(legs(), [true, true, true, false]);
      isNear(length(), before, 0.03);
      page.editor.undo();
      await page.settled();
    }
    assert.deepEqual(figure().points, points);
    await page.edits.removeAnchor(0);
    assert.deepEqual(legs(), [true, false]);
    page.editor.undo();
    await page.edits.removeAnchor(1);
    assert.deepEqual(legs(), [false, false]);
    page.editor.undo();
    await page.edits.removeAnchor(2);
    assert.deepEqual(legs(), [true, false]);
    page.editor.undo();
    await page.edits.append(along(2.5));
    assert.deepEqual(legs(), [true, true, false, false]);
    page.editor.undo();
    // Without handles the anchor itself is an end of both legs.
    const { tangents: _, ...corner } = points[1];
    page.editor.run({ type: 'change', index: 1, from: points[1], to: corner });
    assert.deepEqual(legs(), [false, false, false]);
  });

  test('follow a handle that another joint moves, as in a drag', async () => {
    const { editor, session } = page;
    const pen = new page.PenGestures(editor, session, null, null);
    const anchor = (at) => ({
      ...along(at),
      tangents: { after: along(at + 0.6), before: { length: 0.1 } },
    });
    await draw([along(0), anchor(0.3), along(0.9)]);
    for (const at of places(0.3, 2.2)) await drag(1, [anchor(at)]);
    await release();
    const drawn = figure();
    const lengths = { corner: 2.1, smooth: 2.1, symmetric: 1.6 };
    for (const [joint, length] of Object.entries(lengths)) {
      editor.select(1);
      pen.setJoint(joint);
      await page.settled();
      const { polyline } = session.view.curve;
      const joined = figure().points[1];
      assert.deepEqual(legs(), [true, true, false]);
      isNear(lengthOf(session.view.curve.legs[1]), length);
      editor.undo();
      await page.settled();
      assert.deepEqual(figure(), drawn);
      await drag(1, [joined]);
      await release();
      assert.deepEqual(session.view.curve.polyline, polyline, joint);
      editor.undo();
      await page.settled();
    }
  });

  test('a joint is that of all selected anchors', async () => {
    const { editor, session } = page;
    const pen = new page.PenGestures(editor, session, null, null);
    const anchor = (at) => ({
      ...along(at),
      tangents: { after: along(at + 0.1), before: { length: 0.05 } },
    });
    await draw([anchor(0), anchor(0.3), anchor(0.6), anchor(0.9)]);
    editor.selectPoints([0, 1, 3]);
    pen.setJoint('symmetric');
    await page.settled();
    const before = (i) => figure().points[i].tangents.before.length;
    assert.deepEqual(
      [0, 1, 2, 3].map((i) => before(i) === 0.05),
      [false, false, true, false],
    );
    editor.undo();
  });

  test('stay on their way around when a click turns their anchor into a corner', async () => {
    await drawnOut([along(-0.3)]);
    await release();
    const pen = new page.PenGestures(page.editor, page.session, null, null);
    pen.convert(1);
    await page.settled();
    assert.equal(figure().points[1].tangents, undefined);
    assert.deepEqual(legs(), [true, true, false]);
    isNear(lengthOf(page.session.view.curve.legs[1]), 1.9);
    page.editor.undo();
    assert.ok(figure().points[1].tangents);
    assert.deepEqual(legs(), [true, true, false]);
  });

  test('beside an inserted anchor are stored only if they have points', async () => {
    await drawnOut();
    await release();
    page.editor.setSettings({ samples: 8 });
    await page.settled();
    const { curve } = page.session.view;
    const whole = length();
    for (const part of [0.2, 0.8]) {
      // Between the end and the new anchor, few samples remain.
      const { samples } = curve;
      const before = Math.floor(part * samples.count);
      const near = [0, 1, 2].map((axis) => samples.position[3 * before + axis]);
      await page.edits.atCurve('insert', near);
      await page.settled();
      isNear(length(), whole, 0.03);
      assert.equal(figure().points.length, 3);
      for (const { leg } of figure().points) assert.notEqual(leg?.length, 0);
      const { drawing, method } = page.editor.state;
      const link = page.formatLink('torus:2000', method, drawing);
      const [read] = page.parseLink(link).drawing.objects;
      assert.deepEqual(
        read.figure.points.map(({ leg }) => leg?.length),
        figure().points.map(({ leg }) => leg?.length),
      );
      const work = page.savedWork(link, drawing, page.editor.history);
      const { history } = page.readWork(work, link);
      assert.equal(
        history.done.length,
        page.editor.history.done.length,
        'a reload keeps the steps',
      );
      page.editor.undo();
      await page.settled();
    }
  });

  test('of an anchor that is drawn out belong to no earlier curve', async () => {
    const press = async (index, point) => {
      page.editor.preview({ type: 'insert', index, point });
      await page.settled();
    };
    await draw([along(0), along(2.2)]);
    const shortest = length();
    await draw([along(0)]);
    for (const takeBack of ['cancelDrag', 'undo']) {
      await press(1, along(1.1));
      for (const at of places(1.1, 1.9)) await press(1, along(at));
      isNear(length(), 1.9);
      if (takeBack === 'undo') await release();
      page.editor[takeBack]();
      await page.settled();
      await press(1, along(2.2));
      isNear(length(), shortest);
      await release();
      assert.deepEqual(legs(), [false, false]);
      page.editor.undo();
      await page.settled();
    }
    await draw([along(0.9), smooth(1.1)]);
    page.editor.clear();
    await press(0, along(0.05));
    await release();
    await press(1, along(0.25));
    isNear(length(), 0.2);
    page.editor.cancelDrag();
  });

  test('are the middle ones of the engine’s, by the indices of anchors', () => {
    const { penOptions, controlPointsOf, fitted } = page;
    const leg = [along(0.5)];
    const points = [along(0), { ...along(0.2), leg }, along(0.9)];
    const open = { ...figure(), points };
    const closed = { ...open, settings: { ...open.settings, closed: true } };
    const legsOf = (one, drawn = [{}, {}, {}]) => penOptions(one, drawn, {}).legs;
    assert.deepEqual(legsOf(open), [null, null, null, null, leg, null]);
    assert.deepEqual(legsOf(closed), [null, null, null, null, leg, null, null, null, null]);
    assert.equal(legsOf({ ...open, points: points.slice(0, 2) }), undefined);
    const through = [along(0.25), along(0.3)];
    const handles = { before: { point: along(0.1), through }, after: { point: 0, through: [] } };
    assert.deepEqual(legsOf(open, [{}, handles, {}]), [
      ...[null, null, through.toReversed()],
      ...[null, leg, null],
    ]);
    const around = (one) => points.map((_, i) => controlPointsOf(one, i));
    assert.deepEqual(around(open), [
      [0, 1],
      [2, 3, 4],
      [5, 6],
    ]);
    assert.deepEqual(around(closed), [
      [0, 1, 8, 9],
      [2, 3, 4],
      [5, 6, 7],
    ]);
    // The page may remove a handle if no leg ends at it.
    const fits = (index, to) => {
      const command = { type: 'change', index, from: points[index], to };
      const { points: after } = fitted(page.applyToFigure(open, command), open, command);
      return after[1].leg === leg;
    };
    const handle = { direction: [1, 0, 0], length: 0.1 };
    assert.ok(fits(0, along(0.1)));
    assert.ok(fits(1, { ...points[1], tangents: { before: handle } }));
    assert.ok(!fits(1, { ...points[1], tangents: { after: handle } }));
    assert.ok(!fits(1, { ...points[1], tangents: { before: handle, after: { length: 1 } } }));
    assert.ok(fits(2, { ...points[2], tangents: { after: handle } }));
    assert.ok(!fits(2, { ...points[2], tangents: { before: handle } }));
    assert.ok(!fits(2, along(1)));
  });
});

describe('a segment of the pen on the page', () => {
  const browser = browserOfSuite();

  /** Points on the upper side of the torus, around its axis. */
  const onRing = (angle) => [Math.cos(angle), Math.sin(angle), 0.4];

  /** The least and the largest of a line's angles around the axis. */
  function anglesOf(polyline) {
    const angles = [];
    for (let i = 0; i < polyline.length; i += 3) {
      const angle = Math.atan2(polyline[i + 1], polyline[i]);
      angles.push(angle < 0 ? angle + 2 * Math.PI : angle);
    }
    return [Math.min(...angles), Math.max(...angles)];
  }

  test('stays on its side of the hole while a handle is dragged, and afterwards', async () => {
    const tab = await Tab.open(browser, 'mesh=torus:2000');
    const { page } = tab;
    const { mouse } = page;
    const goTo = async (angle) => {
      const place = await page.evaluate((at) => window.karcherPage.seen(at), onRing(angle));
      assert.ok(place, `the ring is seen at ${angle}`);
      await mouse.move(place.x, place.y);
    };
    await page.keyboard.press('p');
    for (const [from, to] of [
      [0.2, 0.2],
      [2.1, 2.4],
    ]) {
      await goTo(from);
      await mouse.down();
      await goTo(to);
      await mouse.up();
      await tab.settled();
    }
    const staysOnItsSide = async (what) => {
      const { curve, polyline } = await tab.view();
      const [least, most] = anglesOf(polyline);
      assert.ok(least > 0.1 && most < 4.1, `${what} from ${least} to ${most}`);
      return curve.length;
    };
    await staysOnItsSide('at first');
    const { x, y } = await tab.handle('Handle before anchor 2');
    await mouse.move(x, y);
    await mouse.down();
    for (let angle = 1.9; angle < 4.05; angle += 0.1) {
      await goTo(angle);
      await staysOnItsSide(`with the handle at ${angle}`);
    }
    const dragged = await staysOnItsSide('at last');
    await mouse.up();
    const released = await staysOnItsSide('released');
    assert.ok(Math.abs(released / dragged - 1) < 0.01, `${released}, not ${dragged}`);
    const { figure } = await tab.state();
    assert.ok(figure.points[0].leg.length > 0);
    const view = await tab.view();
    assert.deepEqual(
      view.shorter.map(({ index }) => index),
      [0],
    );
    assert.match(await page.locator('#hint').textContent(), /anchor 1 is [\d,]+ % longer/);

    await tab.pastSaving();
    await page.evaluate(() => sessionStorage.clear());
    const other = await Tab.open(browser, page.url().split('#')[1]);
    assert.deepEqual((await other.state()).figure, figure);
    assert.deepEqual((await other.view()).polyline, view.polyline, 'the link alone tells it');
    await other.page.getByRole('button', { name: 'Shorten' }).click();
    const short = await other.view();
    assert.deepEqual(short.shorter, []);
    assert.ok(anglesOf(short.polyline)[1] > 4.5, 'the shortest leg goes on the other side');
    assert.deepEqual([...tab.logged, ...other.logged], []);
    await other.page.close();
    await page.close();
  });
});
