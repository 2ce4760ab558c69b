// `npm run study`: builds and runs one of the native studies of tests/bench, which measure accuracy, or
// times.
//
//   npm run study -- NAME [ARGUMENTS]      (the names without arguments)
import { existsSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { buildNative } from './build.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, inRoot, run } from './shell.mjs';

const suffix = '_study';
const names = filesBelow('tests/bench', /_study\.cpp$/).map((file) =>
  basename(file, `${suffix}.cpp`),
);
const [name, ...rest] = process.argv.slice(2);

if (!names.includes(name)) {
  console.error(`Usage: npm run study -- NAME [ARGUMENTS]; the studies: ${names.join(', ')}`);
  process.exit(name === undefined ? 0 : 1);
}
try {
  await setUp('build', 'native');
  await buildNative('native', name + suffix);
  const from = (path) => resolve(process.env.INIT_CWD ?? '.', path);
  const paths = rest.map((value) => (existsSync(from(value)) ? from(value) : value));
  await run(inRoot(`build/native/tests/bench/${name}${suffix}`), paths);
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
