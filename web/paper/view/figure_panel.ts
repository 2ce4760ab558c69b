import { Color } from 'three';
import { madeKey, meshLabel } from '../../model/meshes';
import { formatCount, make } from '../../panels/elements';
import { lineStyles, numbersOf } from '../figures/lines';
import { panelTitle } from '../figures/titles';
import type {
  CurveSpec,
  LineId,
  LineNumbers,
  LineResult,
  MeshSpec,
  Panel,
  Vector,
} from '../figures/types';
import type { LabClient } from '../lab/client';
import type { DrawnMesh, Placed } from '../lab/protocol';
import { expectedTriangles } from '../table/rows';
import { CenterSearch } from './center_search';
import { download } from './download';
import { editorLink, noSuchWeights } from './editor_link';
import type { GeometryMaker } from './geometry';
import { Loupe } from './loupe';
import { NumbersTable, type SavedNumbers } from './numbers_table';
import { type Dot, showDots } from './panel_markers';
import { PanelPoints } from './panel_points';
import { panelSvg } from './panel_svg';
import { type LineLook, PanelView } from './panel_view';
import type { SharedRenderer } from './shared_renderer';
import { sliders, stretchSlider } from './sliders';
import { lineColor, surfaceFront } from './theme_colors';
import type { Turns } from './turns';

export interface PanelContext {
  client: LabClient;
  turns: Turns;
  geometry: GeometryMaker;
  renderer: SharedRenderer;
}

export interface PanelEvents {
  /** The listener for the end of all measurements. */
  measured(): void;
  /** The listener for a point of the panel that the reader moved to a place in space. */
  move(index: number, place: Vector): void;
}

