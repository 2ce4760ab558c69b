// The page of the paper's comparisons, with small meshes.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { isComplaint, openBrowser } from './browser.mjs';
import { Controls } from './controls.mjs';
import { inLongRun, long, part } from './part.mjs';

const ids = [
  ...['means', 'paths', 'resolution', 'gallery', 'graph', 'averages', 'rational', 'circles'],
  ...['far', 'plane'],
];

const numbersOf = ({ lines }, id) => lines.find((line) => line.id === id);
/** Our line in a panel. */
const oursIn = (lines) =>
  ['karcher', 'karcherExact', 'circleArcs'].find((one) => lines.includes(one));

describe('the Paper page', () => {
  let browser;
  let page;
  const logged = [];
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1000, height: 760 }, asUsers: true });
    page = await browser.context.newPage();
    page.on('console', (message) => {
      if (isComplaint(message)) logged.push(message.text());
    });
    page.on('pageerror', (error) => logged.push(`${error}`));
    await page.goto(`${browser.address}paper.html?antialias=off&detail=0.02`);
  });
  after(() => browser.close());

  const settled = (id) =>
    page.waitForFunction(
      (wanted) => window.karcherPaper.sections.find(({ element }) => element.id === wanted).settled,
      id,
    );
  async function open(id) {
    await page.evaluate((wanted) => {
      document.getElementById(wanted).scrollIntoView({ behavior: 'instant' });
    }, id);
    await settled(id);
  }
  /** The rows of a panel's table: {line: [cells]}. */
  const rows = (panel) =>
    panel
      .locator('tbody tr')
      .evaluateAll((all) =>
        Object.fromEntries(
          all.map((row) => [
            row.dataset.line,
            [...row.querySelectorAll('td')].map((cell) => cell.textContent),
          ]),
        ),
      );
  /** Waits until the panel's canvas shows a picture. */
  const drawn = async (panel) =>
    page.waitForFunction(
      (canvas) => {
        const small = Object.assign(document.createElement('canvas'), { width: 40, height: 30 });
        const context = small.getContext('2d', { willReadFrequently: true });
        context.drawImage(canvas, 0, 0, 40, 30);
        return context.getImageData(0, 0, 40, 30).data.some((value) => value !== 0);
      },
      await panel.locator('canvas').elementHandle(),
    );

  test('lists its figures', async () => {
    assert.deepEqual(
      await page.locator('#contents a').evaluateAll((links) => links.map((link) => link.hash)),
      ['claims', 'means', 'transport', ...ids.slice(1), 'carried', 'plots', 'table'].map(
        (id) => `#${id}`,
      ),
    );
  });

  for (const id of ids) {
    test(`shows the figure '${id}' with its numbers`, async () => {
      await open(id);
      for (const panel of await page.locator(`#${id} .panel-card`).all()) {
        await panel.scrollIntoViewIfNeeded();
        const numbers = await rows(panel);
        const shown = await panel.locator('tbody tr:has(input:checked)').count();
        assert.ok(shown >= 2);
        const ours = numbers[oursIn(Object.keys(numbers))];
        assert.match(
          ours[2],
          /^(0|[0-9.]+|\d·10⁻[⁰¹²³⁴⁵⁶⁷⁸⁹]+)(over \d+\/\d+)?$/,
          JSON.stringify(numbers),
        );
        await drawn(panel);
        assert.ok((await panel.locator('.handle').count()) >= 2);
      }
      assert.deepEqual(logged, []);
    });
  }

  /** A panel's SVG and JSON, saved and read again. */
  const saved = (id, index) =>
    page.evaluate(
      ([figure, i]) => {
        const { panels } = window.karcherPaper.sections.find(
          ({ element }) => element.id === figure,
        );
        const svg = new DOMParser().parseFromString(panels[i].svg(), 'image/svg+xml');
        return {
          error: svg.querySelector('parsererror')?.textContent ?? null,
          drawn: svg.querySelectorAll('path, circle').length,
          image: svg.querySelector('image').getAttribute('href').slice(0, 22),
          metadata: JSON.parse(svg.querySelector('metadata').textContent),
          json: JSON.parse(panels[i].json()),
        };
      },
      [id, index],
    );

  // A center, and curves that take little time to trace.
  for (const id of long ? ids : ['means', 'graph']) {
    test(`has the figure '${id}' saved, moved and switched`, async () => {
      await open(id);
      const panels = await page.locator(`#${id} .panel-card`).all();
      for (const [index, panel] of panels.entries()) {
        await panel.scrollIntoViewIfNeeded();
        const before = await saved(id, index);
        assert.equal(before.error, null);
        assert.equal(before.image, 'data:image/png;base64,');
        assert.deepEqual(before.metadata, before.json);
        const ours = numbersOf(before.json, oursIn(before.json.lines.map((one) => one.id)));
        assert.ok(ours.traceMs >= 0 && ours.deviation.median >= 0);
        // A center of mass is one sample, which has no turning.
        if (before.json.curve.kind !== 'center') assert.ok(ours.turningNoise >= 0);
        assert.ok(before.json.info.triangles > 400);

        await panel.getByRole('button', { name: /^Point (2|q) / }).press('ArrowLeft');
        await settled(id);
        const moved = await saved(id, index);
        moved.json.points.forEach((point, i) => {
          if (i === 1) assert.notDeepEqual(point, before.json.points[i]);
          else assert.deepEqual(point, before.json.points[i]);
        });

        const box = panel.locator(`tr[data-line="${ours.id}"] input`);
        await box.uncheck();
        assert.ok((await saved(id, index)).drawn < moved.drawn);
        await box.check();
        await settled(id);
        assert.equal((await saved(id, index)).drawn, moved.drawn);
      }
      assert.deepEqual(logged, []);
    });
  }

  test('the buttons of a panel save its files', async () => {
    await open('rational');
    const panel = page.locator('#rational .panel-card').first();
    for (const kind of ['SVG', 'JSON']) {
      const download = page.waitForEvent('download');
      await panel.getByRole('button', { name: kind, exact: true }).click();
      assert.equal(
        (await download).suggestedFilename(),
        `karcher-cubic-equal.${kind.toLowerCase()}`,
      );
    }
  });

  test('a dragged point changes the curves of all panels that share it', async () => {
    await open('paths');
    const panels = page.locator('#paths .panel-card');
    const json = () =>
      page.evaluate(() => {
        const section = window.karcherPaper.sections.find(({ element }) => element.id === 'paths');
        return section.panels.map((panel) => JSON.parse(panel.json()));
      });
    const before = await json();
    await panels.first().scrollIntoViewIfNeeded();
    const handle = panels.first().getByRole('button', { name: 'Point q' });
    const box = await handle.boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 20, y + 6, { steps: 4 });
    await page.mouse.up();
    await settled('paths');
    const later = await json();
    later.forEach((panel, i) => {
      assert.deepEqual(panel.points[0], before[i].points[0]);
      assert.notDeepEqual(panel.points[1], before[i].points[1]);
      assert.equal(panel.lines.length, before[i].lines.length);
    });
  });

  test('a method is switched off and on, and one that was off is computed on request', async () => {
    await open('plane');
    const panel = page.locator('#plane .panel-card').first();
    await panel.scrollIntoViewIfNeeded();
    const box = panel.locator('tr[data-line="vectorHeatDelaunay"] input');
    assert.equal(await box.isChecked(), false);
    assert.equal((await rows(panel)).vectorHeatDelaunay[0], '');
    await box.check();
    await settled('plane');
    assert.match((await rows(panel)).vectorHeatDelaunay[0], /\d/);
    await box.uncheck();
    assert.equal(await box.isChecked(), false);
  });

  /** The numbers of a figure's first panel. */
  const firstJson = (id) =>
    page.evaluate((figure) => {
      const { panels } = window.karcherPaper.sections.find(({ element }) => element.id === figure);
      return JSON.parse(panels[0].json());
    }, id);
  test('sliders change a rational curve, and a method that was off is measured again', async () => {
    await open('rational');
    const panel = page.locator('#rational .panel-card').first();
    const box = panel.locator('tr[data-line="paper"] input');
    const before = numbersOf(await firstJson('rational'), 'paper');
    await box.uncheck();
    const slider = panel.locator('input[type="range"]').nth(1);
    // The earlier measurements disappear at once, since they are of another curve.
    const atOnce = await slider.evaluate((range) => {
      range.value = '1';
      range.dispatchEvent(new Event('input', { bubbles: true }));
      const { panels } = window.karcherPaper.sections.find(({ element }) =>
        element.contains(range),
      );
      return JSON.parse(panels[0].json());
    });
    assert.deepEqual(atOnce.lines, []);
    const title = panel.getByRole('heading', { level: 3 });
    assert.equal(await title.textContent(), 'Cubic, weights 1, 10, 1, 1');
    await settled('rational');
    assert.equal(await panel.locator('output').nth(1).textContent(), '10');
    const changed = await firstJson('rational');
    assert.deepEqual(changed.curve.weights, [1, 10, 1, 1]);
    assert.deepEqual(
      changed.lines.map(({ id }) => id),
      ['karcher', 'leveled'],
    );
    assert.equal((await rows(panel)).paper.join(''), '');
    await box.check();
    await settled('rational');
    const after = numbersOf(await firstJson('rational'), 'paper');
    assert.notEqual(after.deviation.median, before.deviation.median);
    await slider.fill('0');
    await settled('rational');
    const again = numbersOf(await firstJson('rational'), 'paper');
    assert.deepEqual(again.deviation, before.deviation);
    assert.equal(await title.textContent(), 'Cubic, weights 1');
  });

  inLongRun('says so where the editor cannot have the weights', async () => {
    await open('rational');
    const panel = page.locator('#rational .panel-card').first();
    const slider = (i) => panel.locator('input[type="range"]').nth(i);
    const link = panel.getByText('Open in the editor');
    const why = panel.getByText(
      'Not in the editor: the editor’s weights differ by no more than 256',
    );
    assert.deepEqual([await link.isVisible(), await why.isVisible()], [true, false]);
    await slider(0).fill('-2');
    await slider(1).fill('2');
    await settled('rational');
    assert.deepEqual([await link.isVisible(), await why.isVisible()], [false, true]);
    assert.equal(await link.getAttribute('href'), null);
    for (const i of [0, 1]) await slider(i).fill('0');
    await settled('rational');
    assert.deepEqual([await link.isVisible(), await why.isVisible()], [true, false]);
  });

  inLongRun('every method has a residual by exact paths, even the reference', async () => {
    await open('gallery');
    const panel = page.locator('#gallery .panel-card').nth(2);
    await panel.locator('tr[data-line="exactLogs"] input').check();
    await settled('gallery');
    const all = await rows(panel);
    for (const id of ['bSurf', 'paper', 'karcher', 'exactLogs']) {
      assert.match(all[id][0], /^0\.\d+/, `${id}: ${all[id]}`);
    }
    // The reference does not deviate from itself, and its energy difference is 0.
    assert.deepEqual([all.exactLogs[2], all.exactLogs[1]], ['–', '0']);
  });

  inLongRun('a method that was off while a point moved is measured again', async () => {
    await open('circles');
    const panel = page.locator('#circles .panel-card').first();
    const box = panel.locator('tr[data-line="isolineLinear"] input');
    const before = numbersOf(await firstJson('circles'), 'isolineLinear');
    await box.uncheck();
    await panel.getByRole('button', { name: /^Point q / }).press('ArrowLeft');
    await settled('circles');
    assert.equal(numbersOf(await firstJson('circles'), 'isolineLinear'), undefined);
    await box.check();
    await settled('circles');
    const after = numbersOf(await firstJson('circles'), 'isolineLinear');
    assert.notDeepEqual(after.deviation, before.deviation);
  });

  /** The curve in the editor from a panel's link, and the panel's own curve. */
  async function openedInEditor(figure, index) {
    await open(figure);
    const href = await page
      .locator(`#${figure} .panel-card`)
      .nth(index)
      .getByRole('link', { name: 'Open in the editor' })
      .getAttribute('href');
    const panel = await page.evaluate(
      ([id, i]) => {
        const { panels } = window.karcherPaper.sections.find(({ element }) => element.id === id);
        return JSON.parse(panels[i].json());
      },
      [figure, index],
    );
    const tab = await browser.context.newPage();
    await tab.goto(
      new URL(`${href}`.replace('index.html#', 'index.html?antialias=off#'), browser.address).href,
    );
    await tab.waitForFunction(
      () => window.karcherPage?.settled && window.karcherPage.triangles > 0,
    );
    const editor = await tab.evaluate(() => ({
      edited: window.karcherPage.state().figure,
      info: window.karcherPage.info(),
      length: window.karcherPage.view().curve?.length ?? null,
    }));
    await tab.close();
    return { href, panel, ...editor };
  }

  const links = [
    ['means', 1, 'center', 'plane:delaunay:500'],
    ['paths', 1, 'bezier', 'simplified:500:torus:1000'],
    ['gallery', 2, 'bspline', 'sphere:500'],
    ['rational', 1, 'rational', 'torus:500'],
    ['rational', 2, 'barycentric', 'torus:500'],
    ['circles', 0, 'circle', 'sphere:500'],
    ['plane', 3, 'bspline', 'plane:anisotropic:500'],
  ];
  for (const [figure, index, kind, mesh] of part(links, 2)) {
    test(`opens a curve of the kind '${kind}' on ${mesh} in the editor`, async () => {
      const { href, panel, edited, info, length } = await openedInEditor(figure, index);
      assert.ok(href.startsWith(`./index.html#mesh=${mesh}&kind=${kind}&`), href);
      assert.equal(edited.kind, kind);
      assert.deepEqual(info, panel.info);
      if (kind !== 'center') assert.ok(length > 0);
      if (kind === 'circle') return;
      assert.deepEqual(
        edited.points.map(({ face }) => face),
        panel.points.map(({ face }) => face),
      );
      const numbers = panel.curve.weights ?? panel.curve.betas ?? [];
      const name = kind === 'barycentric' ? 'beta' : 'weight';
      // Only the ratios count.
      const factor = (edited.points[0][name] ?? 1) / numbers[0];
      numbers.forEach((number, i) => {
        assert.ok(Math.abs((edited.points[i][name] ?? 1) - factor * number) < 1e-5 * number);
      });
    });
  }

  test('every panel has a link to the editor', async () => {
    for (const id of ids) {
      await open(id);
      const panels = page.locator(`#${id} .panel-card`);
      const links = panels.getByRole('link', { name: 'Open in the editor' });
      assert.equal(await links.count(), await panels.count(), id);
    }
  });

  inLongRun('Table 1 is measured, saved and cancelled', async () => {
    const section = page.locator('#table');
    await section.scrollIntoViewIfNeeded();
    await section.getByLabel('Samples per segment').selectOption('128');
    const cells = () => page.evaluate(() => window.karcherPaper.table.cells);
    /** Waits while cells of the table are running. */
    const idle = async () => {
      const settled = () => page.evaluate(() => window.karcherPaper.table.settled);
      while (!(await settled())) {
        await page.waitForFunction(
          (count) => {
            const { table } = window.karcherPaper;
            return table.settled || table.cells.length > count;
          },
          (await cells()).length,
        );
      }
    };
    await section.getByRole('button', { name: 'Run' }).click();
    await page.waitForFunction(() => window.karcherPaper.table.cells.length >= 2);
    await section.getByRole('button', { name: 'Cancel' }).click();
    assert.equal(await section.getByRole('status').textContent(), 'Cancelled.');
    const before = (await cells()).length;
    assert.ok(before < 50);
    await section.getByRole('button', { name: 'Run' }).click();
    await idle();
    assert.equal(await section.getByRole('status').textContent(), 'Done.');
    const all = await cells();
    assert.equal(all.length % 5, 0);
    for (const { row, method, result } of all) {
      const shown = await section
        .locator(`tr[data-row="${row}"] td[data-method="${method}"]`)
        .allTextContents();
      assert.equal(/\d/.test(shown[1]), result.traceMs !== null, `${row}, ${method}: ${shown}`);
      const measures = await section
        .locator(`tr[data-measures="${row}"] td[data-method="${method}"]`)
        .textContent();
      const { residual, energy } = result.ruler ?? {};
      assert.equal(/residual [\d.·⁻⁰-⁹]+ h/.test(measures), Boolean(residual), `${row}, ${method}`);
      assert.equal(/energy [\d.]+ h²/.test(measures), Boolean(energy), `${row}, ${method}`);
      const lost = result.lost ? [`lost ${result.lost}/${result.samples}`] : null;
      assert.deepEqual(measures.match(/lost \d+\/\d+/)?.slice() ?? null, lost);
      const own = result.lostByOwnRule;
      const isOther = lost !== null && own !== null && own !== result.lost;
      assert.equal(measures.includes(`, own ${own}`), isOther, `${row}, ${method}: ${measures}`);
    }
    assert.equal(await section.locator('.uplot canvas').count(), 1);
    await section.getByText('Update', { exact: true }).click();
    const save = section.getByRole('button', { name: 'CSV' });
    assert.equal(await save.isEnabled(), true);
    const csv = await page.evaluate(() => window.karcherPaper.table.csv());
    assert.equal(csv.trim().split('\n').length, 1 + all.length);
    assert.match(csv, /Chrome/);
    assert.deepEqual(logged, []);
  });

  inLongRun('Table 1 shows in a cell why its method failed', async () => {
    const section = page.locator('#table');
    await page.evaluate(() => {
      const { table } = window.karcherPaper;
      const row = table.rows.find(({ id }) => id === 'knot-500k');
      // The tube degenerates: too many faces fold over in eight dimensions.
      const of = { ...row.mesh, triangles: 20_000 };
      table.start([{ ...row, mesh: { kind: 'simplified', of, triangles: 90 } }]);
    });
    await page.waitForFunction(() => window.karcherPaper.table.settled);
    const [vectorHeat, , averages] = await page.evaluate(() => window.karcherPaper.table.cells);
    assert.equal(vectorHeat.triangles, 90);
    assert.equal(averages.result.ok, false);
    assert.equal(averages.result.prepareMs, null);
    const shown = await section
      .locator('tr[data-row="knot-500k"] td[data-method="weightedAverages"]')
      .allTextContents();
    assert.deepEqual(shown, [averages.result.reason, '–', '–']);
    assert.match(shown[0], /^no acceptable embedding/);
    const csv = await page.evaluate(() => window.karcherPaper.table.csv());
    assert.match(csv, /,simplified:90:knot:20000,90,4,\d+,Weighted averages,false,no acceptable/);
    assert.deepEqual(logged, []);
  });

  test('Table 1 can be cancelled inside a long step, and run again', async () => {
    const section = page.locator('#table');
    const status = () => section.getByRole('status').textContent();
    /** Starts a run, and returns whether the page offers a file at once. */
    const start = (triangles) =>
      page.evaluate((count) => {
        const { table } = window.karcherPaper;
        const row = table.rows.find(({ id }) => id === 'knot-500k');
        table.start([{ ...row, mesh: { ...row.mesh, triangles: count } }]);
        const buttons = [...table.element.querySelectorAll('button')];
        return !buttons.find(({ textContent }) => textContent === 'CSV').disabled;
      }, triangles);
    assert.equal(await start(100_000), false);
    await page.waitForFunction(() =>
      /Vector heat, preparing/.test(document.querySelector('#table [role=status]').textContent),
    );
    await section.getByRole('button', { name: 'Cancel' }).click();
    assert.equal(await status(), 'Cancelled.');
    assert.deepEqual(await page.evaluate(() => window.karcherPaper.table.cells), []);
    await start(1_000);
    await page.waitForFunction(() => window.karcherPaper.table.settled);
    assert.equal(await status(), 'Done.');
    assert.equal(await page.evaluate(() => window.karcherPaper.table.cells.length), 6);
    assert.deepEqual(logged, []);
  });

  const viewports = [
    { width: 1280, height: 800 },
    { width: 390, height: 844 },
  ];
  for (const viewport of part(viewports, 1)) {
    test(`a click hits every control, ${viewport.width} px wide`, async (t) => {
      await page.setViewportSize(viewport);
      await page.evaluate(() => {
        for (const details of document.querySelectorAll('details')) details.open = true;
      });
      for (const id of ids) await open(id);
      const controls = new Controls(page);
      await controls.install();
      assert.ok((await controls.look('all figures')) > 100);
      const panels = await page.evaluate(() => window.reach.panels());
      assert.ok(panels.length > ids.length);
      assert.deepEqual(
        panels.filter((panel) => !controls.panels.has(panel)),
        [],
      );
      t.diagnostic(`${controls.reached.size} kinds of controls`);
      assert.deepEqual(logged, []);
    });
  }

  test('a narrow window needs no sideways scroll', async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    assert.equal(await page.evaluate(() => document.scrollingElement.scrollWidth), 390);
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.locator('html[data-theme="dark"]').waitFor();
    assert.deepEqual(logged, []);
  });
});
