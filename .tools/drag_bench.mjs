// `npm run bench -- drag`: steps of a drag in native code and in WebAssembly, as a table.
//
//   npm run bench -- drag [MESH.obj] [--points FILE …]
//
// Without points it draws polygons with legs of .05 to .3 of the mesh's diagonal. Without a mesh it takes the
// bunny of npm.
import { mkdirSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { inRoot, run } from './shell.mjs';

const spacings = ['.05', '.1', '.2', '.3'];
/** Native code and WebAssembly take turns, so that other work of the computer affects both. */
const rounds = 3;
const native = inRoot('build/native/tests/bench/drag_bench');

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** The medians of both programs, whose curves must be the same. */
async function timeDrag(mesh, plan, levels) {
  const programs = {
    native: [native, ['run', mesh, plan, levels === 'auto' ? '-1' : levels]],
    wasm: [process.execPath, [inRoot('tests/bench/drag_bench.mjs'), mesh, plan, levels]],
  };
  const times = { native: [], wasm: [] };
  for (let i = 0; i < rounds; i++) {
    for (const [name, [program, args]] of Object.entries(programs))
      times[name].push(JSON.parse(await run(program, args, { quiet: true })));
  }
  const of = (name, key) => median(times[name].map((time) => time[key]));
  if (Math.abs(of('wasm', 'length') / of('native', 'length') - 1) > 1e-6)
    throw new Error(`${basename(mesh)}: native code and WebAssembly draw different curves`);
  return {
    levels: of('native', 'levels'),
    native: of('native', 'stepMs'),
    wasm: of('wasm', 'stepMs'),
    first: of('wasm', 'firstMs'),
  };
}

/**
 * Prints a row for each polygon, at the levels of 'auto' and at level 0. Both programs must have
 * been built.
 */
export async function benchDrags(mesh, points) {
  mkdirSync(inRoot('build/bench'), { recursive: true });
  const plan = inRoot('build/bench/drag.txt');
  const ratios = [];
  console.log(`
Milliseconds of the processor a step of a drag of ${basename(mesh)}; first: of the first five in WebAssembly.

| points | levels | native | WebAssembly | ratio | first |
| --- | --- | --- | --- | --- | --- |`);
  for (const polygon of points.length > 0 ? points : spacings) {
    writeFileSync(plan, await run(native, ['plan', mesh, polygon], { quiet: true }));
    for (const choice of ['auto', '0']) {
      const { levels, ...times } = await timeDrag(mesh, plan, choice);
      const ratio = times.wasm / times.native;
      ratios.push(ratio);
      const [inNative, inWasm, first] = [times.native, times.wasm, times.first].map((ms) =>
        ms.toFixed(3),
      );
      console.log(
        `| ${basename(polygon, '.txt')} | ${levels} | ${inNative} | ${inWasm} | ${ratio.toFixed(2)} | ${first} |`,
      );
    }
  }
  console.log(
    `\nratio: median ${median(ratios).toFixed(2)}, most ${Math.max(...ratios).toFixed(2)}`,
  );
}
