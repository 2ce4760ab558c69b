// Objects whose sources are replaced by other objects, and objects with many sources.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { openPage } from './engine_in_node.mjs';
import { circle, figure, load } from './figures.mjs';

describe('an object whose source is replaced', () => {
  let combining;
  let page;
  before(async () => {
    page = await openPage(500);
    combining = await load('model/combining.ts');
  });

  const of = (kind, ...sources) => ({ ...figure, kind, points: [], derived: { sources } });
  const drawingOf = (figures, active) => ({
    objects: figures.map((one, i) => page.newObject(i + 1, one)),
    active,
  });
  const sourcesIn = ({ objects }, id) =>
    objects.find((one) => one.id === id).figure.derived.sources;

  test('follows the curves into which the source is expanded', () => {
    const round = { ...figure, kind: 'circle', circle };
    const sources = [of('union', 1, 2), of('union', 4, 3), of('difference', 3, 4)];
    const drawing = drawingOf([round, round, round, ...sources], 4);
    const command = combining.expanding(drawing, [figure, figure]);
    const { objects } = page.apply(drawing, command);
    assert.ok(!objects.some(({ id }) => id === 4));
    assert.deepEqual(sourcesIn({ objects }, 5), [7, 8, 3]);
    assert.deepEqual(sourcesIn({ objects }, 6), [3, 7, 8]);
    assert.deepEqual(page.apply({ objects, active: 8 }, page.invert(command)), drawing);
  });

  test('follows the pieces into which the source is split', async () => {
    const points = [1, 40, 90].map((face) => ({ face, bary: [0.25, 0.25, 0.5] }));
    const offset = { distance: 0.1, side: 'outwards' };
    const beside = { ...of('offset', 1), derived: { sources: [1], offset } };
    const to = drawingOf([{ ...figure, kind: 'polyline', points }, beside], 1);
    page.editor.perform({ type: 'draw', from: page.editor.state.drawing, to });
    const { curve } = await page.settled();
    const middle = 3 * Math.floor(curve.samples.count / 2);
    await page.edits.atCurve('split', [...curve.samples.position.subarray(middle, middle + 3)]);
    const { drawing } = page.editor.state;
    assert.deepEqual(
      drawing.objects.map(({ id }) => id),
      [1, 3, 2],
    );
    assert.deepEqual(sourcesIn(drawing, 2), [1, 3]);
    page.editor.undo();
    assert.deepEqual(page.editor.state.drawing, to);
  });

  test('follows the curve that joins the source', async () => {
    const curve = (...faces) => ({
      ...figure,
      kind: 'polyline',
      points: faces.map((face) => ({ face, bary: [0.25, 0.25, 0.5] })),
    });
    const offset = { distance: 0.1, side: 'outwards' };
    const first = { ...of('offset', 2), derived: { sources: [2], offset } };
    const second = { ...of('offset', 1, 2), derived: { sources: [1, 2], offset } };
    const to = drawingOf([curve(1, 40), curve(90, 130), first, second], 1);
    page.editor.perform({ type: 'draw', from: page.editor.state.drawing, to });
    await page.settled();
    await page.edits.join(2);
    const { drawing } = page.editor.state;
    assert.deepEqual(
      drawing.objects.map(({ id }) => id),
      [1, 3, 4],
    );
    assert.deepEqual(sourcesIn(drawing, 3), [1]);
    assert.deepEqual(sourcesIn(drawing, 4), [1]);
    page.editor.undo();
    assert.deepEqual(page.editor.state.drawing, to);
  });
});
