import type { MeshInfo } from 'karcher';
import { detailLabels, meshLabel, parseKey, samples } from '../model/meshes';
import { byId, formatInteger, make } from './elements';

export interface SurfaceEvents {
  choose(key: string): void;
  openFile(file: File): void;
}

/** The surface's menu, its details and its facts; also takes files that are dropped on the page. */
export class SurfacePanel {
  readonly #surface = byId<HTMLSelectElement>('surface');
  readonly #detail = byId<HTMLSelectElement>('detail');
  readonly #file = byId<HTMLInputElement>('file');
  #key = '';

  constructor(private readonly events: SurfaceEvents) {
    for (const { id, label } of samples) this.#surface.append(make('option', label, { value: id }));
    this.#surface.addEventListener('change', () => this.#chooseSurface());
    this.#detail.addEventListener('change', () => {
      events.choose(`${this.#key.split(':')[0]}:${this.#detail.value}`);
    });
    byId('open').addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const file = this.#file.files?.[0];
      this.#file.value = '';
      if (file) events.openFile(file);
    });
    this.#takeDrops();
  }

  /** Shows which surface is on the stage; also takes a menu back whose choice came to nothing. */
  show(key: string, info: MeshInfo): void {
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
    this.#showFacts(info);
  }

  #fillDetails(details: readonly number[], detail: number): void {
    const options = details.map((value, i) =>
      make('option', detailLabels[i], { value: `${value}` }),
    );
    if (!details.includes(detail)) options.push(make('option', 'Custom', { value: `${detail}` }));
    this.#detail.append(...options);
    this.#detail.value = `${detail}`;
  }

  #showFacts(info: MeshInfo): void {
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
    repairs.hidden = info.repairs.length === 0;
    repairs.replaceChildren(...info.repairs.map(({ message }) => make('li', message)));
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
      const file = event.dataTransfer?.files[0];
      if (file) this.events.openFile(file);
    });
  }
}
