import { type CheckUp, checkUp } from '../checkup/index.js';
import type { FileInfo } from '../formats/index.js';
import { load } from '../load.js';
import type { Command } from './command.js';

export const info: Command = {
  name: 'info',
  call: "mesh.info, and checkUp of 'karcher/checkup'",
  summary:
    'what a mesh consists of, what was mended while it was read, and what to expect of curves',
  output:
    '{vertices, triangles, components, boundaryLoops, genus, meanEdge, diagonal, repairs: [{kind, count, message}, …], file: {format, parts: [{name, triangles}, …], materials: [name, …], isColored, notRead: [sentence, …]}, checkUp: {shortestEdge, longestEdge, smallestAngle, largestAngle, needles: {count, faces}, caps: {count, faces}, boundaryEdges, nearBoundaries: {vertices, weld}, expected: [sentence, …]}}; angles are in degrees, and of needles and caps the first 20 faces are told',
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

/** The most faces listed. Programs that need longer lists call `checkUp` themselves. */
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
