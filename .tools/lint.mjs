// `npm run lint`: checks includes and imports against ARCHITECTURE.md and compiles the benchmarks
// without warnings. It runs clang-tidy on the engine and its bindings, and biome and the TypeScript
// compiler on the rest.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { buildNative, configureWasm } from './build.mjs';
import { checkRooms } from './rooms.mjs';
import { setUp } from './setup.mjs';
import { closeWith, countAll, inRoot, run, runStages } from './shell.mjs';

/**
 * Writes the compile commands of the bindings to build/clang-wasm, in clang's form, since
 * clang-tidy does not know the options that Emscripten's compiler adds.
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

/** The compile commands of each source file of the engine and of the bindings, in clang's form. */
async function readCommands() {
  await run('cmake', ['--preset', 'clang'], { quiet: true });
  await writeWasmCommands();
  const from = (path, folder) =>
    JSON.parse(readFileSync(inRoot(path), 'utf8')).filter(
      ({ file }) => file.startsWith(inRoot(folder)) && file.endsWith('.cpp'),
    );
  return [
    ...from('build/clang/compile_commands.json', 'src/'),
    ...from('build/clang-wasm/lint/compile_commands.json', 'wasm/'),
  ];
}

/** Runs a program on a file, which counts as one check, and prints its findings. */
async function checkFile(file, program, args, options = {}) {
  try {
    await run(program, args, { ...options, quiet: true });
    return { passed: 1, failed: 0 };
  } catch (error) {
    console.error(`${file}\n${error.output}${error.message}`);
    return { passed: 0, failed: 1 };
  }
}

/**
 * Compiles each file of the bindings separately, without precompiled headers, to detect missing
 * includes. For `npm test`, clang compiles the engine's files in this way, with the sanitizers.
 */
async function compileAlone() {
  const bindings = (await readCommands()).filter(({ file }) => file.startsWith(inRoot('wasm/')));
  return countAll(bindings, ({ file, command, directory }) => {
    const alone = `${command.replace(/ -o \S+/, '')} -fsyntax-only`;
    return checkFile(file, 'sh', ['-c', `cd '${directory}' && exec ${alone}`]);
  });
}

/** The names that a source file declares at the start of a line. */
function namesOf(file) {
  const text = readFileSync(file, 'utf8');
  const declared = [
    /^[A-Za-z[].*?(?<!::)\b(\w+)\(/gm,
    /^(?:inline )?(?:constexpr|const) .*?\b(\w+)\b ?[={[]/gm,
    /^(?:struct|class|enum class|enum|using) (\w+)/gm,
  ];
  return declared.flatMap((pattern) => [...text.matchAll(pattern)].map(([, name]) => name));
}

const mostInBatch = 12;

/** Batches of a dozen files from one folder. No two files of a batch declare the same name. */
function batchesOf(commands) {
  const batches = [];
  for (const entry of commands) {
    const folder = dirname(entry.file);
    const names = namesOf(entry.file);
    const fits = (batch) =>
      batch.folder === folder &&
      batch.entries.length < mostInBatch &&
      !names.some((name) => batch.names.has(name));
    let batch = batches.find(fits);
    if (!batch) {
      batch = { folder, entries: [], names: new Set() };
      batches.push(batch);
    }
    batch.entries.push(entry);
    for (const name of names) batch.names.add(name);
  }
  return batches;
}

/**
 * Runs clang-tidy on the files, a batch at a time, since most of its time goes into the headers
 * that all files include. If a batch fails, its files are checked one by one, and these checks
 * count.
 */
async function clangTidy() {
  const folder = inRoot('build/clang-tidy');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const batches = batchesOf(await readCommands()).map(({ entries }, i) => {
    const file = `${folder}/batch_${i}.cpp`;
    writeFileSync(file, entries.map((entry) => `#include "${entry.file}"\n`).join(''));
    const [{ file: first, directory, command }] = entries;
    return { entries, file, directory, command: command.replace(` -c ${first}`, ` -c ${file}`) };
  });
  const commands = batches.flatMap(({ entries, file, directory, command }) => [
    ...entries,
    { file, directory, command },
  ]);
  writeFileSync(`${folder}/compile_commands.json`, JSON.stringify(commands));
  const tidy = ['--quiet', '-p', folder];
  return countAll(batches, async ({ file, entries }) => {
    try {
      await run('clang-tidy', [...tidy, file], { quiet: true });
      return { passed: entries.length, failed: 0 };
    } catch {
      return countAll(entries, (entry) =>
        checkFile(entry.file, 'clang-tidy', [...tidy, entry.file]),
      );
    }
  });
}

const npmProgram = (path, ...args) =>
  run(process.execPath, [inRoot(`node_modules/${path}`), ...args]);

await setUp('build', 'lint');
closeWith(
  await runStages([
    { name: 'rooms', run: checkRooms },
    { name: 'build of the benchmarks', run: () => buildNative('native') },
    { name: 'each file of the bindings compiled on its own', run: compileAlone },
    { name: 'clang-tidy', run: clangTidy },
    {
      name: 'biome',
      run: () => npmProgram('@biomejs/biome/bin/biome', 'lint', '--error-on-warnings'),
    },
    { name: 'TypeScript', run: () => npmProgram('typescript/bin/tsc', '--noEmit') },
  ]),
);
