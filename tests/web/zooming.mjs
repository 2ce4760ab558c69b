// Zoom from the whole surface to a single triangle and back, by the wheel, two fingers or keys: the
// surface is in view at every step.
import assert from 'node:assert/strict';
import { touchOf } from './browser.mjs';

/** The most steps from the whole to a triangle. */
const mostSteps = 160;
/** Two fingers part from `together` to `apart` pixels, in `movesOfPinch` moves. */
const [together, apart, movesOfPinch] = [40, 150, 4];

/**
 * The surface at a place of the window, or else at the nearest place of a grid around it: its face,
 * the longest edge of the face in pixels, and the size of a pixel; null if no surface is visible.
 */
const sight = (tab, { x, y }) =>
  tab.page.evaluate(
    ([h, v]) => {
      const box = document.getElementById('stage').getBoundingClientRect();
      const page = window.karcherPage;
      const places = [[h, v]];
      for (let i = box.left + 5; i < box.right; i += 15) {
        for (let j = box.top + 5; j < box.bottom; j += 15) places.push([i, j]);
      }
      const far = ([i, j]) => (i - h) ** 2 + (j - v) ** 2;
      let best = page.under(h, v);
      if (!best) {
        places.sort((a, b) => far(a) - far(b));
        for (const [i, j] of places) {
          best = page.under(i, j);
          if (best) break;
        }
      }
      if (!best) return null;
      const { positions, triangles } = window.zoomed;
      const [a, b, c] = [0, 1, 2].map((k) => triangles[3 * best.face + k]);
      const length = (p, q) =>
        Math.hypot(...[0, 1, 2].map((k) => positions[3 * p + k] - positions[3 * q + k]));
      const edge = Math.max(length(a, b), length(b, c), length(c, a)) / best.pixel;
      const isThere = page.under(h, v) !== null;
      return { ...best, edge, isThere, shown: page.seen(best.place) };
    },
    [x, y],
  );

/** Steps in and out by each way, at a place of the window. */
export async function wayOf(tab, how, { x, y }) {
  const { page } = tab;
  if (how === 'wheel') {
    await page.mouse.move(x, y);
    return (inwards) => page.mouse.wheel(0, inwards ? -240 : 240);
  }
  if (how === 'keys') {
    await page.locator('#stage').focus();
    return (inwards) => page.keyboard.press(inwards ? '+' : '-');
  }
  const { touch } = await touchOf(page);
  const fingers = (width) => [
    { x: x - width / 2, y },
    { x: x + width / 2, y },
  ];
  return async (inwards) => {
    const [from, to] = inwards ? [together, apart] : [apart, together];
    await touch('touchStart', ...fingers(from));
    for (let i = 1; i <= movesOfPinch; i++) {
      await touch('touchMove', ...fingers(from + ((to - from) * i) / movesOfPinch));
    }
    await touch('touchEnd');
  };
}

/** Zooms in at a place until the triangle there is as large as the stage, and out again. */
export async function zoomThrough(tab, how, at) {
  const step = await wayOf(tab, how, at);
  await tab.page.evaluate(async () => {
    window.zoomed ??= await window.karcherPage.mesh();
  });
  const { width, height } = await tab.page.locator('#stage').boundingBox();
  const first = await sight(tab, at);
  assert.ok(first, `${how}: the surface is in view`);
  let last = first;
  let count = 0;
  const told = (what) => `${how}, step ${count}: ${what}`;
  for (; last.edge < Math.min(width, height); count++) {
    assert.ok(count < mostSteps, told(`the triangle is still only ${last.edge} pixels large`));
    await step(true);
    await tab.still();
    const now = await sight(tab, at);
    assert.ok(now, told('no surface is in view'));
    const gap = now.shown ? Math.hypot(now.shown.x - at.x, now.shown.y - at.y) : Infinity;
    assert.ok(gap < Math.max(width, height), told('the surface is behind the camera'));
    // Beside the surface its nearest place may change.
    if (now.isThere && last.isThere) {
      assert.ok(now.pixel < last.pixel, told(`it is stuck: a pixel is ${now.pixel}`));
      // A zoom through the surface would reach another sheet.
      const moved = Math.hypot(...now.place.map((value, axis) => value - last.place[axis]));
      assert.ok(moved < 40 * last.pixel, told(`it moved by ${moved / last.pixel} pixels`));
    }
    last = now;
  }
  const near = count;
  for (count = 0; count < near; count++) {
    await step(false);
    await tab.still();
    const now = await sight(tab, at);
    assert.ok(now, told('on the way back no surface is in view'));
    const isStuck = now.isThere && last.isThere && now.pixel <= last.pixel;
    assert.ok(!isStuck, told('on the way back it is stuck'));
    last = now;
  }
  assert.ok(last.pixel > 0.9 * first.pixel, told(`back, a pixel is ${last.pixel}`));
  return near;
}
