import type { LongWorkOptions, MeshInfo } from 'karcher';
import {
  type CheckedSurface,
  type CheckedUp,
  mostPlaces,
  outlineLength,
} from '../model/checked_up';
import { byId, formatCount, formatInteger, make } from './elements';
import { sentenceOf } from './messages';
import { showProgress } from './progress';

/**
 * A check-up of the surface. It runs when the user opens the panel, and shows its findings and
 * their places.
 */
export class CheckUpPanel {
  readonly #details = byId<HTMLDetailsElement>('checkup');
  readonly #found = byId('checkup-found');
  #client: CheckedSurface | null = null;
  /** The surface that the last check examined, or that the present one examines. */
  #checked: CheckedSurface | null = null;
  #shown: HTMLButtonElement | null = null;

  /**
   * `check` examines a surface. `showPlaces` replaces the outlines on the surface by others, with
   * x, y, z of each point. `weld` reads the surface's file again with a tolerance.
   */
  constructor(
    private readonly check: (surface: CheckedSurface, work: LongWorkOptions) => Promise<CheckedUp>,
    private readonly showPlaces: (places: readonly Float32Array[]) => void,
    private readonly weld: (tolerance: number) => void,
  ) {
    this.#details.addEventListener('toggle', () => {
      if (this.#details.open) void this.#check();
      else this.#toggle(null, []);
    });
  }

  /**
   * Sets the surface to check. If it is another surface, or the same one in another form, discards
   * the findings, and checks again if the panel is open.
   */
  show(client: CheckedSurface): void {
    this.#client = client;
    this.#toggle(null, []);
    if (client === this.#checked) return;
    this.#checked = null;
    this.#found.replaceChildren();
    if (this.#details.open) void this.#check();
  }

  async #check(): Promise<void> {
    const client = this.#client;
    if (!client || client === this.#checked) return;
    this.#checked = client;
    const controller = new AbortController();
    const progress = showProgress('Checking the surface', () => controller.abort());
    try {
      const found = await this.check(client, {
        progress: (done) => progress.set(done, 'Checking the surface'),
        signal: controller.signal,
      });
      if (client === this.#checked) this.#show(found, client.info);
    } catch (error) {
      if (client !== this.#checked) return;
      this.#checked = null;
      // After a cancel, the panel closes. Another check starts when the user opens it again.
      if (controller.signal.aborted) this.#details.open = false;
      else this.#found.replaceChildren(make('p', sentenceOf(error)));
    } finally {
      progress.hide();
    }
  }

  #show(found: CheckedUp, { diagonal }: Readonly<MeshInfo>): void {
    const { shortestEdge, longestEdge, smallestAngle, largestAngle } = found;
    const facts = make('dl', '', { className: 'facts' });
    for (const [name, value] of [
      ['Edges', `${shortestEdge.toPrecision(3)} to ${longestEdge.toPrecision(3)}`],
      ['Angles', `${degrees(smallestAngle)} to ${degrees(largestAngle)}`],
    ] as const) {
      facts.append(make('dt', name), make('dd', value));
    }
    const { needles, caps, boundary, nearBoundaries: near, outlines } = found;
    const rows = [
      this.#row(needles.length, 'needle', () => parts(outlines.needles, outlineLength)),
      this.#row(caps.length, 'cap', () => parts(outlines.caps, outlineLength)),
      this.#row(boundary.length / 6, 'boundary edge', () => parts(boundary, 6)),
      this.#row(
        near ? near.places.length / 3 : 0,
        'vertex on a boundary that lies on another',
        () => dots(near!.places, diagonal),
        'vertices on boundaries that lie on others',
      ),
    ].filter((row) => row !== null);
    if (near && this.#client?.file) rows.at(-1)!.append(this.#weldButton(near.weld));
    const list = make('ul', '', { className: 'checkup-rows' });
    list.append(...rows);
    const expected = make('ul', '', { className: 'notes' });
    expected.append(...found.expected.map((sentence) => make('li', sentence)));
    this.#found.replaceChildren(facts, ...(rows.length > 0 ? [list] : []), expected);
  }

  /** A button that joins boundaries that are no farther apart than a tolerance. */
  #weldButton(tolerance: number): HTMLButtonElement {
    const button = make('button', 'Weld', { type: 'button', className: 'link' });
    button.title = `Read the file again and join what is up to ${tolerance} apart`;
    button.addEventListener('click', () => this.weld(tolerance));
    return button;
  }

  /**
   * A row with the number of findings and a button that shows their places; null without findings.
   */
  #row(count: number, one: string, lines: () => Float32Array[], many = `${one}s`) {
    if (count === 0) return null;
    const row = make('li');
    const button = make('button', 'Show', { type: 'button', className: 'link' });
    button.setAttribute('aria-pressed', 'false');
    button.setAttribute('aria-label', `Show ${formatCount(count, one, many)}`);
    if (count > mostPlaces) button.title = `The first ${formatInteger(mostPlaces)} are shown`;
    button.addEventListener('click', () => {
      if (this.#shown === button) this.#toggle(null, []);
      else this.#toggle(button, lines());
    });
    row.append(make('span', formatCount(count, one, many)), button);
    return row;
  }

  #toggle(button: HTMLButtonElement | null, places: readonly Float32Array[]): void {
    this.#shown?.setAttribute('aria-pressed', 'false');
    this.#shown = button;
    button?.setAttribute('aria-pressed', 'true');
    this.showPlaces(places);
  }
}

const degrees = (angle: number) => `${Number(angle.toPrecision(3))}°`;

/** Splits an array into at most `mostPlaces` lines, each of `length` numbers. */
function parts(lines: Float32Array | Float64Array, length: number): Float32Array[] {
  const count = Math.min(mostPlaces, lines.length / length);
  return Array.from({ length: count }, (_, i) =>
    Float32Array.from(lines.subarray(length * i, length * (i + 1))),
  );
}

/** Short lines that look like dots, at the first `mostPlaces` of these places. */
function dots(places: Float64Array, diagonal: number): Float32Array[] {
  const count = Math.min(mostPlaces, places.length / 3);
  return Array.from({ length: count }, (_, i) => {
    const [x, y, z] = places.subarray(3 * i, 3 * i + 3);
    return Float32Array.of(x!, y!, z!, x! + 1e-4 * diagonal, y!, z!);
  });
}
