// Writers of mesh files, for tests of their readers: each takes {positions, faces} (x, y, z a
// vertex; lists of vertex indices) and returns bytes.

/** The bytes of a text. */
export const encode = (text) => new TextEncoder().encode(text);

const triples = ({ positions }) =>
  Array.from({ length: positions.length / 3 }, (_, i) => positions.slice(3 * i, 3 * i + 3));

/** A box of two by three by four on z = 0, with six faces of four corners. */
export const box = {
  positions: [0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0, 0, 0, 4, 2, 0, 4, 2, 3, 4, 0, 3, 4],
  faces: [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 1, 5, 4],
    [1, 2, 6, 5],
    [2, 3, 7, 6],
    [3, 0, 4, 7],
  ],
};

/** The box with triangles. */
export const cutBox = {
  positions: box.positions,
  faces: box.faces.flatMap(([a, b, c, d]) => [
    [a, b, c],
    [a, c, d],
  ]),
};

export function objFile(mesh) {
  const vertices = triples(mesh).map((place) => `v ${place.join(' ')}`);
  const faces = mesh.faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`);
  return encode(`${[...vertices, ...faces].join('\n')}\n`);
}

export function offFile(mesh, header = 'OFF\n') {
  const counts = `${mesh.positions.length / 3} ${mesh.faces.length} 0`;
  const vertices = triples(mesh).map((place) => place.join(' '));
  const faces = mesh.faces.map((face) => `${face.length}  ${face.join(' ')}`);
  return encode(`${header}${counts}\n${[...vertices, ...faces].join('\n')}\n`);
}

const sizes = { char: 1, uchar: 1, short: 2, ushort: 2, int: 4, uint: 4, float: 4, double: 8 };
const setters = {
  char: 'setInt8',
  uchar: 'setUint8',
  short: 'setInt16',
  ushort: 'setUint16',
  int: 'setInt32',
  uint: 'setUint32',
  float: 'setFloat32',
  double: 'setFloat64',
};

/** A PLY file. Additional properties stand beside those that readers use. */
export function plyFile(
  mesh,
  { encoding = 'ascii', real = 'double', length = 'uchar', index = 'int', eol = '\n' } = {},
) {
  const header = [
    'ply',
    `format ${{ ascii: 'ascii', little: 'binary_little_endian', big: 'binary_big_endian' }[encoding]} 1.0`,
    'comment made by a test',
    `element vertex ${mesh.positions.length / 3}`,
    `property ${real} x`,
    'property uchar red',
    `property ${real} y`,
    `property ${real} z`,
    `element face ${mesh.faces.length}`,
    'property short quality',
    `property list ${length} ${index} vertex_indices`,
    'property list uchar float texcoord',
    'element edge 1',
    'property int vertex1',
    'end_header',
    '',
  ].join(eol);
  const rows = [
    ...triples(mesh).map(([x, y, z]) => [
      [real, x],
      ['uchar', 200],
      [real, y],
      [real, z],
    ]),
    ...mesh.faces.map((face) => [
      ['short', -7],
      [length, face.length],
      ...face.map((vertex) => [index, vertex]),
      ['uchar', 2],
      ['float', 0.5],
      ['float', 0.25],
    ]),
    [['int', 0]],
  ];
  if (encoding === 'ascii') {
    return encode(
      header + rows.map((row) => row.map(([, value]) => value).join(' ') + eol).join(''),
    );
  }
  const bytes = rows.flat().reduce((sum, [type]) => sum + sizes[type], 0);
  const start = encode(header);
  const file = new Uint8Array(start.length + bytes);
  file.set(start);
  const view = new DataView(file.buffer);
  let at = start.length;
  for (const [type, value] of rows.flat()) {
    view[setters[type]](at, value, encoding === 'little');
    at += sizes[type];
  }
  return file;
}

export function stlFile(mesh, { text = false, solids = 1 } = {}) {
  const corners = mesh.faces.map((face) =>
    face.map((vertex) => mesh.positions.slice(3 * vertex, 3 * vertex + 3)),
  );
  if (text) {
    const facets = corners.map(
      (places) =>
        `facet normal 0 0 1\n outer loop\n${places.map((place) => `  vertex ${place.join(' ')}\n`).join('')} endloop\nendfacet\n`,
    );
    const part = Math.ceil(facets.length / solids);
    const solid = (i) =>
      `solid part ${i}\n${facets.slice(i * part, (i + 1) * part).join('')}endsolid part ${i}\n`;
    return encode(Array.from({ length: solids }, (_, i) => solid(i)).join(''));
  }
  const file = new Uint8Array(84 + 50 * corners.length);
  file.set(encode('solid in name only'));
  const view = new DataView(file.buffer);
  view.setUint32(80, corners.length, true);
  for (const [i, places] of corners.entries()) {
    for (const [j, value] of places.flat().entries()) {
      view.setFloat32(84 + 50 * i + 12 + 4 * j, value, true);
    }
  }
  return file;
}

/** The parts of a glTF file: JSON whose buffer 0 holds float positions and indices of triangles. */
export function gltfParts({ positions, faces }, changes = {}) {
  const corners = faces.flat();
  const buffer = new Uint8Array(4 * (positions.length + corners.length));
  const view = new DataView(buffer.buffer);
  for (const [i, value] of positions.entries()) view.setFloat32(4 * i, value, true);
  const start = 4 * positions.length;
  for (const [i, value] of corners.entries()) view.setUint32(start + 4 * i, value, true);
  const bounds = (pick) =>
    [0, 1, 2].map((axis) => pick(...positions.filter((_, i) => i % 3 === axis)));
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'body' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        ...{ bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3' },
        ...{ min: bounds(Math.min), max: bounds(Math.max) },
      },
      { bufferView: 1, componentType: 5125, count: corners.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: start },
      { buffer: 0, byteOffset: start, byteLength: buffer.length - start },
    ],
    buffers: [{ byteLength: buffer.length }],
    ...changes,
  };
  return { json, buffer };
}

/** A GLB file. Its chunks have lengths of multiples of four bytes. */
export function glbOf({ json, buffer }) {
  const text = encode(JSON.stringify(json));
  const fill = (length) => 4 * Math.ceil(length / 4);
  const [jsonLength, bufferLength] = [fill(text.length), fill(buffer.length)];
  const file = new Uint8Array(12 + 8 + jsonLength + 8 + bufferLength);
  const view = new DataView(file.buffer);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(4, 2, true);
  view.setUint32(8, file.length, true);
  view.setUint32(12, jsonLength, true);
  view.setUint32(16, 0x4e4f534a, true);
  file.fill(32, 20, 20 + jsonLength);
  file.set(text, 20);
  view.setUint32(20 + jsonLength, bufferLength, true);
  view.setUint32(24 + jsonLength, 0x004e4942, true);
  file.set(buffer, 28 + jsonLength);
  return file;
}

export const glbFile = (mesh, changes) => glbOf(gltfParts(mesh, changes));

/** A file of a triangle mesh in every format, by a possible name. */
export const everyFile = (mesh) => ({
  'mesh.obj': objFile(mesh),
  'text.ply': plyFile(mesh),
  'little.ply': plyFile(mesh, { encoding: 'little' }),
  'big.ply': plyFile(mesh, { encoding: 'big', real: 'float', index: 'ushort', length: 'int' }),
  'text.stl': stlFile(mesh, { text: true }),
  'binary.stl': stlFile(mesh),
  'mesh.off': offFile(mesh),
  'mesh.glb': glbFile(mesh),
});
