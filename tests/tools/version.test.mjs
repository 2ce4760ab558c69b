// package.json has the version. CMake reads it there; files that cannot read it have the same.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inRoot } from '../../.tools/shell.mjs';

const read = (path) => readFileSync(inRoot(path), 'utf8');
const { version } = JSON.parse(read('package.json'));

test('the lock file and the citation have the version of the package', () => {
  const lock = JSON.parse(read('package-lock.json'));
  assert.equal(lock.version, version);
  assert.equal(lock.packages[''].version, version);
  assert.equal(/^version: (.*)$/m.exec(read('CITATION.cff'))[1], version);
});

test('CMake has no version of its own', () => {
  assert.match(read('CMakeLists.txt'), /^project\(karcher VERSION \$\{KARCHER_VERSION\}/m);
});
