// The drawings that a browser keeps for the page, and the one that a reload finds.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { pageModule } from './page_module.mjs';

/** A store with room for this many letters. */
class Store extends Map {
  constructor(room = Infinity) {
    super();
    this.room = room;
  }

  get length() {
    return this.size;
  }

  key(index) {
    return [...this.keys()][index];
  }

  getItem(name) {
    return this.get(name) ?? null;
  }

  removeItem(name) {
    this.delete(name);
  }

  setItem(name, value) {
    const others = [...this].filter(([one]) => one !== name);
    const taken = others.reduce((sum, [one, text]) => sum + one.length + text.length, 0);
    if (taken + name.length + value.length > this.room) throw new Error('full');
    this.set(name, value);
  }
}

const linkOfPoints = (count, mesh = 'sphere:1500') =>
  `mesh=${mesh}&kind=points&method=karcher&points=${Array.from({ length: count }, (_, i) => `${i},0.25,0.5`).join(';')}`;

describe('what is kept', () => {
  let page;
  before(async () => {
    globalThis.window = {};
    page = await pageModule('./kept_parts.ts');
  });

  /** Saves a link's drawing from the tab of a storage. */
  const save = (tab, text) => {
    globalThis.sessionStorage = tab;
    const { drawing } = page.parseLink(text);
    page.rememberInTab('work', page.savedWork(text, drawing, page.historyOf()));
    page.rememberAll({ last: text, 'document.sphere:1500': text });
  };

  test('each of two tabs on one surface finds its own drawing after a reload, of any size', () => {
    globalThis.localStorage = new Store();
    const [one, other, third] = [new Store(), new Store(), new Store()];
    save(one, linkOfPoints(1200));
    save(other, linkOfPoints(1300));
    const found = (tab, fragment = 'mesh=sphere:1500&method=karcher&kept=1') => {
      globalThis.sessionStorage = tab;
      const { link, own } = page.linkOf(fragment);
      return [page.pointsOf(link.drawing), own];
    };
    assert.deepEqual(found(one), [1200, true]);
    assert.deepEqual(found(other), [1300, true]);
    assert.deepEqual(found(third), [1300, true], 'a tab without work takes the last');
    globalThis.localStorage.clear();
    assert.deepEqual(found(one), [1200, true]);
    assert.deepEqual(found(one, linkOfPoints(7)), [7, false], 'a link that says all is itself');
    assert.deepEqual(found(third), [0, false]);
    const elsewhere = page.linkOf('mesh=torus:5000&kept=1').link;
    assert.deepEqual([elsewhere.mesh, page.pointsOf(elsewhere.drawing)], ['torus:5000', 0]);
  });

  test('a reload finds the newest copy, or the page says that it has none', () => {
    const kept = (count) => {
      const { mesh, method, drawing } = page.parseLink(linkOfPoints(count));
      return page.keepDrawing({ mesh, method, drawing }, page.historyOf());
    };
    const found = () =>
      page.pointsOf(page.linkOf('mesh=sphere:1500&method=karcher&kept=1').link.drawing);
    const rooms = [Infinity, 200_000, 50_000, 100];
    for (const [browser, tab] of rooms.flatMap((one) => rooms.map((other) => [one, other]))) {
      globalThis.localStorage = new Store(browser);
      globalThis.sessionStorage = new Store(tab);
      for (const count of [3, 5000, 1300, 7000, 1400]) {
        const isKept = kept(count);
        const room = Math.max(browser, tab);
        const words = `${count} points, room for ${browser} and ${tab} letters`;
        const fits = count < 1000 || room === Infinity || (count < 2000 && room >= 50_000);
        if (fits) assert.ok(isKept, words);
        // The address itself holds a short link.
        if (isKept && count > 1000) assert.equal(found(), count, words);
      }
    }
  });

  test('is found by the content of a file under any name, even as earlier versions kept it', () => {
    const [one, other] = ['one.obj', 'other.obj'].map((name) => `file:1abc-9.0*0.1~z:${name}`);
    const found = (mesh) =>
      page.pointsOf(page.linkOf(`mesh=${encodeURIComponent(mesh)}&kept=1`).link.drawing);
    const afresh = () => {
      globalThis.localStorage = new Store();
      globalThis.sessionStorage = new Store();
    };
    afresh();
    const { method, drawing } = page.parseLink(linkOfPoints(1400, one));
    page.keepDrawing({ mesh: one, method, drawing }, page.historyOf());
    assert.deepEqual([found(one), found(other)], [1400, 1400], 'in this tab');
    globalThis.sessionStorage = new Store();
    assert.deepEqual([found(one), found(other)], [1400, 1400], 'in another one');
    assert.equal(found(one.replace('9', '8')), 0, 'another content');
    afresh();
    localStorage.setItem(`karcher.document.${one}`, linkOfPoints(1300, one));
    assert.deepEqual([found(one), found(other)], [1300, 1300]);
    assert.equal(found(other.replace('~z', '~x')), 1300, 'whatever points up');
    assert.equal(found(other.replace('.0', '.1')), 0, 'other parts');
    assert.equal(page.linkOf(`mesh=${encodeURIComponent(other)}&kept=1`).link.mesh, other);
    page.keepDrawing({ mesh: other, method, drawing }, null);
    assert.deepEqual([found(one), found(other)], [1400, 1400], 'the newer one counts');
  });

  test('is reported as kept only if all of it is', () => {
    const heard = [];
    page.onKeeping((kept) => heard.push(kept));
    globalThis.localStorage = new Store(100);
    const long = 'x'.repeat(200);
    page.rememberAll({ last: long, 'document.sphere:1500': long, method: 'karcher' });
    assert.deepEqual(heard, [false], 'the short one found room');
    assert.equal(page.recall('method'), 'karcher');
    page.rememberAll({ last: 'short', method: 'karcher' });
    assert.deepEqual(heard, [false, true]);
  });
});
