// `npm run pictures`: replays the sittings of new users (tests/web/sittings.mjs, part_sittings.mjs) in
// every size of window, light and dark. It writes a picture of each step to build/pictures/, for a
// person to look at.
//
//   npm run pictures -- [--size laptop|desk|phone] [--theme light|dark]
//     [--sitting scan|seam|poster|trim|badge] [--save] [--built]
//
// --size, --theme and --sitting choose one of each. --save writes only the README's picture,
// docs/drawing.jpg. --built uses build/page without a build.
import { mkdirSync, statSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { buildFacade, buildPage, buildWasm } from './build.mjs';
import { chromiumPath, setUp } from './setup.mjs';
import { inRoot } from './shell.mjs';

const usage =
  'Usage: npm run pictures -- [--size laptop|desk|phone] [--theme light|dark]' +
  ' [--sitting scan|seam|poster|trim|badge] [--save] [--built]';
const themes = ['light', 'dark'];
/** The largest size of the README's picture, in bytes. */
const mostBytes = 300_000;

/** The names chosen by an option; all without it. */
function chosen(name, value, names) {
  if (value === undefined) return names;
  if (names.includes(value)) return [value];
  throw new Error(`--${name} must be one of ${names.join(', ')}, not '${value}'.\n${usage}`);
}

/** Replays one sitting and takes a picture of the window after each step. */
async function replay({ sitDown }, sitting, viewport, theme, path) {
  const { browser, tab } = await sitDown(viewport, { colorScheme: theme, asUsers: true });
  let count = 0;
  try {
    await sitting(tab, async (step) => {
      await tab.still();
      count++;
      await tab.page.screenshot({ path: `${path}-${count}-${step.replaceAll(' ', '-')}.png` });
    });
  } finally {
    await browser.close();
  }
  return count;
}

/** Saves the drawing with which the page opens, without the page around it. */
async function savePicture({ sitDown }) {
  const { browser, tab } = await sitDown({ width: 1180, height: 700 }, { asUsers: true });
  const path = inRoot('docs/drawing.jpg');
  try {
    const { page } = tab;
    await page.locator('#tour-skip').click();
    await page.mouse.move(0, 0);
    await tab.still();
    await page.screenshot({ path, type: 'jpeg', quality: 90 });
  } finally {
    await browser.close();
  }
  const { size } = statSync(path);
  if (size > mostBytes) throw new Error(`docs/drawing.jpg has ${size} bytes, over ${mostBytes}.`);
  console.log(`Written to docs/drawing.jpg: ${size} bytes.`);
}

try {
  const strings = { size: 'string', theme: 'string', sitting: 'string' };
  const options = { ...strings, save: 'boolean', built: 'boolean' };
  const { values } = parseArgs({
    options: Object.fromEntries(Object.entries(options).map(([name, type]) => [name, { type }])),
  });
  const wantedThemes = chosen('theme', values.theme, themes);
  if (!values.built) {
    await setUp('build', 'test');
    await buildWasm();
    await buildFacade();
    await buildPage();
  }
  process.env.CHROMIUM_PATH ??= chromiumPath();
  const sittings = await import('../tests/web/sittings.mjs');
  const sizes = chosen('size', values.size, Object.keys(sittings.windows));
  mkdirSync(inRoot('build/pictures'), { recursive: true });
  const { badgeSitting, trimSitting } = await import('../tests/web/part_sittings.mjs');
  const { posterSitting, scanSitting, seamSitting } = sittings;
  const all = {
    ...{ scan: scanSitting, seam: seamSitting, poster: posterSitting },
    ...{ trim: trimSitting, badge: badgeSitting },
  };
  const names = chosen('sitting', values.sitting, Object.keys(all));
  for (const size of values.save ? [] : sizes) {
    for (const theme of wantedThemes) {
      for (const name of names) {
        const path = inRoot(`build/pictures/${name}-${size}-${theme}`);
        const count = await replay(sittings, all[name], sittings.windows[size], theme, path);
        console.log(`${name}, ${size}, ${theme}: ${count} pictures`);
      }
    }
  }
  if (values.save) await savePicture(sittings);
} catch (error) {
  const wrongArguments = error.code?.startsWith('ERR_PARSE_ARGS');
  console.error(wrongArguments ? `${error.message}\n${usage}` : error.message);
  process.exit(1);
}
