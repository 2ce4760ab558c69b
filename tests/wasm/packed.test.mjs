// The packed file in a fresh folder, as a new user has it: what needs no other package. `npm run check:packages`
// tries bundlers, too.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { checkPackages } from '../../.tools/check_packages.mjs';

test('the packed file works for a new user, and has no page and no book in it', async () => {
  const { files, rows } = await checkPackages({ short: true });
  assert.deepEqual(
    rows.filter(({ problem }) => problem),
    [],
  );
  assert.ok(rows.length >= 8);
  const allowed = /^(dist\/|(CHANGELOG|README)\.md$|CITATION\.cff$|LICENSE$|package\.json$)/;
  assert.deepEqual(
    files.filter((file) => !allowed.test(file) || /\.html$|\.(png|jpg)$/.test(file)),
    [],
  );
});
