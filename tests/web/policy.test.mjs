// The Content-Security-Policy of the built pages allows their own work, and nothing else.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { browserOfSuite, Tab } from './browser.mjs';

describe('the policy of the pages', () => {
  const browser = browserOfSuite();

  /** The page's reaction to an inline script, and to a request and an image from another host. */
  const tried = (page) =>
    page.evaluate(async () => {
      const refused = [];
      document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) => {
        refused.push(effectiveDirective);
      });
      const script = document.createElement('script');
      script.textContent = 'window.ran = true';
      document.body.append(script);
      const answer = await fetch('https://elsewhere.invalid/').then(
        () => 'answered',
        () => 'refused',
      );
      const image = new Image();
      const seen = new Promise((resolve) => {
        image.onload = () => resolve('seen');
        image.onerror = () => resolve('refused');
      });
      image.src = 'https://elsewhere.invalid/x.png';
      return { ran: window.ran === true, answer, image: await seen, refused: refused.sort() };
    });

  test('allows the editor to trace, and no script or host from outside', async () => {
    const tab = await Tab.open(browser);
    await tab.click([-110, 40], [-40, -10], [40, 50], [110, -10]);
    assert.equal((await tab.view()).curve.samples.count, 128);
    assert.deepEqual(tab.logged, [], 'the page itself breaks no rule');
    assert.deepEqual(await tried(tab.page), {
      ran: false,
      answer: 'refused',
      image: 'refused',
      refused: ['connect-src', 'img-src', 'script-src-elem'],
    });
    await tab.page.close();
  });

  test('is on the Paper page, too', async () => {
    const page = await browser.context.newPage();
    await page.goto(`${browser.address}paper.html`);
    const policy = await page
      .locator('meta[http-equiv="Content-Security-Policy"]')
      .getAttribute('content');
    assert.match(policy, /script-src 'self' 'wasm-unsafe-eval';/);
    assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'/);
    await page.close();
  });
});
