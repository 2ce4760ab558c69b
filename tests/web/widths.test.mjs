// Widths in pixels are constant, widths in the surface's unit scale with the view; opacity is
// uniform along a line.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

describe('looks of lines', () => {
  const browser = browserOfSuite({ viewport: { width: 1280, height: 800 }, asUsers: true });

  async function type(tab, id, text) {
    await tab.page.locator(id).fill(text);
    await tab.page.keyboard.press('Enter');
    await tab.page.locator(id).blur();
    await tab.settled();
  }

  /** The colors in a column of the stage, up and down from its middle, at a distance `aside`. */
  async function column(tab, aside, half) {
    await tab.still();
    const { x, y } = await tab.middle();
    const clip = { x: x + aside, y: y - half, width: 1, height: 2 * half };
    return tab.pixels(clip);
  }

  /** The number of red pixels of a column. */
  const thickness = (colors) => colors.filter(([r, g, b]) => r > 120 && g < 90 && b < 90).length;

  async function redLine(tab) {
    await tab.click([-140, 0], [140, 0]);
    await tab.page.locator('#color').fill('#ff0000');
    await tab.settled();
    await tab.page.keyboard.press('Escape');
    await tab.page.keyboard.press('Escape');
  }

  /** The distance of the line's ends in the window. */
  async function span(tab) {
    const { polyline } = await tab.view();
    const ends = [polyline.slice(0, 3), polyline.slice(-3)];
    const [a, b] = await tab.page.evaluate(
      (places) => places.map((place) => window.karcherPage.seen(Float32Array.from(place))),
      ends,
    );
    return Math.hypot(a.x - b.x, a.y - b.y);
  }

  test('a width in pixels stays when the camera comes near, one in the unit grows with the surface', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:grid:200&kind=polyline');
    await redLine(tab);
    await tab.page.keyboard.press('v');
    await tab.page.locator('#objects .object').first().click();
    await type(tab, '#width', '12');
    const { x, y } = await tab.middle();
    const measured = async () => [thickness(await column(tab, 20, 120)), await span(tab)];
    const [before, far] = await measured();
    assert.ok(Math.abs(before - 12) <= 2, `${before}`);
    await tab.page.locator('#width-unit').selectOption('surface');
    await tab.settled();
    const [same] = await measured();
    assert.ok(Math.abs(same - before) <= 2, `it is as wide as it was: ${same}, ${before}`);
    await type(tab, '#width', `${Number(await tab.page.locator('#width').inputValue()) * 2}`);
    const [wide] = await measured();
    assert.ok(Math.abs(wide - 2 * before) <= 3, `${wide}`);
    await tab.page.mouse.move(x, y);
    for (let notch = 0; notch < 10; notch++) {
      await tab.page.mouse.wheel(0, -120);
      await tab.still();
    }
    const [near, large] = await measured();
    const grown = large / far;
    assert.ok(grown > 1.5, `${grown}`);
    assert.ok(Math.abs(near / wide - grown) < 0.12 * grown, `${near / wide} beside ${grown}`);
    await tab.page.locator('#width-unit').selectOption('pixels');
    await type(tab, '#width', '12');
    const [pixels] = await measured();
    assert.ok(Math.abs(pixels - before) <= 2, `${pixels}`);
    await tab.close();
  });

  test('a width in the unit lies on the surface: from the side it is foreshortened with it', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:grid:200&kind=polyline');
    await redLine(tab);
    await tab.page.keyboard.press('v');
    await tab.page.locator('#objects .object').first().click();
    await tab.page.locator('#width-unit').selectOption('surface');
    await type(tab, '#width', `${Number(await tab.page.locator('#width').inputValue()) * 8}`);
    const straight = thickness(await column(tab, 10, 120));
    const { x, y } = await tab.middle();
    await tab.page.keyboard.down('Alt');
    await tab.drag({ x, y: y - 60 }, { x, y: y + 40 });
    await tab.page.keyboard.up('Alt');
    const slanted = thickness(await column(tab, 10, 120));
    assert.ok(straight > 20, `${straight}`);
    assert.ok(slanted > 4 && slanted < 0.95 * straight, `${slanted} of ${straight}`);
    await tab.close();
  });

  test('a transparent line is equally opaque where it crosses itself, and in files', async () => {
    const tab = await Tab.open(browser, 'mesh=plane:grid:200&kind=polyline');
    await tab.click([-80, -60], [80, 60], [80, -60], [-80, 60]);
    await tab.page.locator('#color').fill('#ff0000');
    await type(tab, '#width', '20');
    await tab.page.keyboard.press('v');
    const crossing = async () => (await column(tab, 0, 4))[4];
    const opaque = await crossing();
    await type(tab, '#opacity', '50');
    // Escape removes the line's anchors and the legs between them.
    for (let times = 0; times < 2; times++) await tab.page.keyboard.press('Escape');
    await tab.settled();
    const crossed = await crossing();
    // The column lies on the same stretch, away from the crossing and from handles.
    const once = (await column(tab, -48, 60)).find(([r, g]) => r > 1.2 * g);
    assert.ok(crossed[1] > opaque[1] + 40, `the surface shows: ${crossed}, ${opaque}`);
    const apart = Math.max(...crossed.map((value, i) => Math.abs(value - once[i])));
    assert.ok(apart < 12, `${crossed} beside ${once}`);
    const svg = await tab.save('SVG');
    assert.match(svg.text, /<g id="object-1" opacity="0.5">/);
    await tab.pastSaving();
    await tab.page.reload();
    await tab.settled();
    const { opacity, width, onSurface } = (await tab.state()).drawing.objects[0];
    assert.deepEqual({ opacity, width, onSurface }, { opacity: 0.5, width: 20, onSurface: false });
    await tab.close();
  });
});
