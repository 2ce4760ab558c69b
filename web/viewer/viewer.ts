import type { SurfacePoint } from 'karcher';
import { Box3, Color, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { defaultStyle, type LineStyle, styleOf } from '../model/drawing';
import type { ViewPlace } from '../model/view_place';
import { AidLines } from './aid_lines';
import { colorSurface, fitSurface, showRelief, turnLight } from './clay';
import { litSurface, type ViewerColors } from './colors';
import { outliveContextLoss } from './context_loss';
import type { DrawnGeometry } from './drawn_geometry';
import { FatLine, fineDash } from './fat_line';
import { GroundShadow } from './ground_shadow';
import { Halos } from './halos';
import type { Layer } from './layer';
import { LinesAt, type ObjectsIn, objectsIn, type PickableLines } from './lines_at';
import { fatStyle, mostMarks, type ObjectDrawing, ObjectLines } from './object_lines';
import { OrbitView } from './orbit_view';
import { requestOutline } from './outline_request';
import { pictureOf } from './picture';
import { type PaintedRegion, Regions } from './regions';
import { type Pick, Surface } from './surface';
import { type SeenLine, Vantage } from './vantage';

/** The view of a surface with a curve on it. It draws only after changes. */
export class Viewer {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #view: OrbitView;
  readonly #raycaster = new Raycaster();
  readonly #curve = new FatLine({ width: 4, hidden: 0.26 }, 4);
  readonly #lost = new FatLine({ width: 4, dash: fineDash, hidden: 0.4 }, 4);
  readonly #beside = new ObjectLines(2);
  readonly #ground = new GroundShadow();
  readonly #regions = new Regions();
  readonly #halos = new Halos();
  /** Lines that are not part of the drawing. */
  readonly aids = new AidLines(() => this.requestFrame());
  readonly #lines = [this.#curve, this.#lost, this.#beside, this.aids];
  readonly #layers: Layer[] = [];
  readonly #beforeFrame: (() => void)[] = [];
  #surface: Surface | null = null;
  /** The visible curve, in the scene. */
  #line: Float32Array = new Float32Array();
  /** All lines of the edited object, in the scene. */
  #own: readonly Float32Array[] = [];
  #style: LineStyle = defaultStyle;
  #colors: ViewerColors | null = null;
  #chosen: readonly number[] = [];
  #isChosen = false;
  #hovered: number | null | undefined = undefined;
  #hiddenLines = true;
  #edges = false;
  #fileColors = true;
  #relief = true;
  /** The stage's size in CSS pixels, kept here since a read from the page forces a slow layout. */
  #size = { width: 1, height: 1 };
  /** The stage's place in the window; null until the next measurement. */
  #box: DOMRect | null = null;
  #frame = 0;

  /** `stage` receives the pointer events, and the canvas fills it. Throws if WebGL 2 is missing. */
  constructor(
    private readonly stage: HTMLElement,
    canvas: HTMLCanvasElement,
    options: { antialias: boolean },
  ) {
    const context = canvas.getContext('webgl2', { alpha: true, stencil: true, ...options });
    if (!context) {
      throw new Error(
        'WebGL 2, which draws the surface, is missing or switched off. Check that graphics acceleration is allowed in the settings.',
      );
    }
    this.#renderer = new WebGLRenderer({ canvas, context, stencil: true });
    const redraw = () => this.requestFrame();
    outliveContextLoss(canvas, () => [this.#scene], redraw);
    canvas.addEventListener('webglcontextlost', () => this.#ground.forget());
    const lines = this.#lines.map((line) => line.object);
    this.#scene.add(this.#ground.object, this.#regions.object, ...this.#halos.objects, ...lines);
    this.#view = new OrbitView(stage, redraw);
    new ResizeObserver(() => this.#resize()).observe(stage);
    this.#resize();
    for (const type of ['resize', 'scroll']) {
      addEventListener(type, () => (this.#box = null), { capture: true, passive: true });
    }
  }

  /** Adds a layer, and gives it the present colors and all later ones. */
  addLayer(layer: Layer): void {
    this.#layers.push(layer);
    this.#scene.add(layer.object);
    if (this.#colors) layer.setColors(this.#colors);
  }

  /** Adds a listener, which runs before each frame, after the camera has moved. */
  onFrame(listener: () => void): void {
    this.#beforeFrame.push(listener);
  }

  requestFrame(): void {
    this.#frame ||= requestAnimationFrame((now) => {
      this.#frame = 0;
      this.#view.advance(now);
      this.#view.fitDepth();
      this.#view.camera.updateMatrixWorld();
      const followers = [...this.#lines, ...this.#layers, this.#halos];
      for (const one of followers) one.follow(this.#view.camera.position);
      for (const listener of this.#beforeFrame) listener();
      this.#render();
    });
  }

  /** Whether the newest view is visible, and no motion is under way. */
  get still(): boolean {
    return this.#frame === 0;
  }

  get surface(): Surface | null {
    return this.#surface;
  }

  /** Shows another surface, without a curve. */
  showSurface(drawn: DrawnGeometry): Surface {
    if (this.#surface) {
      this.#scene.remove(this.#surface.object);
      this.#surface.dispose();
    }
    this.#surface = new Surface(drawn);
    this.#surface.edges = this.#edges;
    this.#surface.colored = this.#fileColors;
    this.#view.surface = this.#surface;
    this.#ground.forget();
    this.#scene.add(this.#surface.object);
    this.#beside.surface = this.#surface;
    this.#halos.surface = this.#surface;
    this.showCurve(null);
    this.#showStyle();
    this.showObjects([]);
    this.showRegions([]);
    this.aids.clear(this.#surface);
    return this.#surface;
  }

  set colors(colors: ViewerColors) {
    colorSurface(colors);
    const surface = litSurface(colors);
    this.#colors = colors;
    this.#lost.setColor(new Color(colors.lost), surface);
    this.aids.setColors(colors);
    this.#ground.setColors(colors);
    this.#beside.setColors(new Color(colors.curve), surface);
    this.#regions.setColor(new Color(colors.curve));
    this.#halos.setColors(colors);
    this.#showStyle();
    this.#showHalo();
    for (const layer of this.#layers) layer.setColors(colors);
    this.requestFrame();
  }

  /** Whether surfaces show the colors of their files, if the files have colors. */
  get fileColors(): boolean {
    return this.#fileColors;
  }

  set fileColors(shown: boolean) {
    this.#fileColors = shown;
    if (this.#surface) this.#surface.colored = shown;
    this.requestFrame();
  }

  /** Whether hollows of the surface are darker, and ridges lighter. */
  get relief(): boolean {
    return this.#relief;
  }

  set relief(shown: boolean) {
    this.#relief = shown;
    showRelief(shown);
    this.requestFrame();
  }

  /** Whether the surface has a shadow on the ground below it. */
  get groundShadow(): boolean {
    return this.#ground.object.visible;
  }

  set groundShadow(shown: boolean) {
    this.#ground.object.visible = shown;
    this.requestFrame();
  }

  /** Turns the light around the line of sight, by an angle in radians. */
  turnLight(angle: number): void {
    turnLight(angle);
    this.requestFrame();
  }

  get edges(): boolean {
    return this.#edges;
  }

  set edges(visible: boolean) {
    this.#edges = visible;
    if (this.#surface) this.#surface.edges = visible;
    this.requestFrame();
  }

  /** Shows a polyline in the surface's coordinates; parts with status 1 appear as not converged. */
  showCurve(curve: { polyline: Float32Array; polylineStatus: Uint8Array } | null): void {
    if (curve && this.#surface) {
      const line = this.#surface.toScene(curve.polyline);
      this.#line = line;
      this.#own = [line];
      // A vertex has the status of the sample to which it leads.
      const lost = (segment: number) => curve.polylineStatus[segment + 1] === 1;
      this.#curve.setChosen(line, (segment) => !lost(segment));
      this.#lost.setChosen(line, lost);
    } else {
      this.#line = new Float32Array();
      this.#own = [];
      this.#curve.clear();
      this.#lost.clear();
    }
    this.#showHalo();
    this.requestFrame();
  }

  /** Shows polylines in the surface's coordinates. A click cannot pick points on these lines. */
  showLines(lines: readonly Float32Array[]): void {
    const surface = this.#surface;
    this.#line = new Float32Array();
    this.#own = surface ? lines.map((line) => surface.toScene(line)) : [];
    this.#curve.set(this.#own);
    this.#lost.clear();
    this.#showHalo();
    this.requestFrame();
  }

  /** Shows parts of the surface, each with or without a color over it; null shows the whole. */
  showParts(parts: Parameters<Surface['showParts']>[0]): void {
    this.#surface?.showParts(parts);
    this.#ground.forget();
    this.requestFrame();
  }

  /** Sets the style of the edited object. */
  showStyle(style: LineStyle): void {
    const shown = styleOf(style);
    if (`${Object.values(shown)}` === `${Object.values(this.#style)}`) return;
    this.#style = shown;
    this.#showStyle();
    this.#showHalo();
    this.requestFrame();
  }

  /** Shows the objects other than the edited one. */
  showObjects(objects: readonly ObjectDrawing[]): void {
    this.#beside.show(objects);
    this.#showHalo();
    this.requestFrame();
  }

  /** Sets the painted regions, from the lowest to the topmost. */
  showRegions(painted: readonly PaintedRegion[]): void {
    this.#regions.show(painted, this.#surface);
    this.requestFrame();
  }

  /** The visible triangles of the regions. */
  seenRegions(vantage: Vantage): ReturnType<Regions['seen']> {
    return this.#regions.seen(vantage);
  }

  /** The id of the topmost unlocked object with a painted region at a point; null without one. */
  pickRegion(point: SurfacePoint): number | null {
    return this.#regions.at(point);
  }

  /** Marks the selected objects: `others` by their ids, and with `edited` the edited one. */
  showChosen(others: readonly number[], edited: boolean): void {
    if (`${others}` === `${this.#chosen}` && edited === this.#isChosen) return;
    [this.#chosen, this.#isChosen] = [others, edited];
    this.#showHalo();
    this.requestFrame();
  }

  /** The ids of the objects with a halo, including the edited one if it has one. */
  marked(edited: number): readonly number[] {
    return this.#isChosen ? [...this.#chosen, edited] : this.#chosen;
  }

  /** Shows the object that a click would take: its id, null for the edited one, undefined for none. */
  showHovered(id: number | null | undefined): void {
    if (id === this.#hovered) return;
    this.#hovered = id;
    this.#showHalo();
    this.requestFrame();
  }

  /** Whether lines are visible through the surface. */
  get hiddenLines(): boolean {
    return this.#hiddenLines;
  }

  set hiddenLines(shown: boolean) {
    this.#hiddenLines = shown;
    for (const line of [this.#curve, this.#lost, this.#beside]) line.showHidden(shown);
    this.requestFrame();
  }

  #showHalo(): void {
    const own = { style: this.#style, lines: this.#own, dots: [] };
    const beside = this.#beside.objects;
    const others = beside.filter(({ id }) => this.#chosen.includes(id));
    const id = this.#hovered;
    const hovered = id === null ? [own] : beside.filter((one) => one.id === id);
    const chosen = this.#isChosen ? [...others, own] : others;
    this.#halos.show([...beside, own], chosen, hovered);
  }

  #showStyle(): void {
    const { color } = this.#style;
    const colors = this.#colors;
    if (!colors) return;
    const surface = litSurface(colors);
    const own = new Color(color ?? colors.curve);
    const style = fatStyle(this.#style, this.#surface);
    this.#curve.setStyle({ ...style, mark: mostMarks + 1 });
    this.#curve.setColor(own, surface);
    this.#lost.setStyle({ ...style, dash: fineDash, opacity: 1 });
    this.aids.setOwnColor(own, surface);
  }

  /** The surface's point at a place of the window, in CSS pixels; null beside the surface. */
  pick(clientX: number, clientY: number): Pick | null {
    if (!this.#surface) return null;
    const { box } = this;
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.#view.camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(place, this.#view.camera);
    return this.#surface.pick(this.#raycaster.ray);
  }

  /** The lines visible at a place of the window, in CSS pixels. */
  linesAt(clientX: number, clientY: number): LinesAt {
    const { box } = this;
    this.#view.camera.updateMatrixWorld();
    const place = { x: clientX - box.left, y: clientY - box.top };
    return new LinesAt(this.#vantage, this.#pickable, place);
  }

  /** The unlocked objects that are at least partly visible in a box of the window. */
  objectsIn(left: number, top: number, width: number, height: number): ObjectsIn {
    const { box } = this;
    this.#view.camera.updateMatrixWorld();
    const onStage = { left: left - box.left, top: top - box.top, width, height };
    return objectsIn(this.#vantage, this.#pickable, onStage);
  }

  get #pickable(): PickableLines {
    return {
      curve: this.#line,
      own: this.#own,
      style: this.#style,
      objects: this.#beside.objects,
      shorter: this.aids.shorter,
    };
  }

  /** The place of a scene's point on the stage, in CSS pixels, and whether the point is hidden. */
  project(position: Vector3): { x: number; y: number; hidden: boolean } {
    return this.#vantage.project(position);
  }

  get #vantage(): Vantage {
    return new Vantage(this.#surface, this.#view.camera, this.#size);
  }

  /** The present view, which does not change when the camera turns later. */
  vantage(): Vantage {
    this.#view.camera.updateMatrixWorld();
    return new Vantage(this.#surface, this.#view.camera.clone(), this.#size);
  }

  /** The stage's size, in CSS pixels. */
  get size(): { width: number; height: number } {
    return this.#size;
  }

  /** The length of CSS pixels at a point of the scene, in the surface's unit. */
  reach(position: Vector3, pixels: number): number {
    return this.#vantage.reach(position, pixels);
  }

  /** The stage's place in the window, measured again after a scroll or a change of size. */
  get box(): DOMRect {
    this.#box ??= this.stage.getBoundingClientRect();
    return this.#box;
  }

  /** A polyline in the surface's coordinates as it appears on the stage. */
  seen(polyline: Float32Array): SeenLine {
    return this.#vantage.seen(polyline);
  }

  /** The camera's direction to the right, in the surface's coordinates. */
  get right(): [number, number, number] {
    const right = new Vector3().setFromMatrixColumn(this.#view.camera.matrixWorld, 0);
    return this.#surface?.directionFromScene(right) ?? right.toArray();
  }

  /** Turns the view about its target, by angles in radians. */
  orbit(aside: number, up: number): void {
    this.#view.orbit(aside, up);
  }

  zoom(factor: number): void {
    this.#view.zoom(factor);
  }

  pan(x: number, y: number): void {
    this.#view.pan(x, y);
  }

  /** Whether the pointer only moves the view. */
  set movesView(moves: boolean) {
    this.#view.moves = moves;
    this.stage.classList.toggle('moving', moves);
  }

  /** Zooms to points and to places `around` them; turns to the points if most are hidden. */
  zoomTo(points: readonly SurfacePoint[], around: readonly Vector3[] = []): void {
    const surface = this.#surface;
    if (!surface || points.length === 0) return;
    const places = [...points.map((point) => surface.position(point)), ...around];
    const box = new Box3().setFromPoints(places);
    const center = box.getCenter(new Vector3());
    const radius = Math.max(...places.map((place) => place.distanceTo(center)));
    const hidden = points.filter((point) => this.project(surface.position(point)).hidden).length;
    const normal = points.reduce((sum, point) => sum.add(surface.normal(point)), new Vector3());
    const isSeen = 2 * hidden < points.length || normal.length() < 1e-3;
    this.#view.fit(center, radius, isSeen ? null : normal);
  }

  /** Returns to the default view of the whole; at once if the user does not want motion. */
  resetView(options: { animated: boolean }): void {
    this.#view.reset(options);
  }

  /** The place of the camera, now or after the present flight; null for the default view. */
  get place(): ViewPlace | null {
    return this.#view.place;
  }

  showPlace(place: ViewPlace, options: { animated: boolean }): void {
    this.#view.show(place, options);
  }

  /** Puts a point of the scene in the middle, seen from straight above the surface there. */
  lookAt(position: Vector3): void {
    const surface = this.#surface;
    if (surface) this.#view.lookAt(position, surface.normal(surface.nearest(position)));
  }

  /**
   * The view as a PNG with `scale` pixels for each CSS pixel. Without a background, the picture is
   * transparent around the surface.
   */
  picture(scale: number, background: string | null): Promise<Blob> {
    const picture = pictureOf(this.#renderer, () => this.#render(), this.#size, scale, background);
    this.requestFrame();
    return picture;
  }

  /** The lines of the surface's outline in this view: x, y of their points, in CSS pixels. */
  outline(signal: AbortSignal): Promise<Float32Array[]> {
    const { shownMeshes: meshes, frame } = this.#surface!;
    return requestOutline({ meshes, frame }, this.#view.camera, this.#size, signal);
  }

  #render(): void {
    if (this.#surface) this.#ground.prepare(this.#renderer, this.#surface);
    fitSurface(this.#halos.reach, this.#view.camera, this.#size.height);
    this.#renderer.render(this.#scene, this.#view.camera);
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.stage;
    this.#box = null;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#size = { width: clientWidth, height: clientHeight };
    this.#renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#view.resize(clientWidth, clientHeight);
    this.requestFrame();
  }
}
