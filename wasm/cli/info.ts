import { type CheckUp, checkUp } from '../checkup/index.js';
import type { FileInfo } from '../formats/index.js';
import { load } from '../load.js';
import type { Command } from './command.js';

export const info: Command = {
  name: 'info',
  call: "mesh.info, and checkUp of 'karcher/checkup'",
  summary: 'the counts and sizes of a mesh, its repairs, and what to expect of curves on it',
  output:
    '{vertices, triangles, components, boundaryLoops, genus, meanEdge, diagonal, repairs: [{kind, count, message}, …], file: {format, parts: [{name, triangles}, …], materials: [name, …], isColored, notRead: [sentence, …]}, checkUp: {shortestEdge, longestEdge, smallestAngle, largestAngle, needles: {count, faces}, caps: {count, faces}, boundaryEdges, nearBoundaries: {vertices, weld}, expected: [sentence, …]}}; angles are in degrees, and needles and caps have their first 20 faces',
  options: [],
  async run(args) {
    const read = await args.meshFile();
    const { mesh, file } = await read(await load());
    return {
      json: { ...mesh.info, file: fileSummary(file), checkUp: summaryOf(await checkUp(mesh)) },
    };
  },
};

/** The file's marks, without the data of single vertices and triangles. */
function fileSummary({ format, parts, materials, colors, notRead }: FileInfo) {
  return { format, parts, materials, isColored: colors !== null, notRead };
}

/**
 * The largest number of faces in a list. Programs that need longer lists call `checkUp` themselves.
 */
const mostFaces = 20;

function summaryOf({ needles, caps, boundary, nearBoundaries: near, ...rest }: CheckUp) {
  const thin = (faces: Int32Array) => ({
    count: faces.length,
    faces: Array.from(faces.subarray(0, mostFaces)),
  });
  return {
    ...rest,
    needles: thin(needles),
    caps: thin(caps),
    boundaryEdges: boundary.length / 6,
    nearBoundaries: near && { vertices: near.places.length / 3, weld: near.weld },
  };
}
