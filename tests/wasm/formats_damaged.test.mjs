// Damaged files of meshes: the reader refuses each with the fault and its place.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { meshFromFile } from 'karcher/formats';
import * as files from './mesh_files.mjs';

const { box, cutBox, encode } = files;
let karcher;
before(async () => {
  karcher = await load();
});

const open = (bytes, options) => meshFromFile(karcher, bytes, options);
const replaceIn = (bytes, from, to) => encode(new TextDecoder().decode(bytes).replace(from, to));
const json = (changes) => encode(JSON.stringify({ ...files.gltfParts(cutBox).json, ...changes }));
const withByte = (bytes, at, value) => {
  const changed = bytes.slice();
  changed[at] = value;
  return changed;
};

const damaged = {
  'an empty file': [new Uint8Array(), 'badFile', /empty/],
  'a PNG': [
    Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10),
    'badFile',
    /a PNG picture, which is not read/,
  ],
  'an FBX': [encode('Kaydara FBX Binary  \0'), 'badFile', /an FBX file/],
  'a 3MF': [Uint8Array.of(0x50, 0x4b, 3, 4), 'badFile', /a ZIP archive/],
  'a COLLADA': [encode('<?xml version="1.0"?>\n<COLLADA>'), 'badFile', /a COLLADA file/],
  'a word in a PLY': [
    replaceIn(files.plyFile(box), '2 200 3 4', '2 200 x 4'),
    'badFile',
    /^line 22: there must be a coordinate, not 'x'/,
  ],
  'a PLY row that is short': [
    replaceIn(files.plyFile(box), '2 200 3 4', '2 200 3'),
    'badFile',
    /^line 22 ends where there must be a coordinate/,
  ],
  'a PLY vertex that is not there': [
    files.plyFile({ ...box, faces: [[0, 1, 8]] }),
    'badIndex',
    /^line 24: face 0 uses vertex 8, but the file has 8$/,
  ],
  'a binary PLY that is cut off': [
    files.plyFile(box, { encoding: 'little' }).slice(0, -60),
    'badFile',
    /the file ends at byte \d+, where/,
  ],
  'a negative count in a PLY list': [
    replaceIn(files.plyFile(box), '-7 4 0 3', '-7 -4 0 3'),
    'badFile',
    /^line 24: face 0 cannot have -4 corners/,
  ],
  'more PLY vertices than bytes': [
    replaceIn(files.plyFile(box), 'vertex 8', 'vertex 2000000000'),
    'badFile',
    /2,000,000,000 elements 'vertex'/,
  ],
  'a PLY of an unknown type': [
    replaceIn(files.plyFile(box), 'double x', 'quad x'),
    'badFile',
    /^line 5: .*not 'quad'/,
  ],
  'a PLY without faces': [
    encode(
      'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n',
    ),
    'badFile',
    /a cloud of 1 points/,
  ],
  'a PLY header without end': [encode('ply\nformat ascii 1.0\n'), 'badFile', /end_header/],
  'a binary STL that is cut off': [
    files.stlFile(cutBox).slice(0, -1),
    'badFile',
    /12 triangles, which take 684 bytes, but it has 683/,
    'x.stl',
  ],
  'a text STL with a wrong word': [
    replaceIn(files.stlFile(cutBox, { text: true }), 'endloop', 'endlop'),
    'badFile',
    /^line 7: there must be 'endloop', not 'endlop'/,
  ],
  'a text STL that ends': [
    files.stlFile(cutBox, { text: true }).slice(0, 300),
    'badFile',
    /^line \d+: there must be .*(but the file ends|not )/,
  ],
  'an OFF vertex that is not there': [
    files.offFile({ ...box, faces: [[0, 1, 8]] }),
    'badIndex',
    /^line 11: face 0 uses vertex 8/,
  ],
  'an OFF of another dimension': [files.offFile(box, '4OFF\n'), 'badFile', /another dimension/],
  'a binary OFF that is cut off': [
    encode('OFF BINARY\n\0\0'),
    'badFile',
    /^the file ends at byte 11, where there must be the number of vertices/,
  ],
  'an OFF with more than it tells': [
    encode(`${new TextDecoder().decode(files.offFile(box))}3 0 1 2\n`),
    'badFile',
    /the end of the file/,
  ],
  'an OFF with a huge count': [
    encode('OFF\n2000000000 1 0\n0 0 0\n'),
    'badFile',
    /2,000,000,000 vertices/,
  ],
  'a GLB of version 1': [withByte(files.glbFile(cutBox), 4, 1), 'badFile', /version 1/],
  'a GLB that is cut off': [
    files.glbFile(cutBox).slice(0, -4),
    'badFile',
    /declares [\d,]+ bytes, but it has/,
  ],
  'a chunk that is too long': [
    withByte(files.glbFile(cutBox), 15, 1),
    'badFile',
    /^byte 12: a chunk/,
  ],
  'glTF that is no JSON': [encode('{"asset"'), 'badFile', /JSON cannot be read/],
  'glTF 1': [json({ asset: { version: '1.0' } }), 'badFile', /version 1\.0/],
  'glTF with an unknown extension': [
    json({ extensionsRequired: ['ACME_mesh'] }),
    'badFile',
    /ACME_mesh/,
  ],
  'glTF nodes in a circle': [json({ nodes: [{ children: [0] }] }), 'badFile', /node 0 .* twice/],
  'glTF without triangles': [json({ nodes: [{}] }), 'badFile', /no triangles/],
  'glTF with an accessor beyond its buffer': [
    files.glbFile(cutBox, {
      bufferViews: [
        { buffer: 0, byteLength: 90 },
        { buffer: 0, byteOffset: 96, byteLength: 144 },
      ],
    }),
    'badFile',
    /accessor 0 declares 8 rows/,
  ],
  'glTF with an index beyond its vertices': [
    files.glbFile({ ...cutBox, faces: [[0, 1, 8]] }),
    'badIndex',
    /corner 2: a triangle uses vertex 8/,
  ],
  'a number that is none': [
    files.plyFile({ ...cutBox, positions: [Number.NaN, ...box.positions.slice(1)] }),
    'notFinite',
    /vertex 0/,
  ],
};

test('damaged files are refused with the fault and its place', async () => {
  for (const [what, [bytes, code, message, name]] of Object.entries(damaged)) {
    await assert.rejects(
      open(bytes, name ? { name } : {}),
      (error) => {
        assert.equal(error.name, 'KarcherError', `${what}: ${error.stack}`);
        assert.equal(error.code, code, `${what}: ${error.message}`);
        assert.match(error.message, message, what);
        return true;
      },
      what,
    );
  }
});
