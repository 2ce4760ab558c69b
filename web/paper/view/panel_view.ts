import {
  type BufferGeometry,
  Color,
  type Mesh,
  PerspectiveCamera,
  Raycaster,
  Scene,
  type ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { DrawnGeometry } from '../../viewer/drawn_geometry';
import { FatLine, fineDash } from '../../viewer/fat_line';
import { fitSurface, Surface } from '../../viewer/surface';
import { Vantage } from '../../viewer/vantage';
import type { LineResult, Panel, Vector } from '../figures/types';
import type { SharedRenderer } from './shared_renderer';

const fieldOfView = 30;
/** The extent that a surface rarely exceeds, relative to its bounding sphere's radius. */
const margin = 0.86;
/** The widest line of a figure, in CSS pixels. */
const widestLine = 4;
/** The brightness of most of the surface under the light, relative to its color. */
const surfaceShade = 0.75;

export interface LineLook {
  color: Color;
  width: number;
  /** Whether the surface hides the line completely. */
  opaque: boolean;
}

interface ShownLine {
  seen: FatLine;
  lost: FatLine;
}

/**
 * The view of one panel: a surface and its lines. It draws only after changes, and only while it is
 * visible.
 */
export class PanelView {
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #raycaster = new Raycaster();
  readonly #lines = new Map<string, ShownLine>();
  readonly #beforeFrame: (() => void)[] = [];
  #surface: Surface | null = null;
  #surfaceColor = new Color();
  #edges: boolean;
  #frame = 0;
  #seen = false;
  #stale = true;

  constructor(
    private readonly renderer: SharedRenderer,
    readonly stage: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly panel: Panel,
  ) {
    this.#edges = panel.view?.edges ?? false;
    this.#controls = new OrbitControls(this.#camera, stage);
    // The wheel and a finger that moves up or down scroll the page.
    this.#controls.enableZoom = false;
    this.#controls.enablePan = false;
    stage.style.touchAction = 'pan-y';
    stage.addEventListener('wheel', (event) => this.#zoom(event), { passive: false });
    this.#controls.addEventListener('change', () => this.requestFrame());
    renderer.onRestored(() => this.requestFrame());
    new ResizeObserver(() => this.#resize()).observe(stage);
    new IntersectionObserver(([entry]) => {
      this.#seen = entry!.isIntersecting;
      if (this.#seen && this.#stale) this.requestFrame();
    }).observe(stage);
  }

  get surface(): Surface | null {
    return this.#surface;
  }

  get camera(): PerspectiveCamera {
    return this.#camera;
  }

  onFrame(listener: () => void): void {
    this.#beforeFrame.push(listener);
  }

  requestFrame(): void {
    this.#stale = true;
    if (this.#seen) this.#frame ||= requestAnimationFrame(() => this.draw());
  }

  /** Draws at once. */
  draw(): void {
    this.#frame = 0;
    this.#stale = false;
    const { clientWidth, clientHeight } = this.stage;
    if (!this.#surface || clientWidth === 0 || clientHeight === 0) return;
    this.#camera.updateMatrixWorld();
    for (const { seen, lost } of this.#lines.values()) {
      seen.follow(this.#camera.position);
      lost.follow(this.#camera.position);
    }
    fitSurface(widestLine / 2, this.#camera, clientHeight);
    for (const listener of this.#beforeFrame) listener();
    this.renderer.draw(this.#scene, this.#camera, this.canvas, clientWidth, clientHeight);
  }

  /** Draws an enlarged neighbourhood of a place of the stage into a canvas. */
  drawAround(
    { x, y }: { x: number; y: number },
    times: number,
    canvas: HTMLCanvasElement,
    width: number,
    height: number,
  ): void {
    if (!this.#surface) return;
    const { clientWidth, clientHeight } = this.stage;
    const [left, top] = [times * x - width / 2, times * y - height / 2];
    this.#camera.setViewOffset(times * clientWidth, times * clientHeight, left, top, width, height);
    this.renderer.draw(this.#scene, this.#camera, canvas, width, height);
    this.#camera.clearViewOffset();
  }

  /** Shows a surface, and removes the previous one. */
  showSurface(drawn: DrawnGeometry): void {
    if (this.#surface) {
      this.#scene.remove(this.#surface.object);
      this.#surface.dispose();
    }
    this.#surface = new Surface(drawn);
    this.#surface.edges = this.#edges;
    ownMaterials(this.#surface);
    this.#scene.add(this.#surface.object);
    this.resetView([]);
  }

  /** Whether this surface and those after it show their triangles. */
  get edges(): boolean {
    return this.#edges;
  }

  set edges(visible: boolean) {
    this.#edges = visible;
    if (this.#surface) this.#surface.edges = visible;
    this.requestFrame();
  }

  /** Shows a line in place of one with the same key. Lines of higher order lie above the others. */
  showLine(key: string, line: LineResult, look: LineLook, order: number): void {
    if (!this.#surface) return;
    let shown = this.#lines.get(key);
    if (!shown) {
      shown = {
        seen: new FatLine({ width: look.width, hidden: 0.2 }, order),
        lost: new FatLine({ width: look.width, hidden: 0.2, dash: fineDash }, order),
      };
      // The first child is the part of a line that the surface hides.
      shown.seen.object.children[0]!.visible = !look.opaque;
      this.#lines.set(key, shown);
      this.#scene.add(shown.seen.object, shown.lost.object);
    }
    const whole: Float32Array[] = [];
    const broken: Float32Array[] = [];
    line.polylines.forEach((polyline, i) => {
      const scene = this.#surface!.toScene(polyline);
      for (const { part, lost } of partsOf(scene, line.status[i]))
        (lost ? broken : whole).push(part);
    });
    shown.seen.set(whole);
    shown.lost.set(broken);
    this.#color(shown, look);
    this.requestFrame();
  }

  hideLine(key: string): void {
    const shown = this.#lines.get(key);
    shown?.seen.clear();
    shown?.lost.clear();
    this.requestFrame();
  }

  /** The color into which the hidden parts of the lines fade. */
  set surfaceColor(color: Color) {
    this.#surfaceColor = color.clone().multiplyScalar(surfaceShade);
    this.requestFrame();
  }

  recolor(key: string, look: LineLook): void {
    const shown = this.#lines.get(key);
    if (shown) this.#color(shown, look);
    this.requestFrame();
  }

  toScene(place: Vector): Vector3 {
    return new Vector3(...(this.#surface?.toScene(Float32Array.from(place)) ?? place));
  }

  /** The place under the pointer, in the mesh's coordinates; null beside the surface. */
  pick(clientX: number, clientY: number): Vector | null {
    if (!this.#surface) return null;
    const box = this.canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.#camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(place, this.#camera);
    const hit = this.#surface.pick(this.#raycaster.ray);
    if (!hit) return null;
    return this.#surface.fromScene(hit.position);
  }

  /** The present view. */
  get vantage(): Vantage {
    const { clientWidth: width, clientHeight: height } = this.stage;
    return new Vantage(this.#surface, this.#camera, { width, height });
  }

  /** The place of a scene's point on the stage, in CSS pixels, and whether the point is hidden. */
  project(position: Vector3): ReturnType<Vantage['project']> {
    return this.vantage.project(position);
  }

  /**
   * Restores the panel's initial view. `places` are the panel's points; the view may be close to
   * one of them.
   */
  resetView(places: readonly Vector[]): void {
    const { from = [0.34, 0.22, 1], at, distance = 1 } = this.panel.view ?? {};
    const target = new Vector3();
    let offset = new Vector3(...from).normalize().multiplyScalar(this.#wholeDistance());
    const place = at === undefined ? undefined : places[at];
    if (place && this.#surface) {
      target.copy(this.toScene(place));
      offset = this.#surface.normal(this.#surface.nearest(target)).multiplyScalar(distance);
    }
    this.#camera.up.set(0, 1, 0);
    this.#camera.position.copy(target).add(offset);
    this.#controls.target.copy(target);
    this.#controls.update();
    this.requestFrame();
  }

  /** The wheel zooms with Ctrl; a pinch on a touchpad sends the same events. */
  #zoom(event: WheelEvent): void {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const length = Math.min(20, Math.max(0.15, offset.length() * Math.exp(event.deltaY / 200)));
    this.#camera.position.copy(this.#controls.target).add(offset.setLength(length));
    this.#controls.update();
    this.requestFrame();
  }

  #color({ seen, lost }: ShownLine, { color }: LineLook): void {
    seen.setColor(color, this.#surfaceColor);
    lost.setColor(color, this.#surfaceColor);
  }

  #wholeDistance(): number {
    const half = (fieldOfView * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.#camera.aspect));
    return margin / Math.sin(narrow);
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.stage;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    this.requestFrame();
  }
}

/**
 * Gives a surface copies of the shared materials, since these show only the outer sides of the
 * newest surface. The copies still share the colors.
 */
function ownMaterials(surface: Surface): void {
  const mesh = surface.object.children[0] as Mesh<BufferGeometry, ShaderMaterial[]>;
  mesh.material = mesh.material.map((shared) => {
    const own = shared.clone();
    own.uniforms = shared.uniforms;
    return own;
  });
}

/** Splits a polyline, in order, into parts that converged and parts that are lost. */
function partsOf(
  line: Float32Array,
  status: Uint8Array | undefined,
): { part: Float32Array; lost: boolean }[] {
  if (!status?.includes(1)) return [{ part: line, lost: false }];
  const parts: { part: Float32Array; lost: boolean }[] = [];
  let begin = 0;
  for (let i = 1; i < status.length; i++) {
    // A vertex has the status of the sample that it leads to.
    if (i + 1 < status.length && status[i + 1] === status[i]) continue;
    parts.push({ part: line.subarray(3 * begin, 3 * (i + 1)), lost: status[i] === 1 });
    begin = i;
  }
  return parts;
}
