// One table for all text formats: byte order marks, line ends, comments, spellings of invalid
// numbers, and the use of these. All readers behave alike.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { meshFromFile } from 'karcher/formats';
import * as files from './mesh_files.mjs';

const { encode } = files;
let karcher;
before(async () => {
  karcher = await load();
});

const open = (bytes, options) => meshFromFile(karcher, bytes, options);

const header = (vertex) =>
  `ply\nformat ascii 1.0\nelement vertex 4\n${vertex.map((name) => `property float ${name}\n`).join('')}element face 1\nproperty list uchar int vertex_indices\nend_header\n`;

/**
 * Texts of a triangle and of an unused vertex: `used` is a coordinate of the triangle, `unused` are
 * numbers outside the surface, and `comment` stands wherever a format allows one.
 */
const texts = {
  obj: ({ used, unused, comment }) =>
    `${comment}v ${used} 0 0\n${comment}v 1 0 0 # 1\nv 0 1 0\nv ${unused} 0 0\nvn ${unused} 0 1\nvt ${unused} 0\nf 1 2 3\n`,
  off: ({ used, unused, comment }) =>
    `${comment}OFF # 1\n${comment}4 1 ${unused}\n${used} 0 0\n${comment}1 0 0\n0 1 0 # 2\n${unused} 0 0\n3 0 1 2 ${unused}\n`,
  noff: ({ used, unused, comment }) =>
    `NOFF\n${comment}4 1 0\n${used} 0 0 ${unused} 0 1\n1 0 0 0 0 ${unused}\n0 1 0 0 0 1\n${unused} 0 0 0 0 0\n3 0 1 2\n`,
  ply: ({ used, unused, comment }) =>
    `${header(['x', 'y', 'z', 'nx'])}${comment}${used} 0 0 ${unused}\n1 0 0 0 # 1\n0 1 0 0\n${unused} 0 0 0\n3 0 1 2\n`,
  stl: ({ used, unused, comment }) =>
    `${comment}solid s\nfacet normal ${unused} 0 1\n outer loop\n  vertex ${used} 0 0\n${comment}  vertex 1 0 0 # 1\n  vertex 0 1 0\n endloop\nendfacet\nendsolid s\n`,
};

const notNumbers = ['nan', '-NaN', 'inf', '-Infinity', '-nan(ind)', '1.#QNAN', '-1.#IND', '1.#INF'];

test('byte order marks, line ends, comments and spellings in all combinations', async () => {
  for (const [format, text] of Object.entries(texts)) {
    for (const mark of ['', '\ufeff']) {
      for (const end of ['\n', '\r\n', '\r']) {
        for (const comment of ['', '# made by a test\n', '\n  # 3 4\n\n']) {
          const file = (numbers) =>
            encode(
              mark + text({ used: '0', unused: '0', comment, ...numbers }).replaceAll('\n', end),
            );
          const what = (word) => JSON.stringify({ format, mark, end, comment, word });
          const name = `a.${format === 'noff' ? 'off' : format}`;
          for (const number of ['0', '+0.0', '-0', '.0e5', '0.']) {
            const { mesh } = await open(file({ used: number }), { name });
            assert.equal(mesh.info.triangles, 1, what(number));
          }
          for (const word of notNumbers) {
            const { mesh } = await open(file({ unused: word }), { name });
            assert.equal(mesh.info.triangles, 1, what(word));
            await assert.rejects(
              open(file({ used: word }), { name }),
              { code: 'notFinite', message: /finite/ },
              what(word),
            );
          }
          await assert.rejects(
            open(file({ used: 'x1' }), { name }),
            { code: 'badFile' },
            what('x1'),
          );
        }
      }
    }
  }
});

const ply = (rows, vertex = ['x', 'y', 'z', 'nx', 'ny', 'nz']) => encode(header(vertex) + rows);

test('rows over several lines are read, and extra values in a row of one line are ignored', async () => {
  const split = ply('0 0 0\n0 0 1\n1 0 0 0 0 1\n0 1\n\n0 0\n0 # more\n1\n1 1 0 0 0 1\n3\n0\n1 2\n');
  const { mesh, file } = await open(split);
  assert.deepEqual([...mesh.positions()].slice(0, 9), [0, 0, 0, 1, 0, 0, 0, 1, 0]);
  assert.deepEqual(file.notRead, []);
  const longer = await open(ply('0 0 0 9\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2 0 0\n', ['x', 'y', 'z']));
  assert.deepEqual([...longer.mesh.triangles()], [0, 1, 2]);
  assert.match(
    longer.file.notRead[0],
    /^Numbers beyond those of the header were left out, in 2 rows\.$/,
  );
  // Both errors are in one row, where a number is missing.
  await assert.rejects(open(ply('0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n', ['x', 'y', 'z'])), {
    code: 'badFile',
    message: 'line 10 ends where there must be a coordinate',
  });
});

