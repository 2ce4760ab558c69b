// Random cuts of meshes of files, along closed curves and curves from rim to rim, with the faults of their parts
// and of the parts' files.
//
//   npm run study -- cuts [--count N] [--seed S] MESH…
//
// The study makes N cuts in all, 200 by default, on the meshes in turn. A fault names its seed, which repeats the cut
// with --count 1 on its mesh.
import { readFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { load } from 'karcher';
import { meshFromFile } from 'karcher/formats';
import { checkedFiles, checkedParts, surfaceOf } from '../wasm/cut_checks.mjs';
import { randomCut, rimVertices } from '../wasm/random_cuts.mjs';

const { values, positionals } = parseArgs({
  options: {
    count: { type: 'string', default: '200' },
    seed: { type: 'string', default: '1' },
  },
  allowPositionals: true,
});
if (positionals.length === 0) {
  console.error('Usage: npm run study -- cuts [--count N] [--seed S] MESH…');
  process.exit(1);
}
const karcher = await load();
const row = (...cells) => console.log(`| ${cells.join(' | ')} |`);
const short = (value) => value.toPrecision(2);
const total = { cuts: 0, faults: 0, parts: 0, files: 0 };

row(
  'mesh',
  'triangles',
  'cuts',
  'curves',
  'parts',
  'slits',
  'files',
  'areas off by',
  'least height',
  'before',
  'faults',
);
row(...Array(11).fill('---'));
for (const [place, path] of positionals.entries()) {
  const name = resolve(process.env.INIT_CWD ?? '.', path);
  const { mesh } = await meshFromFile(karcher, readFileSync(name), { name, repair: 'safe' });
  const surface = surfaceOf(mesh);
  const whole = checkedParts(surface.whole, surface);
  const rim = rimVertices(mesh);
  const sum = {
    cuts: 0,
    curves: 0,
    parts: 0,
    slits: 0,
    files: 0,
    area: 0,
    height: Number.POSITIVE_INFINITY,
  };
  const faults = [];
  for (let i = place; i < Number(values.count); i += positionals.length) {
    const seed = Number(values.seed) + i;
    const told = (fault) => `seed ${seed}: ${fault}`;
    try {
      const paths = randomCut(mesh, rim, seed);
      const parts = mesh.cut(paths);
      const found = checkedParts(parts, surface);
      const files = await checkedFiles(karcher, parts, surface);
      faults.push(...[...found.faults, ...files.faults].map(told));
      sum.curves += paths.length;
      sum.parts += parts.length;
      sum.slits += files.slits;
      sum.files += files.files;
      sum.area = Math.max(sum.area, found.areaError);
      sum.height = Math.min(sum.height, found.height);
    } catch (error) {
      faults.push(told(error.message));
    }
    sum.cuts++;
  }
  row(
    basename(path),
    mesh.info.triangles,
    sum.cuts,
    sum.curves,
    sum.parts,
    sum.slits,
    sum.files,
    short(sum.area),
    short(sum.height),
    short(whole.height),
    faults.length,
  );
  for (const fault of faults) console.log(`  ${fault}`);
  total.cuts += sum.cuts;
  total.parts += sum.parts;
  total.files += sum.files;
  total.faults += faults.length;
  mesh.dispose();
}
console.log(
  `${total.cuts} cuts, ${total.parts} parts, ${total.files} files, ${total.faults} faults`,
);
process.exitCode = total.faults > 0 ? 1 : 0;
