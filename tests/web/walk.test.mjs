// A random walk over the controls and gestures: after every step panel, handles, halo and status
// show the same selection, and undo works.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import fc from 'fast-check';
import { browserOfSuite, Tab } from './browser.mjs';
import { Dropping, dropStep } from './dropping.mjs';
import { long, seed } from './part.mjs';

/** A place of the stage, relative to its middle: usually on the surface. */
const place = fc.tuple(
  fc.integer({ min: -9, max: 9 }).map((step) => 20 * step),
  fc.integer({ min: -8, max: 8 }).map((step) => 20 * step),
);
const number = fc.nat({ max: 7 });

/** The steps with their frequencies: mostly keys and clicks. */
const step = fc.oneof(
  { weight: 5, arbitrary: fc.record({ do: fc.constant('click'), at: place }) },
  { weight: 4, arbitrary: fc.record({ do: fc.constant('drag'), at: place, to: place }) },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('shift-click'), at: place }) },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('shift-drag'), at: place, to: place }) },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('alt-drag'), at: place, to: place }) },
  { weight: 2, arbitrary: fc.record({ do: fc.constant('handle'), which: number, to: place }) },
  {
    weight: 4,
    arbitrary: fc.record({
      do: fc.constant('key'),
      key: fc.constantFrom(...['v', 'v', 'p', 'b', 'o', 'e', 'Escape', 'Enter', 'Delete']),
    }),
  },
  {
    weight: 3,
    arbitrary: fc.record({
      do: fc.constant('key'),
      key: fc.constantFrom(
        ...['Control+z', 'Control+Shift+z', 'Control+d', 'Control+a', 'Control+g', 'Tab'],
      ),
    }),
  },
  { weight: 2, arbitrary: fc.record({ do: fc.constant('row'), which: number }) },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('eye'), which: number }) },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('lock'), which: number }) },
  { weight: 2, arbitrary: fc.record({ do: fc.constant('swatch'), which: number }) },
  {
    weight: 2,
    arbitrary: fc.record({
      do: fc.constant('button'),
      id: fc.constantFrom(
        'new-object',
        'duplicate',
        'raise',
        'lower',
        'group',
        'ungroup',
        'remove',
      ),
    }),
  },
  { weight: 2, arbitrary: fc.record({ do: fc.constant('undo and redo') }) },
  { weight: 2, arbitrary: fc.record({ do: fc.constant('make'), which: number }) },
  {
    weight: 1,
    arbitrary: fc.record({
      do: fc.constant('fill'),
      percent: fc.constantFrom(0, 40, 100),
      pattern: fc.constantFrom('solid', 'hatched', 'striped'),
    }),
  },
  {
    weight: 1,
    arbitrary: fc.record({ do: fc.constant('mirror'), at: place, to: place, copy: fc.boolean() }),
  },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('ruler'), at: place, to: place }) },
  {
    weight: 1,
    arbitrary: fc.record({
      do: fc.constant('freehand'),
      stroke: fc.array(place, { minLength: 2, maxLength: 5 }),
    }),
  },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('frame'), which: number, to: place }) },
  {
    weight: 1,
    arbitrary: fc.record({
      do: fc.constant('size'),
      side: fc.constantFrom('width', 'height'),
      times: fc.constantFrom(0.5, 1.5),
    }),
  },
  { weight: 1, arbitrary: fc.record({ do: fc.constant('part'), which: number }) },
  { weight: 2, arbitrary: dropStep },
);

const steps = 100;
const walks = fc.sample(fc.array(step, { minLength: steps, maxLength: steps }), {
  seed,
  numRuns: long ? 20 : 1,
});
/** The number of objects from which the walk begins no more, which would only be slow. */
const mostObjects = 8;

