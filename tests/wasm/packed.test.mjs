// The packed file in a fresh folder, as a new user installs it: tests without other packages. `npm
// run check:packages` also tries bundlers.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { checkPackages } from '../../.tools/check_packages.mjs';
import { packageFolder } from '../../.tools/package.mjs';

test('the packed file works for a new user, and has no page and no book in it', async () => {
  const { files, rows } = await checkPackages({ short: true });
  assert.deepEqual(
    rows.filter(({ problem }) => problem),
    [],
  );
  assert.ok(rows.length >= 8);
  const allowed =
    /^(dist\/|(CHANGELOG|README|SECURITY)\.md$|CITATION\.cff$|LICENSE$|package\.json$)/;
  assert.deepEqual(
    files.filter((file) => !allowed.test(file) || /\.html$|\.(png|jpg)$/.test(file)),
    [],
  );
  // Every file that it names exists.
  const read = (file) => readFileSync(join(packageFolder, file), 'utf8');
  for (const file of files.filter((one) => one.endsWith('.md'))) {
    for (const [, link] of read(file).matchAll(/\]\((?!https?:)([^)#]*)/g)) {
      assert.ok(files.includes(link), `${file} links to ${link}`);
    }
  }
  assert.match(read('README.md'), /^npm install karcher$/m);
  assert.doesNotMatch(read('README.md'), /\{(book|editor)\}/);
  const own = JSON.parse(read('package.json'));
  assert.equal(own.private ?? own.scripts ?? own.devDependencies ?? own.workspaces, undefined);
  // A peer dependency that no file imports would only hinder an installation.
  const imported = new Set();
  for (const file of files.filter((one) => one.endsWith('.js'))) {
    for (const [, , name] of read(file).matchAll(/(from|import) '((?:@[\w-]+\/)?[a-z][\w-]*)/g)) {
      if (name !== 'node') imported.add(name);
    }
  }
  assert.deepEqual(Object.keys(own.peerDependencies), [...imported].sort());
});
