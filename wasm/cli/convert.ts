import { writeFile } from 'node:fs/promises';
import {
  type FileMarks,
  meshFile,
  type Triangles,
  type WrittenFormat,
  writtenFormats,
} from '../formats/index.js';
import { load } from '../load.js';
import type { Mesh } from '../mesh.js';
import type { CutPart } from '../types.js';
import type { Arguments } from './arguments.js';
import type { Command, Result } from './command.js';
import { UsageError, writeError } from './errors.js';
import type { Option } from './options.js';

/**
 * Commands that read a mesh and write it to a file: its used vertices, its triangles, its colors
 * and its parts.
 */

const outOption: Option = {
  name: 'out',
  value: 'FILE',
  help: `the file for the mesh, ${writtenFormats.join(', ')} by its ending; '-' is standard output. For several meshes a '*' stands for each one's name`,
  required: true,
};

const formatOption: Option = {
  name: 'to',
  value: writtenFormats.join('|'),
  help: "the format, if the file's ending does not name it",
};

export const convert: Command = {
  name: 'convert',
  call: "meshFromFile and meshFile of 'karcher/formats'",
  summary: 'the mesh in another format, as triangles, and mended where that is safe',
  output:
    "{file, vertices, triangles, repairs: [{kind, count, message}, …]}; with --out - the mesh's bytes instead",
  options: [outOption, formatOption],
  run: (args) => written(args),
};

export const repair: Command = {
  name: 'repair',
  call: "mesh.info.repairs, and meshFile of 'karcher/formats'",
  summary: 'the repairs of a mesh that is no surface, and the mended mesh',
  output: convert.output,
  options: [outOption, formatOption],
  async run(args) {
    args.refuse(['repair'], 'with karcher repair');
    return written(args);
  },
};

async function written(args: Arguments): Promise<Result> {
  const format = formatOf(args);
  const read = await args.meshFile();
  const { mesh, file: marks } = await read(await load());
  const surface = surfaceOf(mesh, marks);
  const bytes = meshFile(surface, format);
  const file = args.text('out');
  if (file === '-') return { json: {}, bytes };
  try {
    await writeFile(file, bytes);
  } catch (cause) {
    throw writeError(file, cause);
  }
  return {
    json: {
      file,
      vertices: surface.positions.length / 3,
      triangles: surface.triangles.length / 3,
      repairs: mesh.info.repairs,
    },
  };
}

function formatOf(args: Arguments): WrittenFormat {
  if (args.given('to')) return args.choice<WrittenFormat>('to');
  const path = args.text('out');
  const ending = /\.([^./\\]+)$/.exec(path)?.[1]?.toLowerCase();
  const format = writtenFormats.find((candidate) => candidate === ending);
  if (format !== undefined) return format;
  throw new UsageError(
    `--out of ${args.command} must end in .${writtenFormats.join(', .')}, or --to names the format; it is '${path}'`,
  );
}

/**
 * The colors of vertices, found by their positions, since repairs renumber the vertices. A vertex
 * has the color of a corner of the first of its faces, or else of another vertex at its place.
 * Vertices at positions that the mesh's file does not have are white.
 *
 * `corners` has three vertices for each face of `faces`, which are those of the file.
 */
function colorsAt(
  mesh: Mesh,
  colors: Uint8Array,
  positions: readonly number[],
  corners: readonly number[],
  faces: readonly number[],
): Uint8Array {
  const [given, triangles] = [mesh.positions(), mesh.triangles()];
  const place = (at: ArrayLike<number>, vertex: number) =>
    `${at[3 * vertex]} ${at[3 * vertex + 1]} ${at[3 * vertex + 2]}`;
  const known = new Map<string, number>();
  for (let v = given.length / 3 - 1; v >= 0; v--) known.set(place(given, v), v);
  const result = new Uint8Array(positions.length).fill(255);
  // Of the faces at a vertex, the first is the last to set its color.
  for (let i = corners.length - 1; i >= 0; i--) {
    const face = 3 * faces[Math.floor(i / 3)]!;
    const isHere = (v: number) =>
      [0, 1, 2].every((k) => given[3 * v + k] === positions[3 * corners[i]! + k]);
    const own = triangles.subarray(face, face + 3).find(isHere);
    const vertex = own ?? known.get(place(positions, corners[i]!));
    if (vertex === undefined) continue;
    result.set(colors.subarray(3 * vertex, 3 * vertex + 3), 3 * corners[i]!);
  }
  return result;
}

/**
 * The surface after its repairs, with the file's marks. Triangles are in the file's order, and
 * vertices are in the order of their first use.
 */
function surfaceOf(
  mesh: Mesh,
  { colors, parts, partOf }: FileMarks,
): Required<Omit<Triangles, 'curves'>> & {
  positions: Float64Array;
  triangles: Int32Array;
} {
  // Without paths, `cut` divides a mesh into its components, which have the engine's own vertices.
  const triangles: { face: number; part: CutPart; at: number; first: number }[] = [];
  let first = 0;
  for (const part of mesh.cut([])) {
    part.faces.forEach((face, i) => {
      triangles.push({ face, part, at: 3 * i, first });
    });
    first += part.positions.length / 3;
  }
  triangles.sort((a, b) => a.face - b.face);
  const numbers = new Int32Array(first).fill(-1);
  const positions: number[] = [];
  const corners = triangles.flatMap(({ part, at, first: before }) =>
    [0, 1, 2].map((k) => {
      const vertex = part.triangles[at + k]!;
      if (numbers[before + vertex]! < 0) {
        numbers[before + vertex] = positions.length / 3;
        for (let axis = 0; axis < 3; axis++) positions.push(part.positions[3 * vertex + axis]!);
      }
      return numbers[before + vertex]!;
    }),
  );
  const faces = triangles.map(({ face }) => face);
  return {
    positions: Float64Array.from(positions),
    triangles: Int32Array.from(corners),
    colors: colors && colorsAt(mesh, colors, positions, corners, faces),
    parts,
    partOf: partOf && faces.map((face) => partOf[face]!),
  };
}
