// The limits of a drawing that the page reads, which it does not exceed itself.
import assert from 'node:assert/strict';
import { before, beforeEach, describe, test } from 'node:test';
import { figure, load, point } from './figures.mjs';

describe('a drawing at a limit', () => {
  let arranging;
  let combining;
  let parts;
  let saved;
  before(async () => {
    parts = await load('../tests/web/page_parts.ts');
    [arranging, combining, saved] = await Promise.all(
      ['arranging', 'combining', 'saved_drawing'].map((name) => load(`model/${name}.ts`)),
    );
  });

  let editor;
  let refusals;
  beforeEach(() => {
    editor = new parts.Editor();
    refusals = [];
    editor.onRefusal = (sentence) => refusals.push(sentence);
  });

  const openObjects = (count) => {
    const objects = Array.from({ length: count }, (_, i) => parts.newObject(i + 1, figure));
    editor.open('sphere:20', { objects, active: count });
    editor.chooseAll();
  };
  /** The number of objects after an edit. The page reads them all again. */
  const countAfter = (edit) => {
    const { drawing } = editor.state;
    edit();
    const after = editor.state.drawing;
    saved.readDrawing(saved.savedDrawing(after));
    if (after.objects.length === drawing.objects.length) assert.equal(after, drawing);
    return after.objects.length;
  };

  test('has no more objects than a file may have', () => {
    openObjects(1000);
    assert.equal(
      countAfter(() => editor.objects.duplicate()),
      2000,
    );
    assert.deepEqual(refusals, []);
    assert.equal(
      countAfter(() => editor.objects.duplicate()),
      2000,
    );
    assert.equal(
      countAfter(() => editor.begin('circle')),
      2000,
    );
    const expanded = combining.expanding(editor.state.drawing, [figure, figure]);
    assert.equal(
      countAfter(() => editor.perform(expanded)),
      2000,
    );
    const dragged = () => {
      const { drawing } = editor.state;
      editor.previewCommand(arranging.leavingCopies(drawing, [drawing.active]));
      editor.commitDrag();
    };
    assert.equal(countAfter(dragged), 2000);
    assert.deepEqual(refusals, Array(4).fill('A drawing may have up to 2000 objects.'));
    assert.equal(
      countAfter(() => editor.undo()),
      1000,
    );
  });

  test('does not take what belongs to a refused object into another one', async () => {
    openObjects(2000);
    editor.letGo();
    assert.equal(editor.begin(), false);
    const { drawing } = editor.state;
    await new parts.CurveEdits(editor, {}).append(point(9));
    assert.equal(editor.state.drawing, drawing);
    assert.equal(refusals.length, 2);
  });

  test('keeps the selection if the anchor of another curve of the pen is refused', () => {
    openObjects(2000);
    editor.replace({ ...figure, kind: 'pen' });
    editor.letGo();
    editor.setTool('insert');
    const { drawing, selection, chosen, none } = editor.state;
    const viewer = {
      pick: () => ({ point: point(9) }),
      linesAt: () => ({ curve: () => null, shorter: () => -1 }),
    };
    const snapping = { on: false, placesOn: () => false, pick: () => ({ point: point(9) }) };
    const pen = new parts.PenGestures(editor, {}, viewer, snapping);
    pen.take({ x: 0, y: 0 }).release();
    assert.deepEqual(refusals, ['A drawing may have up to 2000 objects.']);
    const { state } = editor;
    assert.equal(state.drawing, drawing);
    assert.deepEqual([state.selection, state.chosen, state.none], [selection, chosen, none]);
  });

  test('says nothing of a removal that a refused step would have brought', () => {
    openObjects(1999);
    editor.begin('polyline');
    editor.run({ type: 'insert', index: 0, point: point(1) });
    let removals = 0;
    editor.begun.onRemoval = () => removals++;
    const { drawing } = editor.state;
    const steps = [0, 1].map((i) => ({
      type: 'add',
      index: 2000 + i,
      object: parts.newObject(3000 + i, figure),
    }));
    editor.perform({
      type: 'steps',
      steps: [...steps, { type: 'activate', from: 2000, to: 3001 }],
    });
    assert.equal(editor.state.drawing, drawing);
    assert.equal(removals, 0);
    editor.begin('polyline');
    assert.equal(removals, 1);
  });

  test('has no more points in a curve than a file may have', () => {
    openObjects(1);
    const points = Array.from({ length: 10_001 }, () => point(1));
    const curve = { ...figure, kind: 'polyline' };
    editor.replace({ ...curve, points: points.slice(1) });
    assert.equal(editor.state.figure.points.length, 10_000);
    editor.replace({ ...curve, points });
    assert.equal(editor.state.figure.points.length, 10_000);
    assert.deepEqual(refusals, ['A curve may have up to 10000 points.']);
  });

  test('beyond the limit can still become smaller', () => {
    openObjects(2100);
    const { objects, active } = editor.state.drawing;
    editor.objects.delete([objects[0].id]);
    assert.equal(editor.state.drawing.objects.length, 2099);
    assert.equal(editor.state.drawing.active, active);
    assert.deepEqual(refusals, []);
  });
});
