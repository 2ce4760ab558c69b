// The drawn form of lines and fills, without a browser.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { BufferAttribute, BufferGeometry } from 'three';
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

describe('a fill with a pattern', () => {
  let regions;
  before(async () => {
    const { Regions } = await load('viewer/regions.ts');
    regions = new Regions();
  });
  const surface = {
    regionGeometry: () =>
      new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(9), 3)),
  };
  const region = { whole: Int32Array.of(0), parts: new Int32Array(), corners: new Float64Array() };

  test('that turns out impossible is as dark as a solid fill', () => {
    const fill = { fill: 0.8, fillColor: null, pattern: 'hatched', spacing: 0.1 };
    const shown = (pattern, style = fill) => {
      regions.show([{ id: 1, region, pattern, style, color: null, locked: false }], surface);
      return regions.object.children[0].material.uniforms.opacity.value;
    };
    const solid = shown(null, { ...fill, pattern: 'solid' });
    assert.ok(shown(undefined) < solid, 'before its computation');
    assert.equal(shown(null), solid);
    assert.ok(shown(undefined) < solid);
  });
});
