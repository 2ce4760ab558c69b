// Formats every source file, or with --check lists those that are not formatted.
import { setUp } from './setup.mjs';
import { filesBelow, inRoot, run } from './shell.mjs';

const check = process.argv.includes('--check');
await setUp('format');
const sources = ['src', 'wasm', 'tests'].flatMap((folder) => filesBelow(folder, /\.(h|cpp)$/));
const mode = check ? ['--dry-run', '-Werror'] : ['-i'];
try {
  await run('clang-format', [...mode, ...sources]);
  const biome = inRoot('node_modules/@biomejs/biome/bin/biome');
  await run(process.execPath, [biome, 'format', ...(check ? [] : ['--write'])]);
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
