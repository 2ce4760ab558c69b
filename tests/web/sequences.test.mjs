// Any sequence of edits of a curve leaves a curve.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { openPage } from './engine_in_node.mjs';
import { long, randoms, seed } from './part.mjs';

const triangles = 500;
const kinds = ['bspline', 'bezier', 'catmullrom', 'rational', 'barycentric', 'polyline'];
const mostPoints = 9;
/** Sentences of impossible edits. */
const refusals =
  /can(not)? be joined|cannot be split at \d+, its end|has no end to join|at least \d control points|not at one|control point there|takes no more|has a knot there/;

/**
 * The objects of a drawing as a link stores them: renumbered, with the first of three weights
 * computed from the others.
 */
const plain = ({ objects, active }) => ({
  active: objects.findIndex(({ id }) => id === active),
  objects: objects.map(({ id: _, figure, ...properties }) => ({
    ...properties,
    figure: {
      ...figure,
      points: figure.points.map(({ face, bary: [, u, v], ...numbers }) => ({
        face,
        u,
        v,
        ...numbers,
      })),
    },
  })),
});

describe('sequences of edits', () => {
  let page;
  before(async () => {
    page = await openPage(triangles);
  });

  /** The page's own edits by their names; each of them may have no effect. */
  function editsOf(random) {
    const { editor, session, edits, othersOf } = page;
    const below = (count) => Math.floor(random() * count);
    const settings = () => editor.state.figure.settings;
    const point = () => {
      const [u, v] = [random() / 2, random() / 2];
      return { face: below(triangles), bary: [1 - u - v, u, v] };
    };
    const onCurve = () => {
      const position = session.view.curve?.samples.position;
      const at = position && 3 * below(position.length / 3);
      return position && Array.from(position.subarray(at, at + 3));
    };
    /** The distance from a click within which it means a knot, often a large one. */
    const within = () => (random() < 0.3 ? 0.05 : 0);
    const change = (make) => {
      const { points } = editor.state.figure;
      const index = below(points.length);
      const from = points[index];
      if (from) editor.run({ type: 'change', index, from, to: make(from) });
    };
    return {
      append: () => editor.state.figure.points.length < mostPoints && edits.append(point()),
      remove: () => {
        const { points } = editor.state.figure;
        if (points.length > 0) editor.select(below(points.length));
        return edits.removeSelected();
      },
      insert: () => {
        const near = editor.state.figure.points.length < mostPoints && onCurve();
        return near && edits.atCurve('insert', near, within());
      },
      split: () => {
        const near = othersOf(editor.state.drawing).length < 2 && onCurve();
        return near && edits.atCurve('split', near, within());
      },
      join: () => {
        const { drawing, figure } = editor.state;
        const other = othersOf(drawing).find((one) => one.figure.kind === figure.kind);
        return other && edits.join(other.id);
      },
      activate: () => {
        const others = othersOf(editor.state.drawing);
        return others.length > 0 && edits.atOther('insert', others[below(others.length)].id);
      },
      reverse: () => session.view.curve && edits.reverse(),
      close: () => edits.setClosed(!settings().closed),
      kind: () => editor.setKind(kinds[below(kinds.length)]),
      degree: () => editor.setSettings({ degree: 1 + below(5), knots: null }),
      clamped: () => editor.setSettings({ clamped: !settings().clamped, knots: null }),
      spacing: () =>
        editor.setSettings({ parametrization: random() < 0.5 ? 'uniform' : 'centripetal' }),
      sampling: () => {
        // A tolerance often gives more samples than their fixed number, which a drag then uses.
        const [samples, tolerance] = [
          2 + below(random() < 0.5 ? 4 : 200),
          random() < 0.5 ? 1e-3 : null,
        ];
        editor.setSettings({ samples, tolerance, marks: below(5) * 3 });
      },
      reorder: () => {
        const { points } = editor.state.figure;
        if (points.length > 0) editor.select(below(points.length));
        editor.moveInOrder(below(9) - 4);
      },
      move: () => change((from) => ({ ...from, ...point() })),
      drag: async () => {
        const index = below(editor.state.figure.points.length);
        const from = editor.state.figure.points[index];
        if (!from) return;
        for (let step = 0; step < 2; step++) {
          editor.preview({ type: 'change', index, from, to: { ...from, ...point() } });
          await page.settled();
        }
        if (random() < 0.2) editor.cancelDrag();
        else editor.commitDrag();
      },
      weight: () => change((from) => ({ ...from, weight: 2 ** (2 * random() - 1) })),
      beta: () => change((from) => ({ ...from, beta: 2 ** (2 * random() - 1) })),
      undo: () => edits.undo(),
      redo: () => edits.redo(),
      clear: () => random() < 0.2 && editor.clear(),
      begin: () => othersOf(editor.state.drawing).length < 3 && editor.begin(),
      duplicate: () => {
        const { drawing } = editor.state;
        return othersOf(drawing).length < 2 && editor.objects.duplicate([drawing.active]);
      },
      delete: () => random() < 0.2 && editor.objects.delete([editor.state.drawing.active]),
    };
  }

  /**
   * The link describes the whole document, and the visible curve equals a new curve of the
   * document.
   */
  async function assertSameAnew(view, told) {
    const { editor, session, parseLink, formatLink, curveOptions, methodOptions, splineOf } = page;
    const { mesh, method, drawing, figure } = editor.state;
    const read = parseLink(formatLink(mesh, method, drawing)).drawing;
    assert.deepEqual(plain(read), plain(drawing), told);
    if (!view.curve) return;
    const options = curveOptions(splineOf(figure), methodOptions(method));
    const anew = await session.client.curve(options);
    const [shown, made] = [view.curve, anew].map(({ samples }) => samples.position);
    assert.equal(made.length, shown.length, told);
    const farthest = made.reduce((most, x, i) => Math.max(most, Math.abs(x - shown[i])), 0);
    assert.ok(farthest <= 1e-6 * session.client.info.diagonal, `${farthest}: ${told}`);
  }

  test('a drag has the fixed number of samples if a tolerance takes more', async () => {
    const { editor, edits, session } = page;
    editor.open('sphere:drag', page.emptyDrawing);
    for (const face of [10, 60, 110, 160]) await edits.append({ face, bary: [0.5, 0.25, 0.25] });
    editor.setSettings({ samples: 4, tolerance: 1e-4 });
    const count = async () => (await page.settled()).curve.samples.count;
    const fine = await count();
    assert.ok(fine > 4);
    const [from] = editor.state.figure.points;
    editor.preview({ type: 'change', index: 0, from, to: { ...from, face: 12 } });
    assert.equal(await count(), 4);
    editor.commitDrag();
    assert.ok((await count()) > 4, 'and as many as it takes after it');
    editor.setSettings({ samples: 500 });
    await page.settled();
    editor.preview({ type: 'change', index: 0, from, to: { ...from, face: 14 } });
    assert.ok((await count()) < 500, 'fewer are kept');
    editor.cancelDrag();
    await page.settled();
    assert.deepEqual(session.view.problem, null);
  });

  const runs = long ? 60 : 3;
  for (let run = 0; run < runs; run++) {
    test(`leave a curve: KARCHER_SEED=${seed}, run ${run}`, async () => {
      const numbers = randoms(1000 * seed + run);
      const random = () => numbers.next().value;
      const edits = editsOf(random);
      // Most edits add and remove points.
      const names = [...Object.keys(edits), 'append', 'append', 'append', 'insert', 'remove'];
      const done = [];
      // Each run has a document of its own, so that it can be repeated alone.
      page.editor.open(`sphere:${run}`, page.emptyDrawing);
      for (let step = 0; step < 150; step++) {
        const name = step < 5 ? 'append' : names[Math.floor(random() * names.length)];
        done.push(name);
        await edits[name]();
        const view = await page.settled();
        const { figure: document } = page.editor.state;
        const told = `${done.join(' ')}: ${JSON.stringify(document)}`;
        assert.equal(view.problem, null, told);
        const enough = document.points.length >= page.pointsNeeded(document);
        assert.equal(view.curve !== null, enough, told);
        await assertSameAnew(view, told);
        for (const failure of page.failures.splice(0)) assert.match(failure, refusals, told);
      }
    });
  }
});
