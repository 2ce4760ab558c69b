// What two people do in their first half hour, from the first look to the file that they take away.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { scanSitting, seamSitting, sitDown, windows } from './sittings.mjs';

for (const size of ['laptop', 'phone']) {
  for (const [name, sitting] of Object.entries({ scan: scanSitting, seam: seamSitting })) {
    test(`the sitting with a ${name}, on a ${size}`, async () => {
      const { browser, tab } = await sitDown(windows[size]);
      try {
        await sitting(tab);
        assert.deepEqual(tab.logged, []);
      } finally {
        await browser.close();
      }
    });
  }
}