/** The selection according to every part of the page. */
const said = () => {
  const page = window.karcherPage;
  const { drawing, chosen, none, figure, selection, more, tool } = page.state();
  const isDrawn = ({ figure: { points, circle, derived } }) =>
    points.length > 0 || circle !== null || Boolean(derived);
  const selected = none ? [] : chosen.length > 0 ? chosen : [drawing.active];
  const objects = drawing.objects.filter(({ id }) => selected.includes(id));
  const active = drawing.objects.find(({ id }) => id === drawing.active);
  const rows = [...document.querySelectorAll('#objects li[data-id]')];
  const isMarked = (row) =>
    row.querySelector('.object[aria-pressed="true"], .object[aria-current]');
  const marked = rows.filter(isMarked).map((row) => Number(row.dataset.id));
  const seen = (id) => {
    const element = document.getElementById(id);
    return element.checkVisibility() ? element.textContent.trim() : null;
  };
  const handles = [...document.querySelectorAll('#handles .handle')];
  const points = handles.filter(({ dataset }) => ['point', 'anchor'].includes(dataset.look));
  const colors = new Set(objects.map(({ color }) => color));
  const pressed = [...document.querySelectorAll('#swatches .swatch[aria-pressed="true"]')];
  const isOpen = !none && active.visible && !active.locked && tool !== 'transform';
  return {
    drawing: JSON.stringify(drawing),
    count: drawing.objects.length,
    checks: {
      'the rows': [
        marked.toSorted((a, b) => a - b),
        objects
          .filter(isDrawn)
          .map(({ id }) => id)
          .toSorted((a, b) => a - b),
      ],
      'the title of several': [
        /^\d+ objects$/.test(document.getElementById('sheet-title').textContent),
        objects.length > 1,
      ],
      'the title of nothing': [
        document.getElementById('sheet-title').textContent === 'Nothing selected',
        objects.length === 0,
      ],
      'the controls': [document.getElementById('width').disabled, objects.length === 0],
      'the swatches': [
        pressed.map(({ dataset }) => dataset.color || null),
        colors.size === 1 && pressed.length > 0 ? [...colors] : [],
      ],
      'the handles': [points.length, isOpen && figure.circle === null ? figure.points.length : 0],
      'the pressed handles': [
        [...points.keys()].filter((i) => points[i].ariaPressed === 'true'),
        isOpen && typeof selection === 'number'
          ? [...more, selection].toSorted((a, b) => a - b)
          : [],
      ],
      'the status': [
        seen('selected')?.replaceAll(/\D+/g, '') ?? '',
        typeof selection === 'number' && tool !== 'measure'
          ? `${more.length > 0 ? more.length + 1 : selection + 1}`
          : '',
      ],
      'the status of nothing': [
        objects.length === 0 && document.getElementById('status-length').textContent !== '',
        false,
      ],
      'the halo': [
        page.marked().toSorted((a, b) => a - b),
        // A single selected object has its handles instead.
        chosen.some((id) => id !== drawing.active) ? chosen.toSorted((a, b) => a - b) : [],
      ],
    },
  };
};

