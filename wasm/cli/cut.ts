import { writeFile } from 'node:fs/promises';
import { solidOf, thickened } from '../checkup/index.js';
import {
  curvesOnPart,
  marksOfPart,
  meshFile,
  type WrittenFormat,
  writtenFormats,
} from '../formats/index.js';
import type { Arguments } from './arguments.js';
import type { Command } from './command.js';
import { UsageError, writeError } from './errors.js';
import { outlineOptions, readOutlines } from './outlines.js';

export const cut: Command = {
  name: 'cut',
  call: "mesh.cut(paths), and thickened of 'karcher/checkup'",
  summary: 'the mesh cut along curves, with a file for each part',
  output:
    '{parts: [{file, triangles, area, oriented, closed, volume, allowed}, …]}, the largest first; volume is null for a part that is not closed. On both sides of a cut positions are equal to the last bit; the parts keep colors and parts of the mesh’s file',
  options: [
    ...outlineOptions,
    {
      name: 'out',
      value: 'FILE',
      help: `the files for the parts: leg.stl gives leg_0.stl, leg_1.stl, …; ${writtenFormats.join(', ')}`,
      // The default is a description for the help; no such value exists.
      default: 'nowhere',
    },
    {
      name: 'with-curves',
      help: 'writes the pieces of the curves that border each part as lines of its file, except STL',
    },
    {
      name: 'thickness',
      value: 'T',
      help: 'makes each part a closed shell, outwards, or inwards with a negative thickness; allowed is the thickness that its shape allows, if that is less',
    },
  ],
  async run(args) {
    const name = args.given('out') ? partNames(args) : null;
    const thickness = args.given('thickness') ? args.number('thickness') : null;
    const lines = args.given('with-curves');
    if (lines && (!name || name.format === 'stl')) {
      throw new UsageError('--with-curves needs --out with a file of PLY, OBJ or GLB');
    }
    const { mesh, file: marks, outlines } = await readOutlines(args);
    const drawn = outlines.map((path, i) => ({ name: `curve ${i + 1}`, path }));
    const whole = { positions: mesh.positions(), triangles: mesh.triangles() };
    const parts = mesh
      .cut(outlines)
      .map((cut) => {
        const thick = thickness === null ? null : thickened(cut, thickness, whole);
        const sheets = thick ? 2 : 1;
        const curves = lines && { curves: curvesOnPart(cut, whole, drawn) };
        const said = { ...marksOfPart(cut, whole, marks, { sheets }), ...curves };
        const part = { ...(thick ?? cut), ...said };
        return { part, ...(thick?.most && { allowed: thick.most }), ...solidOf(part) };
      })
      .sort((a, b) => b.area - a.area);
    const told: object[] = [];
    for (const [i, { part, ...solid }] of parts.entries()) {
      const file = name?.of(i);
      if (file !== undefined) await write(file, meshFile(part, name!.format));
      told.push({ file, triangles: part.triangles.length / 3, ...solid });
    }
    return { json: { parts: told } };
  },
};

function partNames(args: Arguments): { of: (part: number) => string; format: WrittenFormat } {
  const path = args.text('out');
  const [, stem, ending] = /^(.*[^/\\])\.([^./\\]+)$/.exec(path) ?? [];
  const format = writtenFormats.find((candidate) => candidate === ending?.toLowerCase());
  if (format === undefined) {
    throw new UsageError(
      `--out of cut must end in .${writtenFormats.join(', .')}, such as leg.stl, not '${path}'`,
    );
  }
  return { of: (part) => `${stem}_${part}.${ending}`, format };
}

async function write(path: string, bytes: Uint8Array): Promise<void> {
  try {
    await writeFile(path, bytes);
  } catch (cause) {
    throw writeError(path, cause);
  }
}
