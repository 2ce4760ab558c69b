// `npm run bench`: the same benchmark in native code and in WebAssembly, with a JSON object for each.
//
//   npm run bench -- [MESH.obj --points FILE] [--samples N]     (the bunny of npm without a mesh)
//   npm run bench -- drag [MESH.obj] [--points FILE …]          (steps of drags: drag_bench.mjs)
//   npm run bench -- large [MESH.obj] [--refinements N]         (edits on a mesh refined by subdivision, native)
import { writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildFacade, buildNative, buildWasm, writeBunny } from './build.mjs';
import { benchDrags } from './drag_bench.mjs';
import { setUp } from './setup.mjs';
import { inRoot, run } from './shell.mjs';

const usage = `Usage: npm run bench -- [MESH.obj --points FILE] [--samples N]
       npm run bench -- drag [MESH.obj] [--points FILE …]
       npm run bench -- large [MESH.obj] [--refinements N]      N from 3 to 6, 4 by default`;

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
  const options = {
    points: { type: 'string', multiple: true, default: [] },
    samples: { type: 'string', default: '128' },
    refinements: { type: 'string', default: '4' },
  };
  const { values, positionals } = parseArgs({ options, allowPositionals: true });
  const kind = ['drag', 'large'].find((name) => name === positionals[0]) ?? 'both';
  const [mesh, ...more] = kind === 'both' ? positionals : positionals.slice(1);
  const { points, ...rest } = values;
  const fits = {
    both: points.length === (mesh ? 1 : 0),
    drag: mesh || points.length === 0,
    large: points.length === 0,
  };
  if (more.length > 0 || !fits[kind]) throw new Error(usage);
  return { kind, mesh, points: points.map((path) => resolve(path)), ...rest };
}

/** Prints the timings of both programs, and their ratios. */
async function benchSteps(mesh, points, samples) {
  const cli = [inRoot('dist/cli.js'), 'bench', mesh, '--points', points];
  const programs = {
    native: [inRoot('build/native/tests/bench/karcher_bench'), [mesh, points, samples]],
    WebAssembly: [process.execPath, [...cli, '--samples', samples]],
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
}

const programOf = { both: 'karcher_bench', drag: 'drag_bench', large: 'large_bench' };

try {
  const { kind, samples, refinements, ...named } = readArguments();
  await setUp('build', 'native');
  await writeBunny();
  const mesh = named.mesh ? resolve(named.mesh) : inRoot('build/data/bunny.obj');
  await buildNative('native', programOf[kind]);
  if (kind === 'large') {
    await run(inRoot('build/native/tests/bench/large_bench'), [mesh, refinements]);
  } else {
    await buildWasm();
    await buildFacade();
    if (kind === 'drag') await benchDrags(mesh, named.points);
    else await benchSteps(mesh, named.points[0] ?? (await writeBunnyPoints()), samples);
  }
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