describe('a walk', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 } });

  async function take(tab, taken, dropping) {
    const { page } = tab;
    const { x, y } = await tab.middle();
    const at = ([dx, dy]) => ({ x: x + dx, y: y + dy });
    const drag = async (key) => {
      if (key) await page.keyboard.down(key);
      await tab.drag(at(taken.at), at(taken.to));
      if (key) await page.keyboard.up(key);
    };
    const nth = async (selector) => {
      const all = page.locator(selector).filter({ visible: true });
      const count = await all.count();
      return count > 0 ? all.nth(taken.which % count) : null;
    };
    const todo = {
      click: () => page.mouse.click(...Object.values(at(taken.at))),
      'shift-click': async () => {
        await page.keyboard.down('Shift');
        await page.mouse.click(...Object.values(at(taken.at)));
        await page.keyboard.up('Shift');
      },
      drag: () => drag(null),
      'shift-drag': () => drag('Shift'),
      'alt-drag': () => drag('Alt'),
      handle: async () => {
        const handle = await nth('#handles .handle:not(.behind)');
        const box = await handle?.boundingBox();
        if (!box) return;
        await tab.drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, at(taken.to));
      },
      key: () => page.keyboard.press(taken.key),
      row: async () => (await nth('#objects .object'))?.click(),
      eye: async () => (await nth('#objects .eye'))?.click(),
      lock: async () => (await nth('#objects .lock'))?.click(),
      swatch: async () => {
        const swatch = await nth('#swatches .swatch');
        if (await swatch?.isEnabled()) await swatch.click();
      },
      button: async () => {
        const button = page.locator(`#${taken.id}`);
        if ((await button.isVisible()) && (await button.isEnabled())) await button.click();
      },
      make: async () => (await nth('#makers button:enabled'))?.click(),
      fill: async () => {
        const fill = page.locator('#fill');
        if (!(await fill.isVisible()) || !(await fill.isEnabled())) return;
        await fill.fill(`${taken.percent}`);
        await page.keyboard.press('Enter');
        const pattern = page.locator('#pattern');
        if ((await pattern.isVisible()) && (await pattern.isEnabled())) {
          await pattern.selectOption(taken.pattern);
        }
      },
      mirror: async () => {
        await page.keyboard.press('i');
        const copies = page.locator('#mirror-copies');
        if (!(await copies.isVisible())) return;
        await copies.setChecked(taken.copy);
        for (const one of [taken.at, taken.to]) await page.mouse.click(...Object.values(at(one)));
      },
      ruler: async () => {
        await page.keyboard.press('m');
        for (const one of [taken.at, taken.to]) await page.mouse.click(...Object.values(at(one)));
      },
      freehand: async () => {
        await page.keyboard.press('f');
        const [from, ...rest] = taken.stroke.map(at);
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        for (const one of rest) await page.mouse.move(one.x, one.y, { steps: 6 });
        await page.mouse.up();
      },
      frame: async () => {
        await page.keyboard.press('k');
        await tab.settled();
        const handle = await nth('.handles:not(#handles) .handle:not(.behind)');
        const box = await handle?.boundingBox();
        if (!box) return;
        await tab.drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, at(taken.to));
      },
      size: async () => {
        const side = page.locator(`#size-${taken.side}`);
        if (!(await side.isVisible()) || !(await side.isEnabled())) return;
        await side.fill(`${taken.times * Number(await side.inputValue())}`);
        await page.keyboard.press('Enter');
      },
      part: async () => (await nth('#parts button:enabled:not([aria-label^="Save"])'))?.click(),
      'undo and redo': async () => {
        if (!(await page.locator('#undo').isEnabled())) return;
        await page.locator('#undo').click();
        await tab.settled();
        await page.locator('#redo').click();
      },
      drop: () => dropping.take(taken),
    };
    await todo[taken.do]();
    await tab.page.waitForFunction(() => !window.karcherPage?.busy);
    await tab.settled();
  }

  for (const [run, walk] of walks.entries()) {
    test(`over everything: all parts show one selection, KARCHER_SEED=${seed}, walk ${run}`, async () => {
      const tab = await Tab.open(browser, 'mesh=sphere:500');
      const dropping = new Dropping(tab);
      const way = [];
      let before = await tab.page.evaluate(said);
      for (const taken of walk) {
        const makes =
          ['Control+d', 'duplicate'].includes(taken.key ?? taken.id) ||
          ['make', 'mirror', 'freehand', 'alt-drag'].includes(taken.do);
        if (makes && before.count >= mostObjects) continue;
        way.push(JSON.stringify(taken));
        const told = () => `after step ${way.length}:\n${way.slice(-8).join('\n')}`;
        await take(tab, taken, dropping);
        const now = await tab.page.evaluate(said);
        for (const [what, [is, should]] of Object.entries(now.checks)) {
          assert.deepEqual(is, should, `${what} ${told()}`);
        }
        if (taken.do === 'undo and redo') assert.equal(now.drawing, before.drawing, told());
        assert.deepEqual(tab.logged, [], told());
        before = now;
      }
      await tab.page.close();
    });
  }
});
