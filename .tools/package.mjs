// The published package: a folder with the files that package.json names, a separate README, and
// the addresses of .tools/addresses.json, which the publisher fills in.
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { inRoot } from './shell.mjs';

/** The folder of the published package. */
export const packageFolder = inRoot('build/package');

const read = (path) => readFileSync(inRoot(path), 'utf8');

export const addresses = () => JSON.parse(read('.tools/addresses.json'));

/** The published package.json, with what a user of the package needs. */
function manifest({ repository, issues, book }) {
  const {
    private: _,
    workspaces,
    scripts,
    devDependencies,
    ...own
  } = JSON.parse(read('package.json'));
  if (repository) own.repository = { type: 'git', url: repository };
  if (issues) own.bugs = { url: issues };
  if (book) own.homepage = book;
  return own;
}

/** Copies the package's files, as built in dist/, to `packageFolder`. */
export function layPackage() {
  const known = addresses();
  const { files } = JSON.parse(read('package.json'));
  rmSync(packageFolder, { recursive: true, force: true });
  mkdirSync(packageFolder, { recursive: true });
  for (const name of [...files, 'LICENSE']) {
    cpSync(inRoot(name), `${packageFolder}/${name}`, { recursive: true });
  }
  const linked = (name) => (known[name] ? `[${name}](${known[name]})` : name);
  const write = (name, text) => writeFileSync(`${packageFolder}/${name}`, text);
  write(
    'README.md',
    read('docs/package-readme.md')
      .replace('{book}', linked('book'))
      .replace('{editor}', linked('editor')),
  );
  if (known.security) {
    const form = 'the form for security advisories of the repository';
    write('SECURITY.md', read('SECURITY.md').replace(form, `[${form}](${known.security})`));
  }
  if (known.repository) {
    write('CITATION.cff', `${read('CITATION.cff')}repository-code: ${known.repository}\n`);
  }
  write('package.json', `${JSON.stringify(manifest(known), null, 2)}\n`);
}
