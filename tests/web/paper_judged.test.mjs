// The claims on the Paper page, and figures with controls of their own.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { isComplaint, openBrowser, until } from './browser.mjs';
import { inLongRun } from './part.mjs';

describe('the paper, judged', () => {
  let browser;
  let page;
  const logged = [];
  before(async () => {
    browser = await openBrowser({ viewport: { width: 1280, height: 800 }, asUsers: true });
    page = await browser.context.newPage();
    page.on('console', (message) => {
      if (isComplaint(message)) logged.push(message.text());
    });
    page.on('pageerror', (error) => logged.push(`${error}`));
    await page.goto(`${browser.address}paper.html?antialias=off&detail=0.02`);
  });
  after(async () => {
    await browser.close();
    assert.deepEqual(logged, []);
  });

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

  const verdicts = ['holds', 'does not', 'depends', 'settled here', 'open', 'not measured here'];
  test('every claim has a row with a verdict, and leads to its figure', async () => {
    // Figures judge the claims that need no report during their own measurement.
    await open('means');
    const four = page.locator('#claims tr[data-claim="four-points"]');
    assert.match(await four.locator('td').nth(1).textContent(), /center is [0-9.]+ h/);
    assert.match(await four.locator('strong').textContent(), /^(holds|depends)$/);
    const claims = await page.locator('#claims tbody tr').evaluateAll((all) =>
      all.map((row) => ({
        id: row.dataset.claim,
        verdict: row.lastElementChild.dataset.verdict,
        shown: row.lastElementChild.querySelector('strong').textContent,
        hash: row.querySelector('a')?.hash ?? null,
      })),
    );
    assert.ok(claims.length >= 24);
    for (const { id, verdict, shown, hash } of claims) {
      assert.ok(verdicts.includes(verdict), id);
      assert.equal(shown, verdict, id);
      if (hash) assert.equal(await page.locator(`section${hash}`).count(), 1, `${id}: ${hash}`);
    }
  });

  test('Figure 1: says whether the center is the only one, and shows the others', async () => {
    await open('means');
    const said = page.locator('#means .only');
    const says = (wanted) =>
      page.waitForFunction(
        (start) => document.querySelector('#means .only').textContent.startsWith(start),
        wanted,
      );
    await says('Likely the only center');
    assert.match(await said.nth(1).textContent(), /^Certainly the only center/);
    assert.equal(await page.locator('#means .marker.other').count(), 0);
    await page.evaluate(() => {
      const { sections } = window.karcherPaper;
      const { panels } = sections.find(({ element }) => element.id === 'means');
      // Four points around the equator.
      panels[0].setPoints([
        [1.4, 0, 0],
        [0, 1.4, 0],
        [-1.4, 0, 0],
        [0, -1.4, 0],
      ]);
    });
    await says('Not the only center: its energy is 2.');
    assert.ok((await page.locator('#means .marker.other').count()) >= 1);
    await settled('means');
  });

  test('Figure 2: the vector turns in the face as it is turned at the vertex', async () => {
    const section = page.locator('#transport');
    await section.scrollIntoViewIfNeeded();
    const heads = () =>
      section
        .locator('.vector-head')
        .evaluateAll((all) => all.map((one) => one.getAttribute('points')));
    const before = await heads();
    assert.equal(before.length, 2);
    await section.getByRole('slider', { name: 'Direction' }).fill('200');
    const turned = await heads();
    assert.ok(turned[0] !== before[0] && turned[1] !== before[1]);
    assert.match(await section.locator('.panel-note').textContent(), /from 200° in the frame of v/);
    await section.getByRole('slider', { name: 'Face' }).fill('4');
    const other = await heads();
    assert.equal(other[0], turned[0]);
    assert.notEqual(other[1], turned[1]);
  });

  test('Figure 7: every curve shows how far it leaps in a drag, until its points move', async () => {
    await open('far');
    const panel = page.locator('#far .panel-card').first();
    const turning = () =>
      panel
        .locator('tbody tr')
        .evaluateAll((all) => all.map((row) => [row.dataset.line, row.cells[5].textContent]));
    await panel.getByRole('button', { name: 'Drag', exact: true }).click();
    await page.waitForFunction(() =>
      [...document.querySelector('#far .panel-card').querySelectorAll('tbody tr')].every((row) =>
        /drag ×[0-9.]+/.test(row.cells[5].textContent),
      ),
    );
    const told = Object.fromEntries(await turning());
    assert.ok('bSurf' in told && 'leveled' in told && 'vectorHeat' in told);
    assert.doesNotMatch(told.bSurf, /leap/);
    const drags = await page.evaluate(() => {
      const { panels } = window.karcherPaper.sections.find(({ element }) => element.id === 'far');
      return JSON.parse(panels[0].json()).lines.map(({ drag }) => drag);
    });
    for (const { steps, leaps, most } of drags) {
      assert.equal(steps, 20);
      assert.equal(leaps > 0, most > 5);
    }
    await page.evaluate(() => {
      const { panels } = window.karcherPaper.sections.find(({ element }) => element.id === 'far');
      panels[0].setPoints([
        [-1.6, 0, 0.1],
        [-0.3, 0.45, 0.25],
        [0.3, -0.4, 0.25],
        [1.6, 0, 0.1],
      ]);
    });
    await settled('far');
    for (const [id, text] of await turning()) assert.doesNotMatch(text, /drag/, id);
  });

  inLongRun('Figure 8: another anisotropy is another mesh, measured again', async () => {
    await open('plane');
    const caption = await page.locator('#plane > .caption').textContent();
    assert.match(caption, /“Paper, 1-ring”: Eq\. 3 as printed/);
    const panel = page.locator('#plane .panel-card').nth(3);
    const json = () =>
      page.evaluate(() => {
        const { panels } = window.karcherPaper.sections.find(
          ({ element }) => element.id === 'plane',
        );
        return JSON.parse(panels[3].json());
      });
    const before = await json();
    await panel.getByLabel('Anisotropy').fill('3');
    await settled('plane');
    const after = await json();
    assert.deepEqual([before.mesh.stretch, after.mesh.stretch], [undefined, 3]);
    assert.notEqual(after.info.meanEdge, before.info.meanEdge);
    assert.equal(after.lines.length, before.lines.length);
    const href = await panel.getByRole('link', { name: 'Open in the editor' }).getAttribute('href');
    assert.match(href, /mesh=plane:anisotropic\*3:500/);
    await panel.getByLabel('Anisotropy').fill('20');
    await settled('plane');
  });

  test('Figure 8: another anisotropy leaves the button Triangles as it is', async () => {
    await open('plane');
    const panel = page.locator('#plane .panel-card').nth(3);
    const button = panel.getByRole('button', { name: 'Triangles' });
    /** The surface alone. */
    const picture = () =>
      page.evaluate(() => {
        const { sections } = window.karcherPaper;
        const { panels } = sections.find(({ element }) => element.id === 'plane');
        const svg = new DOMParser().parseFromString(panels[3].svg(), 'image/svg+xml');
        return svg.querySelector('image').getAttribute('href');
      });
    const before = await button.getAttribute('aria-pressed');
    await button.click();
    const chosen = await button.getAttribute('aria-pressed');
    assert.notEqual(chosen, before);
    await panel.getByLabel('Anisotropy').fill('3');
    await settled('plane');
    assert.equal(await button.getAttribute('aria-pressed'), chosen);
    const kept = await picture();
    await button.click();
    const other = await picture();
    assert.ok(kept !== other, 'the first click after the change changes the picture');
    await button.click();
    assert.ok((await picture()) === kept, 'the second one restores it');
    await button.click();
    await panel.getByLabel('Anisotropy').fill('20');
    await settled('plane');
  });

  test('the carried drawing follows a control point on either side', async () => {
    const section = page.locator('#carried');
    await section.scrollIntoViewIfNeeded();
    const still = () => page.waitForFunction(() => window.karcherPaper.carried.settled);
    const shown = () =>
      page.evaluate(() => {
        const { carried, points, source, target, reason } = window.karcherPaper.carried.shown;
        return { carried, points, reason, source: [...source[0]], target: [...target[0]] };
      });
    // The page may not have received the pointer's event when the test reads `settled`.
    const moved = async (earlier) => {
      const at = String(earlier.target);
      await until(async () => String((await shown()).target) !== at, 'the target has moved');
      await still();
    };
    await still();
    const before = await shown();
    assert.ok(before.points > 100);
    assert.equal(before.carried, before.points, before.reason);
    assert.match(await section.getByRole('status').textContent(), /\d+ points carried in/);
    const handle = (side) => section.locator(`[data-panel="${side}"] .handle`).first();
    for (const side of ['target', 'source']) {
      const earlier = await shown();
      // The mouse reaches only visible elements.
      await handle(side).scrollIntoViewIfNeeded();
      const box = await handle(side).boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width / 2 + 14, box.y + box.height / 2 + 10, { steps: 3 });
      await page.mouse.up();
      await moved(earlier);
      assert.deepEqual((await shown()).source, earlier.source, 'the drawing stays on its source');
    }
    const four = await shown();
    await handle('target').focus();
    await page.keyboard.press('ArrowLeft');
    await moved(four);
    await section.getByLabel('Only three control points').check();
    await still();
    await page.waitForFunction(
      () => document.querySelectorAll('#carried [data-panel="source"] .handle').length === 3,
    );
    assert.equal(await section.locator('.handle').count(), 6);
  });

  inLongRun(
    'what is plotted comes from the report, and is measured here when it is asked for',
    async () => {
      const section = page.locator('#plots');
      await section.scrollIntoViewIfNeeded();
      assert.match(
        await section.getByRole('status').textContent(),
        /^Measured on \d{4}-\d{2}-\d{2}/,
      );
      await page.waitForFunction(
        () => document.querySelectorAll('#plots .uplot canvas').length === 3,
      );
      const saved = await page.evaluate(() => window.karcherPaper.plots.measured);
      assert.ok(saved.convergence.length >= 96 && saved.roughness.length >= 40);
      await section.getByRole('button', { name: 'Measure here' }).click();
      await page.waitForFunction(() => window.karcherPaper.plots.measured.convergence.length > 0);
      await section.getByRole('button', { name: 'Cancel' }).click();
      assert.equal(await section.getByRole('status').textContent(), 'Cancelled.');
      await section.getByRole('button', { name: 'Measure here' }).click();
      await page.waitForFunction(() => window.karcherPaper.plots.settled);
      assert.equal(await section.getByRole('status').textContent(), 'Measured in your browser.');
      const { convergence, roughness } = await page.evaluate(
        () => window.karcherPaper.plots.measured,
      );
      assert.deepEqual([convergence.length, roughness.length], [9 * 2 * 2, 9 * 5]);
      assert.match(
        await section.locator('.panel-note').nth(1).textContent(),
        /^Order of convergence/,
      );
      assert.equal(await section.locator('.uplot canvas').count(), 3);
    },
  );

  test('curves of convergence take the width of their charts', async () => {
    const empty = await page.evaluate(() => {
      const { width, height } = document.querySelector('#plots .uplot canvas');
      const context = document.querySelector('#plots .uplot canvas').getContext('2d');
      const { data } = context.getImageData(0, 0, width, height);
      // Lines have colors; axes and grid are gray.
      const isColored = (k) => {
        const [r, g, b] = data.slice(k, k + 3);
        return data[k + 3] > 200 && Math.max(r, g, b) - Math.min(r, g, b) > 80;
      };
      let last = 0;
      for (let k = 0; k < data.length; k += 4)
        if (isColored(k)) last = Math.max(last, (k / 4) % width);
      return 1 - last / width;
    });
    assert.ok(empty < 0.25, `${empty} of the width is empty on the right`);
  });

  test('a table is not cut off at 1280 px, however long its numbers are', async () => {
    await open('resolution');
    await page.setViewportSize({ width: 1280, height: 800 });
    const beyond = await page.evaluate(() => {
      const numbers = document.querySelector('#resolution .numbers');
      const texts = ['12.68', '22.28', '0.0577', '309/512', '0.63', '−1·10⁻⁵', '14,586', '14,053'];
      for (const row of numbers.querySelectorAll('tbody tr')) {
        const cells = texts.map((text, k) => {
          const cell = document.createElement('td');
          const note = { 0: 'over 203/512', 3: 'own 132', 4: 'over 13/33' }[k];
          cell.append(text);
          if (note)
            cell.append(Object.assign(document.createElement('small'), { textContent: note }));
          return cell;
        });
        row.replaceChildren(row.firstElementChild, ...cells);
      }
      const timings = document.querySelector('#table .timings');
      for (const row of timings.querySelectorAll('tr[data-row]')) {
        for (const [k, cell] of [...row.querySelectorAll('[data-method]')].entries()) {
          const detail = ['10.3 MB', k < 6 ? 'as used 14,492' : 'fields 110', 'field 110'][k % 3];
          const small = Object.assign(document.createElement('small'), { textContent: detail });
          cell.replaceChildren('1,674', small);
        }
      }
      return [numbers, timings].map((box) => box.scrollWidth - box.clientWidth);
    });
    assert.deepEqual(beyond, [0, 0]);
  });

  test('figures use the width of the page', async () => {
    for (const width of [1280, 390]) {
      await page.setViewportSize({ width, height: 800 });
      const right = await page.evaluate(() =>
        [...document.querySelectorAll('section.figure')].map((section) => {
          const edges = [...section.children].map((child) => child.getBoundingClientRect().right);
          return [section.id, section.getBoundingClientRect().right - Math.max(...edges)];
        }),
      );
      for (const [id, left] of right) assert.ok(left < 2, `${id}: ${left} px at ${width}`);
      const captions = await page.evaluate(() =>
        [...document.querySelectorAll('.figure > .caption')].map(
          (caption) => innerWidth - caption.getBoundingClientRect().right,
        ),
      );
      for (const empty of captions) assert.ok(empty < 0.1 * width + 1, `${empty} px at ${width}`);
      const scroll = await page.evaluate(() => document.scrollingElement.scrollWidth);
      assert.equal(scroll, width);
    }
  });
});
