// The colors of the lines of the Paper page's figures.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inRoot, load } from './load.mjs';

/**
 * A color of six hexadecimal digits in OKLab, where distances correspond to visible differences.
 */
function oklab(hex) {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const value = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/**
 * Six times the smallest visible difference side by side: lines are thin, and far from their
 * legend.
 */
const leastApart = 6 * 0.02;

test('the colors of lines of one panel differ, in the light theme and in the dark one', async () => {
  const { figures } = await load('figures/index.ts');
  const { lineStyles } = await load('figures/lines.ts');
  const css = readFileSync(inRoot('web/paper/paper.css'), 'utf8');
  const colors = Object.fromEntries(
    [...css.matchAll(/(--line-[a-z-]+): light-dark\((#\w{6}), (#\w{6})\)/g)].map(
      ([, name, ...themes]) => [name, themes.map(oklab)],
    ),
  );
  for (const { id, panels } of figures) {
    for (const panel of panels) {
      // Exact paths share one color, and so do gradients and the descent along them.
      const names = [...new Set(panel.lines.map((line) => lineStyles[line].color))];
      for (const [i, name] of names.entries()) {
        for (const other of names.slice(0, i)) {
          for (const theme of [0, 1]) {
            const [a, b] = [colors[name][theme], colors[other][theme]];
            const apart = Math.hypot(...a.map((value, k) => value - b[k]));
            assert.ok(apart >= leastApart, `${id}/${panel.id}: ${name} and ${other}: ${apart}`);
          }
        }
      }
    }
  }
});
