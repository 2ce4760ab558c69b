import { KarcherError } from '../errors.js';
import { batchMask, Slices } from '../slices.js';
import type { LongWorkOptions } from '../types.js';
import { badFile, counted } from './failures.js';
import { GrowingPolygons } from './growing.js';
import { Words } from './text.js';
import type { Polygons } from './types.js';

/** A keyword such as OFF, COFF, STNOFF, 4OFF: what a vertex has beside its place. */
const keyword = /^(ST)?(C)?(N)?(4)?(n)?OFF$/;

export const isOff = (start: string) => keyword.test(/^\s*(?:#.*\s+)*(\S+)/.exec(start)?.[1] ?? '');

/**
 * Reads an OFF file of text; colors, normals and texture coordinates are left out.
 *
 * Rejects with `KarcherError` badFile or badIndex, naming the line, or the signal's reason.
 */
export async function readOff(bytes: Uint8Array, work: LongWorkOptions): Promise<Polygons> {
  const words = new Words(bytes);
  words.next();
  const [, texture, color, normal, four, many] = keyword.exec(words.word) ?? words.fail("'OFF'");
  if (four || many) {
    throw badFile(`the file is ${words.word}, of another dimension than 3, which is not read`);
  }
  if (!words.next()) words.fail('the number of vertices');
  if (words.word === 'BINARY') {
    throw badFile('the file is a binary OFF, which is not read: save it as text, or as PLY');
  }
  const vertices = words.asNumber('the number of vertices');
  if (!Number.isInteger(vertices) || vertices < 0) words.fail('the number of vertices');
  const faces = words.count('the number of faces');
  if (words.nextInLine()) words.asNumber('the number of edges');
  // A vertex takes three digits with what is between them, a face of no corners one.
  const room = bytes.length - words.at;
  if (6 * vertices + 2 * faces - 1 > room) {
    throw badFile(
      `the OFF file tells of ${counted(vertices)} vertices and ${counted(faces)} faces, but only ${counted(room)} bytes follow`,
    );
  }
  const slices = new Slices(work, 'reading');
  const more = (normal ? 3 : 0) + (texture ? 2 : 0);
  const positions = new Float64Array(3 * vertices);
  for (let vertex = 0; vertex < vertices; vertex++) {
    if ((vertex & batchMask) === 0 && slices.over) await slices.rest(words.at / bytes.length);
    for (let axis = 0; axis < 3; axis++) {
      positions[3 * vertex + axis] = words.number(`a coordinate of vertex ${vertex}`);
    }
    for (let i = 0; i < more; i++) words.number(`a number of vertex ${vertex}`);
    // A color has three or four numbers, and ends with the line.
    if (color) words.restOfLine();
  }
  const polygons = new GrowingPolygons();
  for (let face = 0; face < faces; face++) {
    if ((face & batchMask) === 0 && slices.over) await slices.rest(words.at / bytes.length);
    const size = words.count(`the number of corners of face ${face}`);
    for (let corner = 0; size >= 3 && corner < size; corner++) {
      const vertex = words.count(`a vertex of face ${face}`);
      if (vertex >= vertices) {
        throw new KarcherError(
          'badIndex',
          `line ${words.line}: face ${face} uses vertex ${vertex}, but the file has ${counted(vertices)}`,
        );
      }
      polygons.corner(vertex);
    }
    polygons.end(size);
    words.restOfLine();
  }
  if (words.next()) words.fail('the end of the file');
  const parts = [{ name: 'mesh', triangles: polygons.triangles }];
  const info = { format: 'off', parts, notRead: polygons.notRead } as const;
  return { positions, corners: polygons.corners, sizes: polygons.sizes, info };
}