test('OBJ: points, lines, curves and surfaces are counted, also behind continued lines', async () => {
  const rows = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  for (const [text, notRead] of [
    [rows, []],
    [`${rows}l 1 2 \\\n3\n`, ['1 element that is no face was left out.']],
    [
      `p 1 2\n${rows}l 1 2\n#l 1 2\n  curv 0 1 1 2\nlod 1\n`,
      ['3 elements that are no faces were left out.'],
    ],
  ]) {
    const { mesh, file } = await open(encode(text), { name: 'a.obj' });
    assert.deepEqual(file.notRead, notRead, text);
    assert.deepEqual(mesh.fileMarks().notRead, notRead, text);
  }
  assert.deepEqual(karcher.shape('torus', 500).fileMarks().notRead, []);
});

test('OFF: joined counts, colors that the keyword does not announce, and numbers on any lines', async () => {
  const rows = '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
  const colored = '0 0 0 255 0 0 255\n1 0 0 0 0 0 9\n0 1 0 1 1 1 1\n3 0 1 2 0.5 0.5 0.5\n';
  for (const [text, notRead] of [
    [`OFF3 1 0\n${rows}`, []],
    [`OFF 3 1 0\n${rows}`, []],
    [`OFF\n3\n1\n0\n${rows.replaceAll(' ', '\n')}`, []],
    [`OFF\n3 1\n0 0 0 1 0 0\n0 1 0\n3 0 1 2\n`, []],
    [`OFF 3 1 0\n${colored}`, ['Numbers beyond the places of vertices were left out, in 3 rows.']],
    [`COFF\n3 1 0\n${colored}`, []],
  ]) {
    const { mesh, file } = await open(encode(text));
    assert.deepEqual([...mesh.positions()], [0, 0, 0, 1, 0, 0, 0, 1, 0], text);
    assert.deepEqual(file.notRead, notRead, text);
  }
});

/** A binary OFF file: its keyword, then numbers, with whole ones as integers. */
function binaryOff(keyword, numbers) {
  const start = encode(`${keyword} BINARY\n`);
  const bytes = new Uint8Array(start.length + 4 * numbers.length);
  bytes.set(start);
  const view = new DataView(bytes.buffer);
  for (const [i, number] of numbers.entries()) {
    const at = start.length + 4 * i;
    if (typeof number === 'bigint') view.setInt32(at, Number(number));
    else view.setFloat32(at, number);
  }
  return bytes;
}

test('a binary OFF with any additional data of vertices and faces', async () => {
  for (const [keyword, more] of [
    ['OFF', []],
    ['NOFF', [0, 0, Number.NaN]],
    ['STCNOFF', [0, 0, 1, 0.2, 1, 0, 1, 0.5, 0.5]],
  ]) {
    const places = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
    const vertices = [0, 1, 2, 3].flatMap((i) => [...places.slice(3 * i, 3 * i + 3), ...more]);
    const faces = [3n, 0n, 1n, 2n, 0n, 3n, 0n, 2n, 3n, 3n, 1, 0.5, 0.25];
    const numbers = [4n, 2n, 5n, ...vertices, ...faces];
    const { mesh, file } = await open(binaryOff(keyword, numbers));
    const colors = /C/.test(keyword) ? places.flatMap((_, i) => [51, 255, 0][i % 3]) : null;
    assert.deepEqual(file.colors && [...file.colors], colors);
    assert.deepEqual([...mesh.positions()], places, keyword);
    assert.deepEqual([...mesh.triangles()], [0, 1, 2, 0, 2, 3], keyword);
    const bytes = binaryOff(keyword, numbers);
    for (let length = 11; length < bytes.length; length++) {
      await assert.rejects(open(bytes.slice(0, length)), { code: 'badFile' }, `${length}`);
    }
    await assert.rejects(open(binaryOff(keyword, [...numbers, 0n])), { code: 'badFile' });
  }
});

test('a binary STL with bytes after each triangle, whose length is in the last two', async () => {
  const plain = files.stlFile(files.cutBox);
  const rows = Array.from({ length: 12 }, (_, i) => plain.slice(84 + 50 * i, 134 + 50 * i));
  const longer = rows.map((row, i) => {
    const bytes = new Uint8Array(50 + 7 * (i % 5)).fill(0xab);
    bytes.set(row);
    new DataView(bytes.buffer).setUint16(48, 7 * (i % 5), true);
    return bytes;
  });
  const bytes = new Uint8Array(await new Blob([plain.slice(0, 84), ...longer]).arrayBuffer());
  const { mesh, file } = await open(bytes);
  const wanted = (await open(plain)).mesh;
  assert.deepEqual(mesh.triangles(), wanted.triangles());
  assert.deepEqual(mesh.positions(), wanted.positions());
  assert.match(file.notRead[0], /bytes after the triangles/);
  // Two bytes that are a color do not fit the length of the file.
  const colored = plain.slice();
  for (let i = 0; i < 12; i++) new DataView(colored.buffer).setUint16(132 + 50 * i, 31 * i, true);
  assert.deepEqual((await open(colored)).mesh.triangles(), wanted.triangles());
});

test('a text STL of facets only', async () => {
  const text = new TextDecoder().decode(files.stlFile(files.cutBox, { text: true }));
  const facets = text.replace(/(end)?solid.*\n/g, '');
  assert.equal((await open(encode(facets))).mesh.info.triangles, 12);
  await assert.rejects(open(encode(text.replace(/endsolid.*\n/, ''))), { code: 'badFile' });
});
