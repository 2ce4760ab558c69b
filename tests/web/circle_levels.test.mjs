// The levels of a circle, tested with the page's modules in Node.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from 'karcher';
import { arraysOfShape, openPage } from './engine_in_node.mjs';

describe('the levels of a circle', () => {
  test('are as many as the engine chooses, and in a drag the most so far', async () => {
    const mesh = (await load()).shape('torus', 20000);
    const center = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
    const levelsOf = (radius) => mesh.circle(center, { radius, arcs: 7 }).levels;
    const [near, far] = [0.2, 0.45];
    assert.ok(levelsOf(far) > levelsOf(near));

    const { editor, session, settled } = await openPage(await arraysOfShape('torus', 20000));
    const rim = (radius) => ({ radius, direction: [0, 1, 0] });
    editor.setKind('circle');
    // Arcs of the tolerance's number are narrow and seldom take levels.
    editor.setCircleForm({ arcs: 7 });
    const placed = { center, rim: rim(near) };
    editor.run({ type: 'circle', from: null, to: placed });
    const levels = async () => (await settled()).curve.levels;
    assert.equal(await levels(), levelsOf(near));
    for (const radius of [far, near]) {
      editor.preview({ type: 'circle', from: placed, to: { center, rim: rim(radius) } });
      assert.equal(await levels(), levelsOf(far), `${radius} under the hand`);
    }
    assert.equal(session.view.problem, null);
    editor.commitDrag();
    assert.equal(await levels(), levelsOf(near), 'released');
  });
});
