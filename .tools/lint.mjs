// `npm run lint`: includes and imports against ARCHITECTURE.md, the benchmarks compiled without
// warnings, clang-tidy on the engine and its bindings, biome and the TypeScript compiler on the rest.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { buildNative, configureWasm } from './build.mjs';
import { checkRooms } from './rooms.mjs';
import { setUp } from './setup.mjs';
import { closeWith, cores, filesBelow, inRoot, run, runStages } from './shell.mjs';

/**
 * Writes how the bindings are compiled to build/clang-wasm, in clang's words: clang-tidy does not know
 * what Emscripten's compiler adds to them.
 */
async function writeWasmCommands() {
  await configureWasm('-B', inRoot('build/clang-wasm'), '-DKARCHER_PRECOMPILE=OFF');
  const flags = (await run('em++', ['--cflags'], { quiet: true })).trim().split('\n').at(-1);
  const path = inRoot('build/clang-wasm/compile_commands.json');
  const commands = JSON.parse(readFileSync(path, 'utf8')).map(({ command, ...rest }) => {
    const inClangsWords = command.replace(/^.*?\bem\+\+\S*/, `clang++ ${flags}`);
    if (inClangsWords === command) throw new Error(`no em++ compiles ${rest.file}: ${command}`);
    return { ...rest, command: inClangsWords };
  });
  mkdirSync(inRoot('build/clang-wasm/lint'), { recursive: true });
  writeFileSync(inRoot('build/clang-wasm/lint/compile_commands.json'), JSON.stringify(commands));
}

/** Checks files one by one, `cores` at a time, and names each that fails. */
async function clangTidy() {
  await run('cmake', ['--preset', 'clang']);
  await writeWasmCommands();
  const counts = { passed: 0, failed: 0 };
  const waiting = [
    ...filesBelow('src', /\.cpp$/).map((file) => ({ file, commands: 'build/clang' })),
    ...filesBelow('wasm', /\.cpp$/).map((file) => ({ file, commands: 'build/clang-wasm/lint' })),
  ];
  const worker = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      const { file, commands } = next;
      try {
        await run('clang-tidy', ['--quiet', '-p', commands, file], { quiet: true });
        counts.passed += 1;
      } catch (error) {
        console.error(`${file}\n${error.output}${error.message}`);
        counts.failed += 1;
      }
      const done = counts.passed + counts.failed;
      if (done % 5 === 0) console.log(`${done} of ${done + waiting.length} files or more`);
    }
  };
  await Promise.all(Array.from({ length: cores }, worker));
  return counts;
}

const npmProgram = (path, ...args) =>
  run(process.execPath, [inRoot(`node_modules/${path}`), ...args]);

await setUp('build', 'lint');
closeWith(
  await runStages([
    { name: 'rooms', run: checkRooms },
    { name: 'build of the benchmarks', run: () => buildNative('native') },
    { name: 'clang-tidy', run: clangTidy },
    {
      name: 'biome',
      run: () => npmProgram('@biomejs/biome/bin/biome', 'lint', '--error-on-warnings'),
    },
    { name: 'TypeScript', run: () => npmProgram('typescript/bin/tsc', '--noEmit') },
  ]),
);
