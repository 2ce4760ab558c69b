// node tests/web/zoom_meshes.mjs FILE|FOLDER …: zooms on meshes from the whole to a triangle and
// back, at several places, by the wheel, two fingers and keys. The page must be built.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { openBrowser, Tab } from './browser.mjs';
import { zoomThrough } from './zooming.mjs';

const isMesh = (path) => /\.(obj|stl|ply|off|glb)$/i.test(path);
const filesIn = (path) =>
  statSync(path).isDirectory()
    ? readdirSync(path)
        .sort()
        .map((name) => join(path, name))
        .filter(isMesh)
    : [path];
const files = process.argv.slice(2).flatMap(filesIn);
if (files.length === 0) {
  console.error('Usage: node tests/web/zoom_meshes.mjs FILE|FOLDER …');
  process.exit(1);
}

/** Places of the stage, relative to its smaller side, from -1 to 1. */
const places = [
  [0, 0],
  [-0.25, 0.3],
  [0.3, -0.2],
];

const browser = await openBrowser({ reducedMotion: 'reduce', hasTouch: true });
let failed = 0;
for (const file of files) {
  const name = basename(file);
  for (const how of ['wheel', 'pinch', 'keys']) {
    for (const [across, down] of how === 'keys' ? places.slice(0, 1) : places) {
      const tab = await Tab.open(browser, 'mesh=sphere:500');
      try {
        await tab.dropBytes(name, readFileSync(file));
        await tab.page.waitForFunction(
          (ending) => window.karcherPage.state().mesh.endsWith(ending),
          name,
        );
        await tab.settled();
        await tab.still();
        const { width, height } = await tab.page.locator('#stage').boundingBox();
        const { x, y } = await tab.middle();
        const unit = Math.min(width, height) / 2;
        const steps = await zoomThrough(tab, how, { x: x + unit * across, y: y + unit * down });
        console.log(`${name}, ${how}, at ${across} ${down}: ${steps} steps`);
      } catch (error) {
        failed++;
        console.log(`${name}, ${how}, at ${across} ${down}: FAILS. ${error.message}`);
      }
      await tab.close();
    }
  }
}
await browser.close();
console.log(failed === 0 ? 'all reach a triangle and come back' : `${failed} fail`);
process.exitCode = failed === 0 ? 0 : 1;
