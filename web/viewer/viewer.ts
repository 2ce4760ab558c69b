import type { SurfacePoint } from 'karcher';
import { Box3, Color, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { defaultStyle, type LineStyle, styleOf } from '../model/drawing';
import type { ViewPlace } from '../model/view_place';
import { litSurface, type ViewerColors } from './colors';
import { outliveContextLoss } from './context_loss';
import { nearestOnScreen } from './curve_pick';
import type { DrawnGeometry } from './drawn_geometry';
import { FatLine, fineDash } from './fat_line';
import { Halos } from './halos';
import type { Layer } from './layer';
import { dotAt, fatStyle, mostMarks, type ObjectDrawing, ObjectLines } from './object_lines';
import { OrbitView } from './orbit_view';
import { requestOutline } from './outline_request';
import { pictureOf } from './picture';
import { type PaintedRegion, Regions } from './regions';
import { colorSurface, type Pick, Surface, showRelief, sinkSurface, turnLight } from './surface';
import { type SeenLine, Vantage } from './vantage';

type Vector = [number, number, number];

/** How long a tangent is drawn, in the scene; a surface's diagonal is 2. */
const tangentLength = 0.16;

/** The view of a surface with a curve on it. Draws only when something changed. */
export class Viewer {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #view: OrbitView;
  readonly #raycaster = new Raycaster();
  readonly #curve = new FatLine({ width: 4, hidden: 0.26 }, 4);
  readonly #lost = new FatLine({ width: 4, dash: fineDash, hidden: 0.4 }, 4);
  readonly #polygon = new FatLine({ width: 1.5, hidden: 0.25 }, 2);
  readonly #sketch = new FatLine({ width: 2.5, dash: fineDash, hidden: 0.25 }, 2);
  readonly #stroke = new FatLine({ width: 3, hidden: 0.25 }, 4);
  readonly #band = new FatLine({ width: 2, dash: fineDash, hidden: 0.2 }, 4);
  readonly #beside = new ObjectLines(2);
  readonly #regions = new Regions();
  readonly #halos = new Halos();
  readonly #shorter = new FatLine({ width: 2.5, dash: fineDash, hidden: 0.3 }, 2);
  readonly #marks = new FatLine({ width: 7.5, hidden: 0.26 }, 6);
  readonly #tangent = new FatLine({ width: 2.5, hidden: 0.5 }, 7);
  readonly #frameLines = new FatLine({ width: 1.5, dash: fineDash, hidden: 0.2 }, 5);
  readonly #places = new FatLine({ width: 3, hidden: 0.45 }, 5);
  readonly #lines = [
    ...[this.#curve, this.#lost, this.#polygon, this.#sketch, this.#beside],
    ...[this.#shorter, this.#marks, this.#tangent, this.#places, this.#stroke],
    this.#frameLines,
    this.#band,
  ];
  readonly #layers: Layer[] = [];
  readonly #beforeFrame: (() => void)[] = [];
  #surface: Surface | null = null;
  /** The curve that is shown, in the scene. */
  #line: Float32Array = new Float32Array();
  /** All lines of the edited object, in the scene. */
  #own: readonly Float32Array[] = [];
  #style: LineStyle = defaultStyle;
  #colors: ViewerColors | null = null;
  #chosen: readonly number[] = [];
  #isChosen = false;
  #hovered: number | null | undefined = undefined;
  #hiddenLines = true;
  #shorterLines: Float32Array[] = [];
  #edges = false;
  #fileColors = true;
  #relief = true;
  /** The stage's, in CSS pixels: to ask the stage lays the page out, which a thousand handles cannot bear. */
  #size = { width: 1, height: 1 };
  /** Where the stage is in the window; null until it is asked for again. */
  #box: DOMRect | null = null;
  #frame = 0;

  /** `stage` takes the pointer; the canvas fills it. Throws where there is no WebGL 2. */
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
    const lines = this.#lines.map((line) => line.object);
    this.#scene.add(this.#regions.object, ...this.#halos.objects, ...lines);
    this.#view = new OrbitView(stage, redraw);
    new ResizeObserver(() => this.#resize()).observe(stage);
    this.#resize();
    for (const type of ['resize', 'scroll']) {
      addEventListener(type, () => (this.#box = null), { capture: true, passive: true });
    }
  }

  /** Draws something more, in the colors that are set from then on. */
  addLayer(layer: Layer): void {
    this.#layers.push(layer);
    this.#scene.add(layer.object);
    if (this.#colors) layer.setColors(this.#colors);
  }

  /** Called before each frame is drawn, with the camera as it will be. */
  onFrame(listener: () => void): void {
    this.#beforeFrame.push(listener);
  }

  requestFrame(): void {
    this.#frame ||= requestAnimationFrame((now) => {
      this.#frame = 0;
      this.#view.advance(now);
      this.#view.camera.updateMatrixWorld();
      const followers = [...this.#lines, ...this.#layers, this.#halos];
      for (const one of followers) one.follow(this.#view.camera.position);
      for (const listener of this.#beforeFrame) listener();
      this.#render();
    });
  }

  /** Whether the newest view is drawn, and nothing moves. */
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
    this.#scene.add(this.#surface.object);
    this.#beside.surface = this.#surface;
    this.#halos.surface = this.#surface;
    this.showCurve(null);
    this.#showStyle();
    this.showPolygon([], false);
    this.showMarks([]);
    this.showTangent(null);
    this.showObjects([]);
    this.showRegions([]);
    this.showShorter([]);
    this.showPlaces([]);
    this.showStroke(new Float32Array());
    this.showBand(new Float32Array());
    this.showFrame([]);
    return this.#surface;
  }

  set colors(colors: ViewerColors) {
    colorSurface(colors);
    const surface = litSurface(colors);
    this.#colors = colors;
    const lost = new Color(colors.lost);
    for (const line of [this.#lost, this.#places]) line.setColor(lost, surface);
    this.#polygon.setColor(new Color(colors.polygon), surface);
    this.#beside.setColors(new Color(colors.curve), surface);
    this.#regions.setColor(new Color(colors.curve));
    this.#halos.setColors(colors);
    this.#showStyle();
    this.#showHalo();
    const center = new Color(colors.center);
    for (const line of [this.#shorter, this.#tangent]) line.setColor(center, surface);
    this.#frameLines.setColor(new Color(colors.frame), surface);
    this.#marks.setColor(new Color(colors.marks), surface);
    for (const layer of this.#layers) layer.setColors(colors);
    this.requestFrame();
  }

  /** Whether a surface has the colors of its file, where that has some. */
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

  /** Turns the light round the line of sight, by an angle in radians. */
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

  /** A polyline in the surface's coordinates; where its status is 1 it is drawn as not converged. */
  showCurve(curve: { polyline: Float32Array; polylineStatus: Uint8Array } | null): void {
    if (curve && this.#surface) {
      const line = this.#surface.toScene(curve.polyline);
      this.#line = line;
      this.#own = [line];
      // A vertex's status is that of the sample it leads to.
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

  /** Polylines in the surface's coordinates, none of which is picked, in place of a curve. */
  showLines(lines: readonly Float32Array[]): void {
    const surface = this.#surface;
    this.#line = new Float32Array();
    this.#own = surface ? lines.map((line) => surface.toScene(line)) : [];
    this.#curve.set(this.#own);
    this.#lost.clear();
    this.#showHalo();
    this.requestFrame();
  }

  /** Marks points of the curve: x, y, z each, in the surface's coordinates. */
  showMarks(places: ArrayLike<number>): void {
    const points = this.#surface?.toScene(Float32Array.from(places)) ?? new Float32Array();
    const dots = Array.from({ length: points.length / 3 }, (_, i) =>
      dotAt(new Vector3().fromArray(points, 3 * i)),
    );
    this.#marks.set(dots);
    this.requestFrame();
  }

  /** Shows parts of the surface in its place, each with a color over it or none; null shows all of it. */
  showParts(parts: Parameters<Surface['showParts']>[0]): void {
    this.#surface?.showParts(parts);
    this.requestFrame();
  }

  /** Outlines of places of the surface, in its coordinates; those before go. */
  showPlaces(lines: readonly Float32Array[]): void {
    const surface = this.#surface;
    this.#places.set(surface ? lines.map((line) => surface.toScene(line)) : []);
    this.requestFrame();
  }

  /** The way to the point that a click would add. */
  showBand(line: Float32Array): void {
    this.#band.set(line.length > 0 ? [line] : []);
    this.requestFrame();
  }

  /** A stroke that is being drawn, in the scene. */
  showStroke(line: Float32Array): void {
    this.#stroke.set(line.length > 0 ? [line] : []);
    this.requestFrame();
  }

  /** The frame round what is transformed: polylines in the scene. */
  showFrame(lines: readonly Float32Array[]): void {
    this.#frameLines.set(lines);
    this.requestFrame();
  }

  /** A curve's tangent at a place, in the surface's coordinates. */
  showTangent(at: { position: Vector; tangent: Vector } | null): void {
    const surface = this.#surface;
    const start = at && surface?.inScene(at.position);
    if (at && surface && start) {
      const tip = surface.directionInScene(at.tangent).setLength(tangentLength).add(start);
      this.#tangent.set([Float32Array.from([...start.toArray(), ...tip.toArray()])]);
    } else this.#tangent.set([]);
    this.requestFrame();
  }

  /** How the edited object is drawn. */
  showStyle(style: LineStyle): void {
    const shown = styleOf(style);
    if (`${Object.values(shown)}` === `${Object.values(this.#style)}`) return;
    this.#style = shown;
    this.#showStyle();
    this.#showHalo();
    this.requestFrame();
  }

  /** The objects beside the one that is edited. */
  showObjects(objects: readonly ObjectDrawing[]): void {
    this.#beside.show(objects);
    this.#showHalo();
    this.requestFrame();
  }

  /** What is painted, from the lowest to the topmost. */
  showRegions(painted: readonly PaintedRegion[]): void {
    this.#regions.show(painted, this.#surface);
    this.requestFrame();
  }

  /** What is seen of it. */
  seenRegions(vantage: Vantage): ReturnType<Regions['seen']> {
    return this.#regions.seen(vantage);
  }

  /** The id of the topmost object that is painted at a point; null without one. */
  pickRegion(point: SurfacePoint): number | null {
    return this.#regions.at(point);
  }

  /** Which objects are selected, by their ids, and whether the edited one is. */
  showChosen(others: readonly number[], edited: boolean): void {
    if (`${others}` === `${this.#chosen}` && edited === this.#isChosen) return;
    [this.#chosen, this.#isChosen] = [others, edited];
    this.#showHalo();
    this.requestFrame();
  }

  /** Which objects have a halo, by their ids, with that of the edited one. */
  marked(edited: number): readonly number[] {
    return this.#isChosen ? [...this.#chosen, edited] : this.#chosen;
  }

  /** Which object a click would take, by its id, the edited one with null; none with undefined. */
  showHovered(id: number | null | undefined): void {
    if (id === this.#hovered) return;
    this.#hovered = id;
    this.#showHalo();
    this.requestFrame();
  }

  /** Whether lines show through the surface. */
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
    for (const line of [this.#sketch, this.#stroke, this.#band]) line.setColor(own, surface);
  }

  /** Shorter ways than the legs of the curve. */
  showShorter(lines: readonly Float32Array[]): void {
    const surface = this.#surface;
    this.#shorterLines = surface ? lines.map((line) => surface.toScene(line)) : [];
    this.#shorter.set(this.#shorterLines);
    this.requestFrame();
  }

  /** The geodesics between control points; bold while they stand for the curve. */
  showPolygon(legs: readonly Float32Array[], bold: boolean): void {
    const surface = this.#surface;
    const lines = surface ? legs.map((leg) => surface.toScene(leg)) : [];
    this.#polygon.set(bold ? [] : lines);
    this.#sketch.set(bold ? lines : []);
    this.requestFrame();
  }

  /** The surface's point at a place of the window, in CSS pixels. */
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

  /** The curve's point there, in the scene, if one is seen within so many CSS pixels. */
  pickCurve(clientX: number, clientY: number, within: number): Vector3 | null {
    return this.#pickLine(this.#line, clientX, clientY, within, this.#style);
  }

  /** The id of the topmost object beside the edited one that is seen there; null without one. */
  pickObject(clientX: number, clientY: number, within: number): number | null {
    const found = this.#beside.objects.findLast(({ locked, style, lines, dots }) => {
      const isSeen = (line: Float32Array) => this.#pickLine(line, clientX, clientY, within, style);
      return !locked && (lines.some(isSeen) || dots.some((dot) => isSeen(dotAt(dot))));
    });
    return found?.id ?? null;
  }

  /** The place, in the scene, of a line beside the edited object that is seen nearest; null without one. */
  nearestOnObjects(clientX: number, clientY: number, within: number): Vector3 | null {
    const { box, camera } = { box: this.box, camera: this.#view.camera };
    const place = { x: clientX - box.left, y: clientY - box.top };
    camera.updateMatrixWorld();
    const found = this.#beside.objects
      .flatMap(({ lines }) => lines.map((line) => nearestOnScreen(line, camera, this.size, place)))
      .filter((one) => one !== null)
      .filter(({ position, distance }) => distance <= within && !this.project(position).hidden)
      .sort((a, b) => a.distance - b.distance);
    return found[0]?.position ?? null;
  }

  /** Whether the edited object is seen there. */
  pickOwn(clientX: number, clientY: number, within: number): boolean {
    const style = this.#style;
    return this.#own.some((line) => this.#pickLine(line, clientX, clientY, within, style));
  }

  /** The objects of which something is seen in a box of the window; what is locked is not among them. */
  objectsIn(
    left: number,
    top: number,
    width: number,
    height: number,
  ): { others: number[]; edited: boolean } {
    const { box } = this;
    this.#view.camera.updateMatrixWorld();
    const place = new Vector3();
    const vantage = this.#vantage;
    const isWithin = (line: Float32Array) => {
      for (let i = 0; i < line.length; i += 3) {
        const { x, y } = vantage.onStage(place.fromArray(line, i));
        const [dx, dy] = [x + box.left - left, y + box.top - top];
        if (dx < 0 || dx > width || dy < 0 || dy > height) continue;
        if (!this.project(new Vector3().fromArray(line, i)).hidden) return true;
      }
      return false;
    };
    const others = this.#beside.objects.filter(
      ({ locked, lines, dots }) =>
        !locked && (lines.some(isWithin) || dots.map(dotAt).some(isWithin)),
    );
    return { others: others.map(({ id }) => id), edited: this.#own.some(isWithin) };
  }

  /** The number of the shorter way that is seen there; -1 without one. */
  pickShorter(clientX: number, clientY: number, within: number): number {
    return this.#shorterLines.findIndex((line) => this.#pickLine(line, clientX, clientY, within));
  }

  /** The line's point there; of a style all of its width is the line. */
  #pickLine(
    line: Float32Array,
    clientX: number,
    clientY: number,
    within: number,
    style: LineStyle | null = null,
  ): Vector3 | null {
    const { box } = this;
    const place = { x: clientX - box.left, y: clientY - box.top };
    this.#view.camera.updateMatrixWorld();
    const nearest = nearestOnScreen(line, this.#view.camera, this.size, place);
    if (!nearest) return null;
    const half = style ? this.seenWidth(style, nearest.position) / 2 : 0;
    if (nearest.distance > Math.max(within, half)) return null;
    return this.project(nearest.position).hidden ? null : nearest.position;
  }

  /** Where a point of the scene is on the stage, in CSS pixels, and whether the surface hides it. */
  project(position: Vector3): { x: number; y: number; hidden: boolean } {
    return this.#vantage.project(position);
  }

  get #vantage(): Vantage {
    return new Vantage(this.#surface, this.#view.camera, this.#size);
  }

  /** What is seen now, also while the view turns later. */
  vantage(): Vantage {
    this.#view.camera.updateMatrixWorld();
    return new Vantage(this.#surface, this.#view.camera.clone(), this.#size);
  }

  /** The stage's size, in CSS pixels. */
  get size(): { width: number; height: number } {
    return this.#size;
  }

  /** How far so many CSS pixels reach at a point of the scene, in the surface's unit. */
  reach(position: Vector3, pixels: number): number {
    const { camera } = this.#view;
    const away = camera.position.distanceTo(position);
    const height = 2 * away * Math.tan((camera.fov * Math.PI) / 360);
    return ((height / this.#size.height) * pixels) / (this.#surface?.frame.scale ?? 1);
  }

  /** How wide a line is at a point of the scene where the surface faces the view, in CSS pixels. */
  seenWidth({ width, onSurface }: LineStyle, position: Vector3): number {
    return onSurface ? width / this.reach(position, 1) : width;
  }

  /** Where the stage is in the window: asked of the page once, as its size is. */
  get box(): DOMRect {
    this.#box ??= this.stage.getBoundingClientRect();
    return this.#box;
  }

  /** A polyline in the surface's coordinates as it is seen on the stage. */
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

  /** While it is set the pointer moves the view, whatever else it would do. */
  set movesView(moves: boolean) {
    this.#view.moves = moves;
    this.stage.classList.toggle('moving', moves);
  }

  /** Zooms to points of the surface; where most of them are hidden, from where they are seen. */
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

  /** The whole surface, from the front; at once where motion is not wanted. */
  resetView(options: { animated: boolean }): void {
    this.#view.reset(options);
  }

  /** From where the surface is looked at; null for the usual view, of the whole from the front. */
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
   * The view as a PNG, of so many pixels for each of CSS; see-through beside the surface where no
   * background is given.
   */
  picture(scale: number, background: string | null): Promise<Blob> {
    const picture = pictureOf(this.#renderer, () => this.#render(), this.#size, scale, background);
    this.requestFrame();
    return picture;
  }

  /** The surface's outline as it is seen: x, y of its lines' points, in CSS pixels of the stage. */
  outline(signal: AbortSignal): Promise<Float32Array[]> {
    return requestOutline(this.#surface!, this.#view.camera, this.#size, signal);
  }

  #render(): void {
    sinkSurface(this.#halos.reach, this.#view.camera, this.#size.height);
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
