// `npm run study`: builds and runs one of the studies of tests/bench, which measure accuracy, or times: native
// programs, and scripts that measure the package.
//
//   npm run study -- [--save] NAME [ARGUMENTS]      (the names without arguments)
//
// With --save what it prints is kept in docs/studies, where tests compare the docs with it.
//
// The studies read OBJ files. Files of other formats are read as the package reads them, and written as
// OBJ files in build/study.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, parse, resolve } from 'node:path';
import { buildFacade, buildNative, buildWasm } from './build.mjs';
import { saveStudy } from './saved_study.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, inRoot, run } from './shell.mjs';

const suffix = '_study';
const names = filesBelow('tests/bench', /_study\.cpp$/).map((file) =>
  basename(file, `${suffix}.cpp`),
);
const scripts = filesBelow('tests/bench', /_study\.mjs$/).map((file) =>
  basename(file, `${suffix}.mjs`),
);
const given = process.argv.slice(2);
const save = given[0] === '--save';
const [name, ...rest] = save ? given.slice(1) : given;

/** The OBJ file of a mesh file of another format. */
async function toObj(path) {
  const { load } = await import('karcher');
  const { meshFromFile } = await import('karcher/formats');
  const { mesh } = await meshFromFile(await load(), readFileSync(path), { name: basename(path) });
  const rowsOf = (values, letter, from) =>
    Array.from({ length: values.length / 3 }, (_, i) =>
      [letter, ...values.slice(3 * i, 3 * i + 3).map((value) => value + from)].join(' '),
    );
  const rows = [...rowsOf(mesh.positions(), 'v', 0), ...rowsOf(mesh.triangles(), 'f', 1)];
  mkdirSync(inRoot('build/study'), { recursive: true });
  const obj = inRoot(`build/study/${parse(path).name}.obj`);
  writeFileSync(obj, `${rows.join('\n')}\n`);
  return obj;
}

if (scripts.includes(name) && !save) {
  await setUp('build');
  await buildWasm();
  await buildFacade();
  await run(process.execPath, [inRoot(`tests/bench/${name}${suffix}.mjs`), ...rest]);
  process.exit();
}
if (!names.includes(name)) {
  console.error(
    `Usage: npm run study -- [--save] NAME [ARGUMENTS]; the studies: ${names.join(', ')}; not to be saved: ${scripts.join(', ')}`,
  );
  process.exit(name === undefined ? 0 : 1);
}
try {
  await setUp('build', 'native');
  await buildNative('native', name + suffix);
  const from = (path) => resolve(process.env.INIT_CWD ?? '.', path);
  const paths = rest.map((value) => (existsSync(from(value)) ? from(value) : value));
  const isOther = (path) => /\.(stl|ply|off|glb|gltf)$/i.test(path);
  if (paths.some(isOther)) {
    await buildWasm();
    await buildFacade();
  }
  const read = [];
  for (const path of paths) read.push(isOther(path) ? await toObj(path) : path);
  if (save) console.log(`Written to ${await saveStudy(name, read)}.`);
  else await run(inRoot(`build/native/tests/bench/${name}${suffix}`), read);
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
