// `npm run bench`: the same benchmark in native code and in WebAssembly, a JSON object each.
//
//   npm run bench -- [MESH.obj --points FILE] [--samples N]     (the bunny of npm without a mesh)
import { writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildFacade, buildNative, buildWasm, writeBunny } from './build.mjs';
import { setUp } from './setup.mjs';
import { inRoot, run } from './shell.mjs';

const usage = 'Usage: npm run bench -- [MESH.obj --points FILE] [--samples N]';

/** Control points at vertices across the bunny's back, as a file of `face b1 b2` lines. */
async function writeBunnyPoints() {
  const { default: bunny } = await import('bunny');
  const lines = [561, 301, 1409, 108, 111, 701, 504, 615].map((vertex) => {
    const face = bunny.cells.findIndex((cell) => cell.includes(vertex));
    const corner = bunny.cells[face].indexOf(vertex);
    return `${face} ${Number(corner === 1)} ${Number(corner === 2)}`;
  });
  const path = inRoot('build/data/bunny_points.txt');
  writeFileSync(path, `${lines.join('\n')}\n`);
  return path;
}

function readArguments() {
  const options = { points: { type: 'string' }, samples: { type: 'string', default: '128' } };
  const { values, positionals } = parseArgs({ options, allowPositionals: true });
  const [mesh, ...more] = positionals;
  if (more.length > 0 || !mesh !== !values.points) throw new Error(usage);
  return { mesh, points: values.points, samples: values.samples };
}

try {
  const named = readArguments();
  await setUp('build', 'native');
  await writeBunny();
  const mesh = named.mesh ? resolve(named.mesh) : inRoot('build/data/bunny.obj');
  const points = named.points ? resolve(named.points) : await writeBunnyPoints();
  await buildNative('native', 'karcher_bench');
  await buildWasm();
  await buildFacade();
  const cli = [inRoot('dist/cli.js'), 'bench', mesh, '--points', points];
  const programs = {
    native: [inRoot('build/native/tests/bench/karcher_bench'), [mesh, points, named.samples]],
    WebAssembly: [process.execPath, [...cli, '--samples', named.samples]],
  };
  const times = [];
  for (const [name, [program, args]] of Object.entries(programs)) {
    const output = await run(program, args, { quiet: true });
    console.log(`\n${name}\n${output.trim()}`);
    times.push(JSON.parse(output));
  }
  const ratio = (part, key) => (times[1][part][key] / times[0][part][key]).toFixed(2);
  console.log(
    `\nWebAssembly against native: field ${ratio('karcher', 'fieldMs')}, sample ${ratio('karcher', 'sampleNs')}, drag ${ratio('karcher', 'dragMs')}, drag of ${times[1].steady.levels} levels ${ratio('steady', 'dragMs')}`,
  );
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
