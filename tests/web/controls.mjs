// A search for the clickable controls of any page, and a check that clicks hit them.
import assert from 'node:assert/strict';

/** Clickable elements except the handles on the stage, which users drag and which may overlap. */
const controls = 'button, select, input, textarea, summary, a[href]';
const apart = '.stage, .handle, noscript';

/** Adds `window.reach` to a page, which finds the page's controls and where to click them. */
function install([all, without]) {
  /**
   * A name that is independent of the words, and of a new rendering of the control. The controls of
   * a list share a name.
   */
  const nameOf = (element) => {
    if (element.id) return `#${element.id}`;
    const { localName, className, name, value, dataset } = element;
    const which = name ? `${name} ${value}` : (dataset.save ?? className);
    return `${localName} '${which}' in #${element.parentElement.closest('[id]')?.id}`;
  };

  /** Users click the label of an invisible input. */
  const isUnseen = (element) => getComputedStyle(element).opacity === '0';

  const middle = ({ left, right, top, bottom }) => ({
    x: (left + right) / 2,
    y: (top + bottom) / 2,
  });

  /** The elements where a user would click a control. */
  const targetsOf = (element) => {
    const label = element.labels?.[0];
    const targets = label && element.localName === 'input' && isUnseen(element) ? [] : [element];
    if (!label || !['checkbox', 'radio'].includes(element.type)) return targets;
    const words = document.createRange();
    words.selectNodeContents(label);
    if (label.contains(element)) words.setStartAfter(element);
    return [...targets, words];
  };

  const isScroller = (element) =>
    /auto|scroll/.test(getComputedStyle(element).overflowY) &&
    element.scrollHeight > element.clientHeight;

  /** Scrolls the areas that a wheel or a finger would, until the middle of a target is visible. */
  const bringIntoView = (element, target) => {
    for (let box = element.parentElement; box; box = box.parentElement) {
      const { y } = middle(target.getBoundingClientRect());
      if (box === document.documentElement) {
        if (getComputedStyle(document.body).overflowY === 'hidden') continue;
        // Scrolls to the middle, away from elements that stay at an edge.
        window.scrollBy({ top: y - innerHeight / 2, behavior: 'instant' });
      } else if (isScroller(box)) {
        const { top, bottom } = box.getBoundingClientRect();
        if (y > top + 4 && y < bottom - 4) continue;
        box.scrollBy({ top: y - (top + bottom) / 2, behavior: 'instant' });
      }
    }
  };

  const isOfIt = (element, hit) =>
    element.contains(hit) || [...(element.labels ?? [])].some((label) => label.contains(hit));

  const told = (hit) => (hit ? `${hit.localName}${hit.id && `#${hit.id}`}.${hit.className}` : 'no');

  /** The element in front, which receives the clicks. */
  const front = () =>
    document.querySelector('dialog:modal, :popover-open, .tour:not([hidden])') ?? document;

  const visible = () =>
    [...front().querySelectorAll(all)].filter(
      (element) =>
        !element.closest(without) &&
        element.checkVisibility({ visibilityProperty: true }) &&
        element.getBoundingClientRect().width > 0,
    );

  const panels =
    '.group, [role="toolbar"], [role="menu"], dialog, .tour, .notices, .status, .messages, .site-head, .figure';
  const panelOf = (element) => {
    const panel = element.closest(panels);
    return panel && (panel.id || panel.className);
  };

  window.reach = {
    visible,
    /** All controls, visible or not. */
    names: () =>
      [...document.querySelectorAll(all)]
        .filter((element) => !element.closest(without) && element.type !== 'file')
        .map(nameOf),
    panels: () =>
      [...document.querySelectorAll(panels)].map((panel) => panel.id || panel.className),
    /** The visible controls, each with the element that a click hits instead, if it misses. */
    look: () =>
      visible().map((element) => {
        const covered = targetsOf(element).flatMap((target) => {
          bringIntoView(element, target);
          const { x, y } = middle(target.getBoundingClientRect());
          const hit = document.elementFromPoint(x, y);
          return hit && isOfIt(element, hit)
            ? []
            : [`${told(hit)} is at ${Math.round(x)}, ${Math.round(y)}`];
        });
        return { name: nameOf(element), panel: panelOf(element), covered };
      }),
    /** The places in the window where a user clicks a visible control. */
    placesOf(element) {
      if (!visible().includes(element)) throw new Error(`${nameOf(element)} is not seen`);
      return targetsOf(element).map((target) => {
        bringIntoView(element, target);
        return middle(target.getBoundingClientRect());
      });
    },
    /**
     * From here on clicks only report whether they hit the control of that name. Returns the number
     * of the control's places, or null if it no longer exists.
     */
    arm(name) {
      const element = visible().find((one) => nameOf(one) === name);
      if (!element) return null;
      const hits = [];
      const watch = (event) => {
        event.preventDefault();
        event.stopImmediatePropagation();
        if (event.type === 'pointerdown') hits.push(isOfIt(element, event.target));
      };
      const events = ['pointerdown', 'mousedown', 'pointerup', 'mouseup', 'click', 'dblclick'];
      for (const type of events) window.addEventListener(type, watch, { capture: true });
      Object.assign(window.reach, {
        place: (which) => window.reach.placesOf(element)[which],
        hits: () => hits.splice(0),
        disarm() {
          for (const type of events) window.removeEventListener(type, watch, { capture: true });
        },
      });
      return targetsOf(element).length;
    },
  };
}

/** The controls of a page, as they appear in its states. */
export class Controls {
  /** The names of the controls that clicks have hit. */
  reached = new Set();
  panels = new Set();
  constructor(page) {
    this.page = page;
  }

  async install() {
    await this.page.evaluate(install, [controls, apart]);
  }

  /**
   * Looks at all visible controls, and fails if a click misses one. The mouse clicks new ones,
   * without effect. Returns their number.
   */
  async look(state) {
    const seen = await this.page.evaluate(() => window.reach.look());
    const covered = seen.filter((one) => one.covered.length > 0);
    assert.deepEqual(
      covered.map((one) => `${one.name}: ${one.covered.join('; ')}`),
      [],
      `${state}: something else is on top`,
    );
    for (const { name, panel } of seen) {
      if (this.reached.has(name)) continue;
      const isHit = await this.#isHit(name);
      // The next look covers a control that a late answer removed.
      if (isHit === null) continue;
      assert.ok(isHit, `${state}: a click hits ${name}`);
      this.reached.add(name);
      if (panel) this.panels.add(panel);
    }
    return seen.length;
  }

  /** Whether clicks hit the control; null if it no longer exists. */
  async #isHit(name) {
    const { page } = this;
    const count = await page.evaluate((one) => window.reach.arm(one), name);
    if (count === null) return null;
    const hits = [];
    for (let which = 0; which < count; which++) {
      const { x, y } = await page.evaluate((one) => window.reach.place(one), which);
      await page.mouse.click(x, y);
      hits.push(...(await page.evaluate(() => window.reach.hits())));
    }
    await page.evaluate(() => window.reach.disarm());
    return hits.length === count && hits.every((hit) => hit);
  }

  /** Clicks the middle of a control as a user would, or its words if it has a place for both. */
  async click(locator, { words } = { words: false }) {
    const places = await locator.evaluate((element) => window.reach.placesOf(element));
    const { x, y } = places.at(words ? -1 : 0);
    await this.page.mouse.click(x, y);
  }
}
