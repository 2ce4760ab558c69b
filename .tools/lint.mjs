// `npm run lint`: the benchmarks compiled without warnings, clang-tidy on the engine, biome and the
// TypeScript compiler on the rest.
import { buildNative } from './build.mjs';
import { setUp } from './setup.mjs';
import { closeWith, cores, filesBelow, inRoot, run, runStages } from './shell.mjs';

/** Checks files one by one, `cores` at a time, and names each that fails. */
async function clangTidy() {
  await run('cmake', ['--preset', 'clang']);
  const files = filesBelow('src', /\.cpp$/);
  const counts = { passed: 0, failed: 0 };
  const waiting = [...files];
  const worker = async () => {
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      try {
        await run('clang-tidy', ['--quiet', '-p', 'build/clang', file], { quiet: true });
        counts.passed += 1;
      } catch (error) {
        console.error(`${file}\n${error.output}${error.message}`);
        counts.failed += 1;
      }
    }
  };
  await Promise.all(Array.from({ length: cores }, worker));
  return counts;
}

const npmProgram = (path, ...args) =>
  run(process.execPath, [inRoot(`node_modules/${path}`), ...args]);

await setUp('build', 'test', 'lint');
closeWith(
  await runStages([
    { name: 'build of the benchmarks', run: () => buildNative('native') },
    { name: 'clang-tidy', run: clangTidy },
    {
      name: 'biome',
      run: () => npmProgram('@biomejs/biome/bin/biome', 'lint', '--error-on-warnings'),
    },
    { name: 'TypeScript', run: () => npmProgram('typescript/bin/tsc', '--noEmit') },
  ]),
);
