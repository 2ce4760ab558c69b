// Prints the time that the built page takes from its address to an editable surface, in a new
// profile with an empty cache and again with a full one: node tests/web/start_time.mjs
import { openBrowser } from './browser.mjs';

const repeats = 5;

/** The milliseconds from the navigation until the page accepts clicks on its first surface. */
async function startTime(context, address) {
  const page = await context.newPage();
  await page.addInitScript(() => {
    const look = () => {
      if (window.karcherPage?.triangles > 0) window.usableAt ??= performance.now();
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await page.goto(address);
  const usable = await (await page.waitForFunction(() => window.usableAt)).jsonValue();
  await page.close();
  return usable;
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

const times = { first: [], again: [] };
for (let i = 0; i < repeats; i++) {
  const browser = await openBrowser({
    viewport: { width: 1280, height: 800 },
    profile: true,
    asUsers: true,
  });
  try {
    times.first.push(await startTime(browser.context, browser.address));
    times.again.push(await startTime(browser.context, browser.address));
  } finally {
    await browser.close();
  }
}
const usableMs = Object.fromEntries(
  Object.entries(times).map(([name, values]) => [name, Math.round(median(values))]),
);
console.log(JSON.stringify({ usableMs, repeats, graphics: 'software' }));