/** A panel on the page: its view, its points, and the table of its numbers. */
export class FigurePanel {
  readonly element = make('article', '', { className: 'panel-card' });
  /** Whether everything that the panel shows is up to date; tests wait for it. */
  settled = false;
  readonly #stage = make('div', '', { className: 'panel-stage' });
  readonly #markers = make('div', '', { className: 'markers' });
  readonly #note = make('p', '', { className: 'panel-note' });
  /** The words in place of a surface that is not ready. */
  readonly #making = make('p', '', { className: 'making' });
  readonly #link = make('a', 'Open in the editor', { className: 'link', hidden: true });
  readonly #noLink = make('span', `Not in the editor: ${noSuchWeights}`, {
    className: 'no-link',
    hidden: true,
  });
  readonly #title = make('h3');
  readonly #size = make('span', '', { className: 'panel-mesh' });
  readonly #view: PanelView;
  readonly #handles: PanelPoints;
  readonly #loupe: Loupe;
  readonly #centers: CenterSearch;
  readonly #numbers: NumbersTable;
  readonly #shown: Set<LineId>;
  /** The results of lines, for the current points and curve except for lines in `#waiting`. */
  readonly #results = new Map<LineId, LineResult>();
  /** Requested lines that have not arrived yet. Their old results belong to earlier points. */
  readonly #waiting = new Set<LineId>();
  /** Lines that have arrived without their measurement by exact paths. */
  readonly #unmeasured = new Set<LineId>();
  #curve: CurveSpec;
  #spec: MeshSpec;
  #mesh: DrawnMesh | null = null;
  #placed: Placed | null = null;
  #points: readonly Vector[];
  #stop: (() => void) | null = null;
  #dragging: AbortController | null = null;
  readonly #dragButton = make('button', 'Drag', {
    className: 'link',
    type: 'button',
    title: 'Drags a control point in small steps, and tells how far the curves leap',
  });
  #placedOnce = false;

  constructor(
    private readonly context: PanelContext,
    private readonly panel: Panel,
    points: readonly Vector[],
    private readonly events: PanelEvents,
    /** Earlier measurements, which the panel shows until it has its own. */
    saved: SavedNumbers | null = null,
  ) {
    this.#points = points;
    this.#curve = panel.curve;
    this.#centers = new CenterSearch(context.client, () => this.#placeMarkers());
    this.#dragButton.addEventListener('click', () => void this.#dragAll());
    this.#spec = panel.mesh;
    this.#shown = new Set(panel.lines.filter((id) => !panel.off?.includes(id)));
    const canvas = make('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    const layer = make('div', '', { className: 'handles' });
    this.#stage.append(canvas, this.#markers, layer, this.#making);
    this.#view = new PanelView(context.renderer, this.#stage, canvas, panel);
    this.#handles = new PanelPoints(this.#view, layer, panel, (index, place) => {
      this.#handles.show((this.#placed?.places ?? []).with(index, place));
      this.events.move(index, place);
    });
    this.#numbers = new NumbersTable(panel, this.#shown, (id, shown) => this.#toggle(id, shown));
    this.#view.onFrame(() => this.#placeMarkers());
    this.#loupe = new Loupe(this.#stage, this.#view, {
      dots: () => this.#dots(),
      first: () => this.#placeToCompare(),
    });
    if (saved) this.#numbers.showSaved(saved.lines, saved.origin);
    this.element.append(this.#head(), this.#stage, this.#note, this.#centers.element);
    const controls = [
      sliders(panel.curve, (curve) => this.#setCurve(curve)),
      stretchSlider(panel.mesh, (mesh) => void this.#setMesh(mesh)),
    ];
    for (const control of controls) if (control) this.element.append(control);
    this.element.append(this.#numbers.element, this.#foot());
    this.element.dataset.panel = panel.id;
  }

  /** Computes everything when the panel's turn comes. */
  start(): void {
    this.#making.textContent = `Waits for its turn: ${meshWords(this.#spec)}`;
    this.context.turns.ask({ element: this.#stage, run: (signal) => this.#run(signal) });
  }

  async #run(signal: AbortSignal): Promise<void> {
    if (!this.#mesh) await this.#makeMesh();
    if (!this.#mesh || signal.aborted) return;
    signal.addEventListener('abort', () => this.#stop?.());
    await this.#trace(this.#missing());
  }

  /** The shown lines that have no result, or none with its measurement by exact paths. */
  #missing(): LineId[] {
    const isMissing = (id: LineId) => !this.#result(id) || this.#unmeasured.has(id);
    return this.panel.lines.filter((id) => this.#shown.has(id) && isMissing(id));
  }

  async #makeMesh(): Promise<void> {
    const spec = this.#spec;
    this.#making.hidden = false;
    this.#making.textContent = `Makes the mesh: ${meshWords(spec)}…`;
    try {
      const mesh = await this.context.client.mesh(spec);
      const drawn = await this.context.geometry.make(mesh);
      // The reader has chosen another mesh meanwhile.
      if (spec !== this.#spec) return;
      this.#mesh = mesh;
      this.#size.textContent = formatCount(mesh.info.triangles, 'triangle');
      this.#view.showSurface(drawn);
      this.#making.hidden = true;
      this.recolor();
      this.#lookForCenters();
    } catch (error) {
      this.#making.textContent = error instanceof Error ? error.message : `${error}`;
      this.settled = true;
    }
  }

  /**
   * Takes new places of the points, moved in this panel or in another one that shares the points.
   */
  setPoints(points: readonly Vector[]): void {
    this.#points = points;
    this.#renew();
  }

  /**
   * The measurements of the lines; null while they are under way, and for a curve or a mesh that
   * differs from the figure's.
   */
  measured(): LineNumbers[] | null {
    const changed = this.#curve !== this.panel.curve || this.#spec !== this.panel.mesh;
    if (!this.settled || changed) return null;
    return this.#current().map(numbersOf);
  }

  /** Applies the colors of the theme. */
  recolor(): void {
    this.#view.surfaceColor = new Color(surfaceFront());
    for (const id of this.#results.keys()) this.#view.recolor(id, this.#look(id));
    this.#view.requestFrame();
  }

  /** Computes the lines again after the points or the curve have changed. */
  #renew(): void {
    this.#dragging?.abort();
    this.#numbers.dropSaved();
    for (const id of this.panel.lines) if (!this.#shown.has(id)) this.#forget(id);
    void this.#trace(this.panel.lines.filter((id) => this.#shown.has(id)));
    this.#lookForCenters();
  }

  #lookForCenters(): void {
    if (this.#mesh && this.#curve.kind === 'center') {
      void this.#centers.look(this.#spec, this.#points, this.#curve.weights);
    }
  }

  #forget(id: LineId): void {
    for (const known of [this.#results, this.#waiting, this.#unmeasured]) known.delete(id);
    this.#numbers.clear(id);
    this.#view.hideLine(id);
  }

  /** A line's result, unless it belongs to earlier points. */
  #result(id: LineId): LineResult | undefined {
    return this.#waiting.has(id) ? undefined : this.#results.get(id);
  }

  /** The results of all lines that do not belong to earlier points. */
  #current(): LineResult[] {
    return this.panel.lines.flatMap((id) => this.#result(id) ?? []);
  }

  /** Traces lines; resolves when they are done or when other lines replace them. */
  #trace(lines: readonly LineId[]): Promise<void> {
    this.#stop?.();
    if (!this.#mesh) return Promise.resolve();
    this.settled = false;
    // A hidden line without its measurement is computed again when it is shown.
    for (const id of this.#unmeasured) if (!lines.includes(id)) this.#forget(id);
    for (const id of lines) {
      this.#waiting.add(id);
      this.#numbers.wait(id);
    }
    const panel = { ...this.panel, mesh: this.#spec, curve: this.#curve };
    const job = { panel, points: this.#points, lines };
    let resolve = () => {};
    const promise = new Promise<void>((end) => {
      resolve = end;
    });
    this.#tellWhat();
    const stop = this.context.client.trace(job, {
      placed: (placed) => this.#showPlaced(placed),
      line: (line) => this.#showLine(line),
      measured: (id, ruler) => {
        const line = this.#result(id);
        if (!line) return;
        line.ruler = ruler;
        this.#unmeasured.delete(id);
        this.#numbers.set(line);
      },
      progress: (done, stage) => this.#progress(done, stage),
      failure: (message) => {
        // The end of the work removes a progress message. This message stays.
        this.#note.dataset.kind = '';
        this.#note.textContent = message;
      },
      done: () => {
        this.settled = true;
        this.#unmeasured.clear();
        this.events.measured();
        if (this.#note.dataset.kind === 'progress') this.#note.textContent = '';
        resolve();
      },
    });
    this.#stop = () => {
      stop();
      resolve();
    };
    return promise;
  }

  /** Names the lines without a result or, if there are none, the measurement by exact paths. */
  #tellWhat(): void {
    const names = [...this.#waiting].map((id) => lineStyles[id].label);
    this.#note.dataset.kind = 'progress';
    this.#note.textContent =
      names.length > 0 ? `Computes ${names.join(', ')}…` : 'Measures by exact paths…';
  }

  #progress(done: number, stage: string): void {
    const what = { graph: 'building the graph', landmarks: 'embedding' }[stage];
    // Other stages are short, or their lines arrive one by one.
    if (!what) return;
    this.#note.dataset.kind = 'progress';
    this.#note.textContent = `Computes: ${what}, ${Math.round(100 * done)} %`;
  }

  #showPlaced(placed: Placed): void {
    this.#placed = placed;
    if (!this.#placedOnce) this.#view.resetView(placed.places);
    this.#placedOnce = true;
    this.#handles.show(placed.places);
    const href = editorLink(this.#spec, this.#curve, placed.points);
    this.#link.hidden = href === null;
    this.#noLink.hidden = href !== null;
    if (href) this.#link.href = href;
    else this.#link.removeAttribute('href');
  }

  #setCurve(curve: CurveSpec): void {
    this.#curve = curve;
    this.#title.textContent = panelTitle(this.panel, curve);
    this.#renew();
  }

  /** Shows the same curve on another mesh. */
  async #setMesh(spec: MeshSpec): Promise<void> {
    this.#stop?.();
    this.settled = false;
    this.#spec = spec;
    this.#mesh = null;
    this.#placedOnce = false;
    for (const id of this.panel.lines) this.#forget(id);
    await this.#makeMesh();
    this.#renew();
  }

  #toggle(id: LineId, shown: boolean): void {
    if (shown) this.#shown.add(id);
    else this.#shown.delete(id);
    if (!shown && this.#waiting.has(id)) this.#forget(id);
    this.#view.hideLine(id);
    this.#placeMarkers();
    const result = this.#result(id);
    if (shown && result) this.#draw(result);
    // A new request replaces the present one, so it includes all lines that are still missing.
    else if (shown) void this.#trace(this.#missing());
  }

  #showLine(line: LineResult): void {
    this.#waiting.delete(line.id);
    this.#unmeasured.add(line.id);
    this.#results.set(line.id, line);
    this.#numbers.set(line);
    if (this.#note.dataset.kind === 'progress') this.#tellWhat();
    if (this.#shown.has(line.id)) this.#draw(line);
  }

  #draw(line: LineResult): void {
    const order = 4 + 2 * this.panel.lines.indexOf(line.id);
    // Our line is the widest and lies under the others, so that both are visible where they agree.
    const wide = lineStyles[line.id].width >= 3;
    this.#view.showLine(line.id, line, this.#look(line.id), wide ? 2 : order);
    this.#placeMarkers();
  }

  #look(id: LineId): LineLook {
    const { width, opaque = false } = lineStyles[id];
    return { color: new Color(lineColor(id)), width, opaque };
  }

  /** The dots of the lines' centers of mass, and of other minima. */
  #dots(): Dot[] {
    const ofLines = [...this.#results.values()].flatMap(({ id, marker }) =>
      marker && this.#shown.has(id) ? [{ line: id, place: marker }] : [],
    );
    const others = this.#centers.known?.others ?? [];
    return [...ofLines, ...others.map(({ position }) => ({ line: null, place: position }))];
  }

  #placeMarkers(): void {
    showDots(this.#markers, this.#view, this.#dots());
  }

  /**
   * A place of the stage where the reader can compare lines: the visible center nearest to the
   * middle or, without centers, the visible point of a line nearest to the middle.
   */
  #placeToCompare(): { x: number; y: number } {
    const middle = { x: this.#stage.clientWidth / 2, y: this.#stage.clientHeight / 2 };
    const places = this.#dots().map(({ place }) => place);
    if (places.length === 0) {
      const lines = [...this.#results.values()].filter(({ id }) => this.#shown.has(id));
      for (const line of lines.flatMap(({ polylines }) => polylines)) {
        const step = 3 * Math.ceil(line.length / 3 / 60);
        for (let i = 0; i < line.length; i += step) {
          places.push([line[i]!, line[i + 1]!, line[i + 2]!]);
        }
      }
    }
    const far = ({ x, y }: { x: number; y: number }) => Math.hypot(x - middle.x, y - middle.y);
    const seen = places
      .map((place) => this.#view.project(this.#view.toScene(place)))
      .filter(({ hidden }) => !hidden);
    return seen.toSorted((a, b) => far(a) - far(b))[0] ?? middle;
  }

  #head(): HTMLElement {
    const head = make('header', '', { className: 'panel-head' });
    this.#title.textContent = panelTitle(this.panel, this.#curve);
    head.append(this.#title, this.#size, this.#loupe.button);
    return head;
  }

  #foot(): HTMLElement {
    const foot = make('footer', '', { className: 'panel-foot' });
    const button = (label: string, work: () => void) => {
      const made = make('button', label, { className: 'link', type: 'button' });
      made.addEventListener('click', work);
      return made;
    };
    const edges = button('Triangles', () => {
      this.#view.edges = !this.#view.edges;
      edges.setAttribute('aria-pressed', `${this.#view.edges}`);
    });
    edges.setAttribute('aria-pressed', `${this.#view.edges}`);
    const name = `karcher-${this.panel.points}-${this.panel.id}`;
    foot.append(
      edges,
      ...(this.panel.curve.kind === 'bspline' || this.panel.curve.kind === 'bezier'
        ? [this.#dragButton]
        : []),
      button('Reset view', () => this.#view.resetView(this.#placed?.places ?? [])),
      button('SVG', () => download(`${name}.svg`, 'image/svg+xml', this.svg())),
      button('JSON', () => download(`${name}.json`, 'application/json', this.json())),
      this.#link,
      this.#noLink,
    );
    return foot;
  }

  /** Drags a control point of every visible curve, and shows the leaps of the curves. */
  async #dragAll(): Promise<void> {
    const lines = this.panel.lines.filter((id) => this.#shown.has(id) && this.#result(id));
    if (this.#dragging) return;
    const dragging = new AbortController();
    this.#dragging = dragging;
    this.#dragButton.disabled = true;
    this.#note.textContent = 'Dragging a control point in small steps…';
    const panel = { ...this.panel, mesh: this.#spec, curve: this.#curve };
    try {
      await this.context.client.drag(
        { panel, points: this.#points, lines },
        (id, drag) => {
          const line = this.#result(id);
          // The points have moved since the measurement.
          if (!line || dragging.signal.aborted) return;
          line.drag = drag;
          this.#numbers.set(line);
        },
        dragging.signal,
      );
      this.#note.textContent = '';
    } catch (error) {
      const failed = !dragging.signal.aborted && error instanceof Error;
      this.#note.textContent = failed ? error.message : '';
    } finally {
      this.#dragging = null;
      this.#dragButton.disabled = false;
    }
  }

  /** The panel's numbers as JSON, for all methods with measurements at the current points. */
  json(): string {
    const lines = this.#current().map(numbersOf);
    const { samples } = this.panel;
    const { info } = this.#mesh ?? {};
    const { points } = this.#placed ?? {};
    const center = this.#centers.isLooking ? null : this.#centers.known;
    return JSON.stringify(
      { mesh: this.#spec, info, curve: this.#curve, samples, points, center, lines },
      null,
      2,
    );
  }

  /** The panel as it appears, with its numbers as metadata. */
  svg(): string {
    return panelSvg({
      vantage: this.#view.vantage,
      colorOf: lineColor,
      lines: this.#current().filter(({ id }) => this.#shown.has(id)),
      places: this.#placed?.places ?? [],
      seen: (place) => this.#view.project(this.#view.toScene(place)),
      picture: this.#surfacePicture(),
      numbers: this.json(),
    });
  }

  /** The surface alone, as an image. */
  #surfacePicture(): string {
    for (const id of this.#results.keys()) this.#view.hideLine(id);
    this.#view.draw();
    const picture = this.#stage.querySelector('canvas')!.toDataURL('image/png');
    for (const line of this.#results.values()) if (this.#shown.has(line.id)) this.#draw(line);
    this.#view.draw();
    return picture;
  }
}

/** A mesh in words. */
const meshWords = (spec: MeshSpec) =>
  `${meshLabel(madeKey(spec))}, about ${formatCount(expectedTriangles(spec), 'triangle')}`;
