// The drawn form of lines and fills, without a browser.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from './figures.mjs';

const style = { width: 2, dash: 'solid', onSurface: false, opacity: 0.5, color: null };
const line = Float32Array.of(0, 0, 0, 1, 0, 0);

describe('transparent lines', () => {
  test('of different styles have different marks in the stencil, also after a removal', async () => {
    const { mostMarks, ObjectLines } = await load('viewer/object_lines.ts');
    const lines = new ObjectLines(1);
    const show = (widths) => {
      lines.show(
        widths.map((width, id) => ({
          ...{ id, locked: false, lines: [line], dots: [] },
          style: { ...style, width },
        })),
      );
      return lines.object.children.map(({ children }) => children.at(-1).material.stencilRef);
    };
    for (const widths of [[1, 2, 3], [2, 3], [2, 3, 4], [4], [5, 4, 6, 7]]) {
      const marks = show(widths);
      assert.equal(marks.length, widths.length);
      assert.equal(new Set(marks).size, marks.length, `${marks}`);
    }
    // Beyond the number of marks, the styles share them.
    const many = show(Array.from({ length: mostMarks + 20 }, (_, i) => i + 1));
    assert.equal(new Set(many).size, mostMarks);
    assert.ok(many.every((mark) => mark >= 1 && mark <= mostMarks));
  });
});
