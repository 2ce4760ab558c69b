// A mesh of any size, as a file.

/** A bent grid of about this many triangles, as the bytes of a binary STL file. */
export function gridStl(triangles) {
  const cells = Math.round(Math.sqrt(triangles / 2));
  const bytes = Buffer.alloc(84 + 50 * 2 * cells * cells);
  bytes.writeUInt32LE(2 * cells * cells, 80);
  const height = (i, j) => 0.1 * Math.sin((6 * i) / cells) * Math.cos((5 * j) / cells);
  let at = 84;
  const write = (corners) => {
    for (const [k, [i, j]] of corners.entries()) {
      const place = at + 12 + 12 * k;
      bytes.writeFloatLE(i / cells, place);
      bytes.writeFloatLE(j / cells, place + 4);
      bytes.writeFloatLE(height(i, j), place + 8);
    }
    at += 50;
  };
  for (let j = 0; j < cells; j++) {
    for (let i = 0; i < cells; i++) {
      write([
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
      ]);
      write([
        [i, j],
        [i + 1, j + 1],
        [i, j + 1],
      ]);
    }
  }
  return bytes;
}
