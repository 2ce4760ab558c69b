// `npm run check:packages`: packs the files for publishing, installs the package into fresh folders
// as a new user would, tries it there and prints a table. With --short it runs only the trials that
// need no other package, as `npm test` does. With words it runs only those whose names contain one.
//
// tests/tools/cpp_users.test.mjs, which runs with these trials, tries CMake projects of users.
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildNative } from './build.mjs';
import { layPackage, packageFolder } from './package.mjs';
import { attempt, run, trials } from './package_trials.mjs';
import { inRoot, root } from './shell.mjs';

/** The files for publishing, and the outcome of each trial: `problem` is empty if it passed. */
export async function checkPackages({ short = false, words = [] } = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'karcher packages '));
  try {
    layPackage();
    const args = [
      'pack',
      '--ignore-scripts',
      '--json',
      '--pack-destination',
      folder,
      packageFolder,
    ];
    const [packed] = JSON.parse(run(folder, 'npm', ...args));
    const rows = [];
    for (const trial of trials) {
      if (short && trial.packages) continue;
      if (words.length > 0 && !words.some((word) => trial.name.includes(word))) continue;
      const own = join(folder, `user-${rows.length}`);
      mkdirSync(own);
      try {
        await attempt(trial, own, join(folder, packed.filename));
        rows.push({ name: trial.name, problem: '' });
      } catch ({ message }) {
        rows.push({ name: trial.name, problem: message });
      }
    }
    const files = packed.files.map(({ path }) => path);
    return { name: packed.id, bytes: packed.size, files, rows };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** Tries projects of C++ users, with Karcher as a folder, fetched and installed. */
async function checkProjects() {
  try {
    await buildNative('native', 'karcher');
    run(root, process.execPath, '--test', inRoot('tests/tools/cpp_users.test.mjs'));
    return '';
  } catch ({ message }) {
    return message;
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const words = process.argv.slice(2).filter((word) => !word.startsWith('-'));
  const short = process.argv.includes('--short');
  const { name, bytes, files, rows } = await checkPackages({ short, words });
  if (!short && words.length === 0) {
    rows.push({
      name: 'CMake by folder, FetchContent and find_package',
      problem: await checkProjects(),
    });
  }
  console.log(`${name}: ${files.length} files, ${bytes} bytes packed. As a new user:\n`);
  for (const row of rows) console.log(`  ${row.problem ? 'no ' : 'yes'}  ${row.name}`);
  const failed = rows.filter(({ problem }) => problem);
  for (const row of failed) console.log(`\n${row.name}: ${row.problem.slice(0, 2000)}`);
  process.exit(failed.length > 0 ? 1 : 0);
}
