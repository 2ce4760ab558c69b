// Legs that a drag stretches, tested with the page's modules in Node.
import assert from 'node:assert/strict';
import { beforeEach, describe, test } from 'node:test';
import { load } from 'karcher';
import { arraysOfShape, openPage } from './engine_in_node.mjs';

/** Points along a geodesic around the tube of a torus; its first part is a shortest path. */
const mesh = (await load()).shape('torus', 2000);
const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
const along = (length) => mesh.straightest(start, [0, 0, 1], length).end;
const places = (from, to) =>
  Array.from({ length: Math.round((to - from) / 0.05) }, (_, i) => along(from + 0.05 * (i + 1)));

describe('stretched legs', () => {
  let page;
  let figure;
  let length;
  const legs = () => figure().points.map(({ leg }) => leg?.length ?? 0);
  beforeEach(async () => {
    page = await openPage(await arraysOfShape('torus', 2000));
    page.editor.onEnded = (figure) => page.session.ended(figure);
    figure = () => page.editor.state.figure;
    length = () => page.session.view.curve.length;
  });

  function step(index, place) {
    const from = page.editor.state.base.points[index];
    page.editor.preview({ type: 'change', index, from, to: { ...from, ...place } });
  }

  async function drag(index, ways) {
    for (const place of ways) {
      step(index, place);
      await page.settled();
    }
  }

  async function release() {
    page.editor.commitDrag();
    await page.settled();
  }

  describe('of a line whose end was dragged around the tube', () => {
    beforeEach(async () => {
      page.editor.setKind('polyline');
      for (const at of [0, 0.3]) await page.edits.append(along(at));
      await page.settled();
      await drag(1, places(0.3, 2.45));
    });

    /** Equality up to the rounding of a path's points. */
    const isNear = (a, b) => assert.ok(Math.abs(a - b) < 1e-3, `${a}, not ${b}`);

    async function goesOnFromTheShortest() {
      isNear(length(), 0.3);
      await drag(1, [along(0.301)]);
      isNear(length(), 0.301);
      await release();
      isNear(length(), 0.301);
      assert.deepEqual(legs(), [0, 0]);
    }

    test('after Escape the next drag begins with the visible legs', async () => {
      page.editor.cancelDrag();
      await page.settled();
      await goesOnFromTheShortest();
    });

    test('the next drag does so even if nothing was traced since Escape', async () => {
      page.editor.cancelDrag();
      await drag(1, [along(0.301)]);
      isNear(length(), 0.301);
    });

    test('the next drag does so if a drag ends before its first step is traced', async () => {
      page.editor.cancelDrag();
      step(1, along(0.301));
      await release();
      isNear(length(), 0.301);
      assert.deepEqual(legs(), [0, 0]);
    });

    test('after undo, redo and undo the next drag begins with the visible legs', async () => {
      await release();
      assert.ok(legs()[0] > 0);
      for (const step of ['undo', 'redo', 'undo']) {
        page.editor[step]();
        await page.settled();
      }
      await goesOnFromTheShortest();
    });

    const late = {
      'other settings': () => page.editor.setSettings({ samples: 50 }),
      'another name of the object': () =>
        page.editor.objects.setProperties([page.editor.active.id], { name: 'Around' }),
      'one more point': () => page.edits.append(along(2.6)),
      'a weight of the dragged point': () => {
        const from = figure().points[1];
        page.editor.run({ type: 'change', index: 1, from, to: { ...from, weight: 2 } });
      },
    };
    const lateCases = Object.entries(late).flatMap(([name, edit]) => [
      [`${name} came at once`, edit, false],
      [`${name} came before the drag’s last step was traced`, edit, true],
    ]);
    for (const [name, edit, untraced] of lateCases) {
      test(`stay if ${name}`, async () => {
        if (untraced) step(1, along(2.45));
        page.editor.commitDrag();
        await edit();
        assert.ok(legs()[0] > 0, 'part of the drag at once');
        const added = figure().points.length > 2 ? 0.15 : 0;
        await page.settled();
        assert.ok(legs()[0] > 0);
        isNear(length(), 2.45 + added);
        const drawing = JSON.stringify(page.editor.state.drawing);
        page.editor.undo();
        await page.settled();
        assert.ok(legs()[0] > 0);
        isNear(length(), 2.45);
        page.editor.undo();
        await page.settled();
        assert.deepEqual(legs(), [0, 0]);
        isNear(length(), 0.3);
        for (let i = 0; i < 2; i++) page.editor.redo();
        assert.equal(JSON.stringify(page.editor.state.drawing), drawing);
        await page.settled();
        isNear(length(), 2.45 + added);
        assert.deepEqual(page.failures, []);
      });
    }

    test('a release before the last step is traced keeps the legs of the step before', async () => {
      step(1, along(2.5));
      page.editor.commitDrag();
      await page.settled();
      assert.ok(legs()[0] > 0);
      isNear(length(), 2.5);
      const drawn = page.session.view.curve.samples.position;
      await drag(1, [along(2.55)]);
      await release();
      page.editor.undo();
      await page.settled();
      assert.deepEqual(page.session.view.curve.samples.position, drawn);
    });

    test('stay when another object is begun at once', async () => {
      const { id } = page.editor.active;
      page.editor.commitDrag();
      page.editor.begin('polyline');
      await page.settled();
      page.editor.activate(id);
      await page.settled();
      assert.ok(legs()[0] > 0);
      isNear(length(), 2.45);
    });

    test('a leg whose end was moved at once is the shortest', async () => {
      page.editor.commitDrag();
      const from = figure().points[0];
      page.editor.run({ type: 'change', index: 0, from, to: { ...from, ...along(0.02) } });
      await page.settled();
      assert.deepEqual(legs(), [0, 0]);
      page.editor.undo();
      await page.settled();
      assert.ok(legs()[0] > 0);
      isNear(length(), 2.45);
    });

    test('do not return with a step that was undone at once', async () => {
      page.editor.commitDrag();
      page.editor.undo();
      await page.settled();
      await goesOnFromTheShortest();
    });

    test('a drag that begins at once continues the legs of the last one', async () => {
      page.editor.commitDrag();
      await drag(1, [along(2.46)]);
      isNear(length(), 2.46);
      await drag(1, [along(2.5)]);
      isNear(length(), 2.5);
      await release();
      isNear(length(), 2.5);
      page.editor.undo();
      await page.settled();
      isNear(length(), 2.45);
    });
  });

  test('are shortest again if several points where they lead are removed together', async () => {
    const { editor, edits, settled } = page;
    editor.setKind('polyline');
    for (const at of [0, 0.3, 0.35, 0.4]) await edits.append(along(at));
    await settled();
    await drag(1, places(0.3, 2.45));
    await release();
    assert.ok(legs()[0] > 0);
    const base = figure();
    editor.selectPoints([1, 2]);
    await edits.removeSelected();
    await settled();
    assert.deepEqual(legs(), [0, 0]);
    assert.ok(Math.abs(length() - 0.4) < 1e-3, `${length()} long`);
    editor.undo();
    await settled();
    assert.deepEqual(figure(), base);
  });

  test('a curve of another kind that is reversed stays clamped as a B-spline', async () => {
    const { editor, edits, settled } = page;
    editor.setKind('bezier');
    for (const at of [0, 0.1, 0.2, 0.3]) await edits.append(along(at));
    await settled();
    assert.ok(figure().settings.clamped);
    await edits.reverse();
    assert.ok(figure().settings.clamped);
    editor.setKind('bspline');
    editor.setSettings({ closed: true });
    await settled();
    await edits.reverse();
    assert.ok(figure().settings.clamped);
  });

  for (const knots of [null, [0, 0, 0, 0, 1, 2.5, 3, 3, 3, 3]]) {
    test(`follow the point that they lead to, with ${knots ? 'own' : 'clamped'} knots`, async () => {
      const { editor, edits, settled } = page;
      editor.setKind('bspline');
      for (const at of [0, 0.1, 0.2, 0.3, 0.4, 0.5]) await edits.append(along(at));
      if (knots) assert.equal(await edits.setKnots(knots), null);
      else editor.setSettings({ clamped: true });
      await settled();
      await drag(5, places(0.5, 2.8));
      await release();
      assert.ok(legs()[4] > 0);
      editor.select(5);
      await edits.removeSelected();
      assert.deepEqual(legs(), [0, 0, 0, 0, 0]);
      await edits.append(along(0.5));
      await settled();
      assert.deepEqual(legs(), [0, 0, 0, 0, 0, 0]);
      assert.ok(length() < 0.6, `${length()} long`);
      assert.equal(figure().settings.knots?.length, knots?.length);
    });
  }
});
