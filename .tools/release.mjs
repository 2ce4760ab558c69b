// `npm run release`: builds and packs the files for publishing, installs the packed file into empty
// folders, tries it there, and prints its content and the missing addresses. It publishes nothing.
import { readFileSync } from 'node:fs';
import { checkPackages } from './check_packages.mjs';
import { addresses, packageFolder } from './package.mjs';
import { inRoot } from './shell.mjs';

const { version } = JSON.parse(readFileSync(inRoot('package.json'), 'utf8'));
const { name, bytes, files, rows } = await checkPackages({ short: true });

console.log(`\n${name}, ${files.length} files, ${bytes} bytes packed:\n`);
const counts = new Map();
for (const file of files) {
  const part = file.replace(/^(dist\/[^/]+)\/.*/, '$1/…').replace(/^dist\/[^/]+\.\w+$/, 'dist/…');
  counts.set(part, (counts.get(part) ?? 0) + 1);
}
for (const [part, count] of counts) console.log(`  ${`${count}`.padStart(4)}  ${part}`);

console.log('\nAs a new user:\n');
for (const row of rows) console.log(`  ${row.problem ? 'no ' : 'yes'}  ${row.name}`);

const missing = Object.entries(addresses())
  .filter(([, address]) => !address)
  .map(([what]) => `.tools/addresses.json has no address of: ${what}.`);
if (!readFileSync(inRoot('CHANGELOG.md'), 'utf8').includes(`\n## ${version}`)) {
  missing.push(`CHANGELOG.md has no section ${version}: rename the section Unreleased.`);
}
console.log(`\n${missing.length === 0 ? 'Nothing is missing.' : 'Missing:'}\n`);
for (const one of missing) console.log(`  ${one}`);

const failed = rows.filter(({ problem }) => problem);
for (const row of failed) console.log(`\n${row.name}: ${row.problem.slice(0, 2000)}`);
if (failed.length > 0) process.exit(1);
console.log(`\nNothing was published. To publish: npm publish ${packageFolder}`);
