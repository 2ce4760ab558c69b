// The first half hour of users, from the first look to the file that they save.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inLongRun, part } from './part.mjs';
import { badgeSitting, trimSitting } from './part_sittings.mjs';
import {
  figureSitting,
  posterSitting,
  scanSitting,
  seamSitting,
  sitDown,
  windows,
} from './sittings.mjs';

const cases = ['laptop', 'phone'].flatMap((size) => [
  { size, name: 'scan', sitting: scanSitting },
  { size, name: 'seam', sitting: seamSitting },
  { size, name: 'poster', sitting: posterSitting },
]);

for (const { size, name, sitting } of part(cases, 1)) {
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

inLongRun('the sitting with figure 4, on a laptop', async () => {
  const { browser, tab } = await sitDown(windows.laptop);
  try {
    await figureSitting(tab);
    assert.deepEqual(tab.logged, []);
  } finally {
    await browser.close();
  }
});

for (const size of ['laptop', 'desk', 'phone']) {
  inLongRun(
    `a trim line on a limb, in at most 15 clicks and drags, and a badge, on a ${size}`,
    async () => {
      for (const sitting of [trimSitting, badgeSitting]) {
        const { browser, tab } = await sitDown(windows[size]);
        try {
          const hands = await sitting(tab);
          if (hands) {
            assert.ok(hands <= 15, `${hands} clicks and drags`);
            console.log(`${hands} clicks and drags beside the line`);
          }
          assert.deepEqual(tab.logged, []);
        } finally {
          await browser.close();
        }
      }
    },
  );
}
