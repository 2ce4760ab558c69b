// `npm run study`: builds and runs one of the studies of tests/bench, which measure accuracy or times. They are
// native programs, and scripts that measure the package.
//
//   npm run study -- [--save] NAME [ARGUMENTS]      (without arguments it prints the names)
//   npm run study -- --again [--meshes FOLDER] [NAME …]
//
// --save saves the output in docs/studies, and updates the tables of docs that quote it; tests compare both.
// --again runs all studies saved there, or those of these names, and saves them again, if the meshes that they
// read are in the folder.
//
// The studies read OBJ files. The package reads files of other formats, which are then written as OBJ files to
// build/study.
import { existsSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildFacade, buildNative, buildWasm } from './build.mjs';
import { quoteStudies } from './quoted_tables.mjs';
import { found, isMeshFile, runStudy, savedStudies, saveStudy } from './saved_study.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, inRoot, run } from './shell.mjs';

const suffix = '_study';
const names = filesBelow('tests/bench', /_study\.cpp$/).map((file) =>
  basename(file, `${suffix}.cpp`),
);
/** The studies that are scripts, whose output is not saved. */
const scripts = filesBelow('tests/bench', /_study\.mjs$/).map((file) =>
  basename(file, `${suffix}.mjs`),
);
const usage = `Usage: npm run study -- [--save] NAME [ARGUMENTS], or --again [--meshes FOLDER] [NAME …]\nThe studies: ${names.join(', ')}.\nScripts, whose output cannot be saved: ${scripts.join(', ')}.`;
const given = process.argv.slice(2);
const from = (path) => resolve(process.env.INIT_CWD ?? '.', path);

async function build(studies, args) {
  await setUp('build', 'native');
  for (const name of new Set(studies)) await buildNative('native', name + suffix);
  if (!args.some((path) => isMeshFile(path) && !/\.obj$/i.test(path))) return;
  await buildWasm();
  await buildFacade();
}

const printQuoted = () => {
  const docs = quoteStudies();
  if (docs.length > 0) console.log(`Updated tables: ${docs.join(', ')}.`);
};

async function one([name, ...rest], save) {
  if (scripts.includes(name) && !save) {
    await setUp('build');
    await buildWasm();
    await buildFacade();
    await run(process.execPath, [inRoot(`tests/bench/${name}${suffix}.mjs`), ...rest]);
    return;
  }
  if (!names.includes(name)) {
    console.error(usage);
    process.exit(name === undefined ? 0 : 1);
  }
  const paths = rest.map((value) => (existsSync(from(value)) ? from(value) : value));
  await build([name], paths);
  if (!save) {
    await runStudy(name, paths);
    return;
  }
  console.log(`Written to ${await saveStudy(name, paths)}.`);
  printQuoted();
}

async function again(args) {
  const known = { meshes: { type: 'string' } };
  const { values, positionals } = parseArgs({ args, options: known, allowPositionals: true });
  const folder = values.meshes && from(values.meshes);
  const chosen = savedStudies().filter(
    ({ study }) => positionals.length === 0 || positionals.includes(study),
  );
  await build(
    chosen.map(({ study }) => study),
    folder ? chosen.flatMap((one) => one.arguments) : [],
  );
  for (const { study, arguments: saved } of chosen) {
    const { args: paths, missing } = found(saved, folder);
    if (missing.length > 0) console.log(`${study} does not run: it needs ${missing.join(', ')}.`);
    else console.log(`Written to ${await saveStudy(study, paths)}.`);
  }
  printQuoted();
}

try {
  if (given[0] === '--again') await again(given.slice(1));
  else await one(given[0] === '--save' ? given.slice(1) : given, given[0] === '--save');
} catch (error) {
  console.error(error.code?.startsWith('ERR_PARSE_ARGS') ? usage : error.message);
  process.exit(1);
}
