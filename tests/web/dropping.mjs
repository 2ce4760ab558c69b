// Drops of files for random walks over the page: surfaces, several at once, and other files. The
// page reports its action for each. A surface that comes back has its earlier drawing.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { box, cutBox, encode, objFile, plyFile } from '../wasm/mesh_files.mjs';

/** The few surfaces of the walk, so that it comes back to them. */
const surfaces = [
  ['box.obj', objFile(box)],
  ['cut box.obj', objFile(cutBox)],
  ['box.ply', plyFile(box)],
];
const picture = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);

export const dropStep = fc.record({
  do: fc.constant('drop'),
  what: fc.constantFrom(
    'surface',
    'surface',
    'bad',
    'none',
    'mixed',
    'several',
    'several, none chosen',
  ),
  which: fc.nat({ max: surfaces.length - 1 }),
  during: fc.boolean(),
});

/** Keeps the texts of the page's messages, since notes disappear by themselves. */
const rememberMessages = () => {
  if (window.messagesSeen) return;
  window.messagesSeen = [];
  new MutationObserver((changes) => {
    for (const { addedNodes } of changes) {
      for (const node of addedNodes) {
        if (node.classList?.contains('message')) window.messagesSeen.push(node.textContent);
      }
    }
  }).observe(document.body, { childList: true, subtree: true });
};

/** The walk's drops, and its memory of them. */
export class Dropping {
  #count = 0;
  /** The drawing on each surface at the time when another surface opened. */
  #left = new Map();

  constructor(tab) {
    this.tab = tab;
  }

  /** Drops files, during a drag if the step requires it, and waits for the page's report. */
  async take({ what, which, during }) {
    const { tab } = this;
    const { page } = tab;
    const number = ++this.#count;
    if (during) {
      const { x, y } = await tab.middle();
      await page.mouse.move(x - 30, y);
      await page.mouse.down();
      await page.mouse.move(x + 30, y + 20, { steps: 3 });
      await this.#drop(what, which, number, () => page.mouse.up());
    } else {
      await this.#drop(what, which, number, async () => {});
    }
  }

  async #drop(what, which, number, release) {
    const { tab } = this;
    const { page } = tab;
    await page.evaluate(rememberMessages);
    const says = (text) =>
      page.waitForFunction((part) => window.messagesSeen.some((one) => one.includes(part)), text);
    const before = await tab.state();
    const [name, bytes] = surfaces.filter(([one]) => !before.mesh.endsWith(`:${one}`))[
      which % (surfaces.length - 1)
    ];
    const bad = [`picture ${number}.ply`, picture];
    const none = [`notes ${number}.txt`, encode('hello')];
    const dialog = page.getByRole('dialog', { name: 'Which one is to be opened?' });
    const files = {
      surface: [[name, bytes]],
      bad: [bad],
      none: [none],
      mixed: [none, [name, bytes]],
      several: surfaces,
      'several, none chosen': surfaces,
    }[what];
    await tab.dropFiles(files);
    await release();
    if (what === 'bad') await says(`${bad[0]} could not be opened`);
    // The page tries a single file as a surface.
    if (what === 'none') await says(`${none[0]} could not be opened`);
    if (what === 'mixed') await says(`${none[0]} is no surface or drawing`);
    if (what.startsWith('several')) {
      await dialog.waitFor();
      if (what === 'several') await dialog.getByRole('button', { name, exact: true }).click();
      else await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'hidden' });
    }
    if (['surface', 'mixed', 'several'].includes(what)) {
      await page.waitForFunction(
        (ending) => window.karcherPage?.state().mesh.endsWith(ending),
        `:${name}`,
      );
      await tab.settled();
      const now = await tab.state();
      // A drag ends on either surface, when its button comes up.
      this.#left.set(before.mesh, before.drawing);
      if (this.#left.has(now.mesh)) assert.deepEqual(now.drawing, this.#left.get(now.mesh), name);
    } else {
      await tab.settled();
      assert.equal(
        (await tab.state()).mesh,
        before.mesh,
        'what is no surface leaves the one that is shown',
      );
    }
  }
}
