import type { MeshInfo } from 'karcher';
import type { FileInfo } from 'karcher/formats';
import {
  detailLabels,
  meshLabel,
  parseKey,
  type Reading,
  readingOf,
  samples,
  type UpAxis,
} from '../model/meshes';
import { byId, formatCount, formatInteger, make, write } from './elements';

export interface SurfaceEvents {
  choose(key: string): void;
  /** Opens files that belong together, in any order. */
  openFiles(files: readonly File[]): void;
  /** Reads the file again, with these options in place of the present ones. */
  reread(part: Partial<Reading>): void;
}

/** The largest number of parts in a menu: a longer menu is useless. */
const mostParts = 1000;

/** The panel's facts about a surface. */
export interface ShownSurface {
  info: MeshInfo;
  /** The facts about the surface's file; null if the surface does not come from a file. */
  file: FileInfo | null;
  /** The axis that seems to point up. */
  up: UpAxis;
}

/** The engine's count in the page's number format. */
const grouped = (count: string) => formatInteger(Number(count));

/**
 * The actions at a face of a surface whose file has several parts: to show only the face's part, or
 * all parts again. The menu of parts offers the same.
 */
export function partActions(
  key: string,
  file: FileInfo | null,
  face: number | null,
  reread: (part: Partial<Reading>) => void,
): readonly [name: string, act: () => void][] {
  const reading = readingOf(key);
  if (!file || !reading || file.parts.length < 2) return [];
  const show = (parts: readonly number[] | null) => () => reread({ parts, weld: null });
  if (reading.parts) return [[`Show all ${formatInteger(file.parts.length)} parts`, show(null)]];
  const part = face === null ? undefined : file.partOf?.[face];
  const name = part === undefined ? undefined : file.parts[part]?.name;
  return part === undefined || name === undefined ? [] : [[`Show only ${name}`, show([part])]];
}

/** The surface's menu, its details and its facts. It also takes files dropped on the page. */
export class SurfacePanel {
  readonly #surface = byId<HTMLSelectElement>('surface');
  readonly #detail = byId<HTMLSelectElement>('detail');
  readonly #file = byId<HTMLInputElement>('file');
  readonly #part = byId<HTMLSelectElement>('part');
  readonly #up = byId<HTMLSelectElement>('up');
  #key = '';

  constructor(private readonly events: SurfaceEvents) {
    for (const { id, label } of samples) this.#surface.append(make('option', label, { value: id }));
    this.#surface.addEventListener('change', () => this.#chooseSurface());
    this.#detail.addEventListener('change', () => {
      events.choose(`${this.#key.split(':')[0]}:${this.#detail.value}`);
    });
    byId('open').addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const files = [...(this.#file.files ?? [])];
      this.#file.value = '';
      if (files.length > 0) events.openFiles(files);
    });
    this.#part.addEventListener('change', () => {
      const parts = this.#part.value === '' ? null : [Number(this.#part.value)];
      events.reread({ parts, weld: null });
    });
    this.#up.addEventListener('change', () => {
      events.reread({ up: this.#up.value as UpAxis });
    });
    this.#takeDrops();
  }

  /** Shows the name of the surface on the stage. It also resets the menu after a failed choice. */
  show(key: string, { info, file, up }: ShownSurface): void {
    this.#key = key;
    const parsed = parseKey(key);
    this.#surface.querySelector('[data-file]')?.remove();
    this.#detail.replaceChildren();
    this.#detail.disabled = !parsed || !('sample' in parsed);
    if (parsed && 'sample' in parsed) {
      this.#surface.value = parsed.sample.id;
      this.#fillDetails(parsed.sample.details, parsed.detail);
    } else {
      const option = make('option', meshLabel(key), { value: key });
      option.dataset.file = '';
      this.#surface.append(option);
      this.#surface.value = key;
      this.#detail.append(make('option', 'As is'));
    }
    this.#showReading(file, up);
    this.#showFacts(info, file?.notRead ?? []);
  }

  /** The options for reading a file: its parts, if it has several, and the axis that points up. */
  #showReading(file: FileInfo | null, up: UpAxis): void {
    const reading = readingOf(this.#key);
    byId('reading').hidden = !file || !reading;
    if (!file || !reading) return;
    const parts = file.parts
      .slice(0, mostParts)
      .map(({ name, triangles }, i) =>
        make('option', `${name} · ${formatInteger(triangles)}`, { value: `${i}` }),
      );
    const all = make('option', `All ${formatInteger(file.parts.length)} parts`, { value: '' });
    this.#part.replaceChildren(all, ...parts);
    this.#part.disabled = file.parts.length < 2;
    if (file.parts.length < 2) this.#part.replaceChildren(make('option', 'One part'));
    else this.#part.value = reading.parts ? `${reading.parts[0]}` : '';
    this.#up.value = reading.up ?? up;
  }

  #fillDetails(details: readonly number[], detail: number): void {
    const options = details.map((value, i) =>
      make('option', detailLabels[i], { value: `${value}` }),
    );
    if (!details.includes(detail)) options.push(make('option', 'Custom', { value: `${detail}` }));
    this.#detail.append(...options);
    this.#detail.value = `${detail}`;
  }

  #showFacts(info: MeshInfo, notRead: readonly string[]): void {
    const line = [formatCount(info.triangles, 'triangle')];
    if (info.boundaryLoops > 0) {
      line.push(formatCount(info.boundaryLoops, 'boundary', 'boundaries'));
    } else line.push(`genus ${formatInteger(info.genus)}`);
    write(byId('facts-line'), line.join(', '));
    const facts: [string, string][] = [
      ['Triangles', formatInteger(info.triangles)],
      ['Vertices', formatInteger(info.vertices)],
      ['Genus', formatInteger(info.genus)],
    ];
    if (info.boundaryLoops > 0) facts.push(['Boundaries', formatInteger(info.boundaryLoops)]);
    if (info.components > 1) facts.push(['Components', formatInteger(info.components)]);
    const terms = facts.flatMap(([name, value]) => [make('dt', name), make('dd', value)]);
    byId('facts').replaceChildren(...terms);
    const repairs = byId('repairs');
    const notes = [
      ...notRead,
      ...info.repairs.map(({ message }) => message.replace(/^\d+/, grouped)),
    ];
    repairs.hidden = notes.length === 0;
    repairs.replaceChildren(...notes.map((note) => make('li', note)));
  }

  #chooseSurface(): void {
    const sample = samples.find(({ id }) => id === this.#surface.value);
    if (!sample) return;
    const before = parseKey(this.#key);
    const level = before && 'sample' in before ? before.sample.details.indexOf(before.detail) : 1;
    this.events.choose(`${sample.id}:${sample.details[Math.max(0, level)]}`);
  }

  #takeDrops(): void {
    const drop = byId('drop');
    const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
    window.addEventListener('dragover', (event) => {
      if (!carriesFile(event)) return;
      event.preventDefault();
      drop.hidden = false;
    });
    window.addEventListener('dragleave', (event) => {
      if (!event.relatedTarget) drop.hidden = true;
    });
    window.addEventListener('drop', (event) => {
      drop.hidden = true;
      if (!carriesFile(event)) return;
      event.preventDefault();
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length > 0) this.events.openFiles(files);
    });
  }
}
