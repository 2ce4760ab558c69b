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

test('lines that stay the same are not drawn anew with the others of their style', async () => {
  const { FatLine } = await load('viewer/fat_line.ts');
  const band = { width: 0.1, normals: (one) => one.map((value) => value + 1) };
  for (const look of [{}, { band }]) {
    const drawn = new FatLine({ width: 2, hidden: 0, ...look }, 1);
    const names = ['instanceStart', ...(look.band ? ['instanceNormalStart'] : [])];
    const dataOf = (name) => drawn.object.children[0].geometry.getAttribute(name).data;
    /** The first and the last float of an upload, as the renderer takes it. */
    const upload = () => {
      const ranges = dataOf('instanceStart').updateRanges.map(({ start, count }) => [start, count]);
      dataOf('instanceStart').clearUpdateRanges();
      return ranges;
    };
    const moved = (by) => line.map((value) => value + by);
    const shows = (lines, first, count = lines.length - first) => {
      assert.deepEqual(upload(), count > 0 ? [[6 * first, 6 * count]] : []);
      assert.equal(drawn.object.children[0].geometry.instanceCount, lines.length);
      for (const [k, name] of names.entries()) {
        const floats = lines.flatMap((one) => [...one].map((value) => value + k));
        assert.deepEqual([...dataOf(name).array.subarray(0, 6 * lines.length)], floats);
      }
    };
    const [a, b, c, d] = [0, 1, 2, 3].map(moved);
    drawn.set([a, b, c]);
    shows([a, b, c], 0);
    drawn.set([a, b, c]);
    shows([a, b, c], 3);
    drawn.set([a, b, d]);
    shows([a, b, d], 2);
    drawn.set([a, b]);
    shows([a, b], 2);
    drawn.set([b, a]);
    drawn.set([b, a, c]);
    shows([b, a, c], 0);
    drawn.setChosen(c, () => true);
    drawn.set([c, d]);
    shows([c, d], 0);
    // Larger buffers get all lines.
    const many = Array.from({ length: 600 }, (_, i) => moved(i));
    drawn.set([c, d, ...many]);
    shows([c, d, ...many], 0);
    drawn.clear();
    drawn.set([c]);
    shows([c], 0);
  }
  const plain = new FatLine({ width: 2, hidden: 0 }, 1);
  plain.set([line]);
  plain.setStyle({ width: 2, band });
  const normals = plain.object.children[0].geometry.getAttribute('instanceNormalStart');
  assert.deepEqual(
    [...normals.data.array.subarray(0, 6)],
    [...line].map((value) => value + 1),
  );
});

test('the surface keeps clear of lines and dots as wide as they are', async () => {
  const { Halos } = await load('viewer/halos.ts');
  const { dotStyle } = await load('viewer/object_lines.ts');
  const halos = new Halos();
  const wide = { ...style, width: 30 };
  const reachOf = (...drawn) => {
    halos.show(
      drawn.map((one) => ({ style: wide, lines: [line], dots: [], ...one })),
      [],
      [],
    );
    return halos.reach;
  };
  const rim = reachOf();
  const isWide = (width, ...drawn) => assert.equal(reachOf(...drawn) - rim, width / 2);
  isWide(wide.width, {}, { style });
  isWide(dotStyle(wide).width, { dots: [line] }, {});
  // Lines in the unit lie on the surface, as do their dots.
  isWide(wide.width, {}, { style: { ...wide, onSurface: true }, dots: [line] });
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
