import {
  Color,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { SeenLine } from '../export/svg';
import type { DrawnGeometry } from '../worker/geometry';
import { FatLine } from './fat_line';
import { colorSurface, type Pick, Surface } from './surface';

export interface ViewerColors {
  front: string;
  back: string;
  sky: string;
  ground: string;
  edges: string;
  curve: string;
  lost: string;
  polygon: string;
  center: string;
}

const fieldOfView = 30;
/** The part of its bounding sphere that a surface rarely leaves, with some room around it. */
const margin = 0.88;
const startDirection = new Vector3(0.34, 0.22, 1).normalize();
/** The surface's color where it is lit as most of it is. */
const surfaceShade = 0.75;
const flightMilliseconds = 260;
/** From how far a place is looked at, unless the view is nearer already. */
const closeDistance = 1.6;

/** Where the camera is from what it looks at. */
interface Place {
  offset: Vector3;
  target: Vector3;
}

/** The view of a surface with a curve on it. Draws only when something changed. */
export class Viewer {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  readonly #controls: OrbitControls;
  readonly #raycaster = new Raycaster();
  readonly #curve = new FatLine({ width: 4, hidden: 0.26 }, 4);
  readonly #lost = new FatLine({ width: 4, dashed: true, hidden: 0.4 }, 4);
  readonly #polygon = new FatLine({ width: 1.5, hidden: 0.25 }, 2);
  readonly #sketch = new FatLine({ width: 2.5, dashed: true, hidden: 0.25 }, 2);
  readonly #lines = [this.#curve, this.#lost, this.#polygon, this.#sketch];
  readonly #beforeFrame: (() => void)[] = [];
  #surface: Surface | null = null;
  #edges = false;
  #frame = 0;
  /** Whether the view was not touched since it was reset; it then goes with the stage's size. */
  #whole = true;
  #flight: { from: Place; to: Place; started: number } | null = null;

  /** `stage` takes the pointer; the canvas fills it. Throws where there is no WebGL 2. */
  constructor(
    private readonly stage: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    options: { antialias: boolean },
  ) {
    const context = canvas.getContext('webgl2', { alpha: true, ...options });
    if (!context) {
      throw new Error(
        'WebGL 2, which draws the surface, is missing or switched off. Check that graphics acceleration is allowed in the settings.',
      );
    }
    this.#renderer = new WebGLRenderer({ canvas, context });
    this.#scene.add(...this.#lines.map((line) => line.object));
    this.#controls = new OrbitControls(this.#camera, stage);
    this.#controls.zoomToCursor = true;
    this.#controls.minDistance = 0.15;
    this.#controls.maxDistance = 20;
    let touched = false;
    this.#controls.addEventListener('start', () => {
      touched = true;
      this.#flight = null;
    });
    this.#controls.addEventListener('end', () => {
      touched = false;
    });
    this.#controls.addEventListener('change', () => {
      if (touched) this.#whole = false;
      this.requestFrame();
    });
    new ResizeObserver(() => this.#resize()).observe(stage);
    this.#resize();
  }

  /** Called before each frame is drawn, with the camera as it will be. */
  onFrame(listener: () => void): void {
    this.#beforeFrame.push(listener);
  }

  requestFrame(): void {
    this.#frame ||= requestAnimationFrame((now) => {
      this.#frame = 0;
      this.#fly(now);
      this.#camera.updateMatrixWorld();
      for (const line of this.#lines) line.follow(this.#camera.position);
      for (const listener of this.#beforeFrame) listener();
      this.#renderer.render(this.#scene, this.#camera);
    });
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
    this.#scene.add(this.#surface.object);
    this.showCurve(null);
    this.showPolygon([], false);
    return this.#surface;
  }

  set colors(colors: ViewerColors) {
    colorSurface(colors);
    const surface = new Color(colors.front).multiplyScalar(surfaceShade);
    this.#curve.setColor(new Color(colors.curve), surface);
    this.#lost.setColor(new Color(colors.lost), surface);
    this.#polygon.setColor(new Color(colors.polygon), surface);
    this.#sketch.setColor(new Color(colors.curve), surface);
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
      // A vertex's status is that of the sample it leads to.
      const lost = (segment: number) => curve.polylineStatus[segment + 1] === 1;
      this.#curve.setChosen(line, (segment) => !lost(segment));
      this.#lost.setChosen(line, lost);
    } else {
      this.#curve.clear();
      this.#lost.clear();
    }
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
    const box = this.canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.#camera.updateMatrixWorld();
    this.#raycaster.setFromCamera(place, this.#camera);
    return this.#surface.pick(this.#raycaster.ray);
  }

  /** Where a point of the scene is on the stage, in CSS pixels, and whether the surface hides it. */
  project(position: Vector3): { x: number; y: number; hidden: boolean } {
    const { ray } = this.#raycaster;
    const distance = this.#camera.position.distanceTo(position);
    ray.origin.copy(this.#camera.position);
    ray.direction.copy(position).sub(ray.origin).normalize();
    const hidden = (this.#surface?.depth(ray) ?? Infinity) < distance - 0.004;
    const place = position.clone().project(this.#camera);
    const { clientWidth, clientHeight } = this.stage;
    const x = ((place.x + 1) / 2) * clientWidth;
    const y = ((1 - place.y) / 2) * clientHeight;
    return { x, y, hidden: hidden || place.z > 1 };
  }

  /** The stage's size, in CSS pixels. */
  get size(): { width: number; height: number } {
    return { width: this.stage.clientWidth, height: this.stage.clientHeight };
  }

  /** A polyline in the surface's coordinates as it is seen on the stage. */
  seen(polyline: Float32Array): SeenLine {
    const line: SeenLine = { x: [], y: [], hidden: [] };
    const places = this.#surface?.toScene(polyline) ?? [];
    for (let i = 0; i < places.length; i += 3) {
      const { x, y, hidden } = this.project(new Vector3().fromArray(places, i));
      line.x.push(x);
      line.y.push(y);
      line.hidden.push(hidden);
    }
    return line;
  }

  /** The camera's direction to the right, in the surface's coordinates. */
  get right(): [number, number, number] {
    return new Vector3().setFromMatrixColumn(this.#camera.matrixWorld, 0).toArray();
  }

  /** Turns the view about its target, by angles in radians. */
  orbit(aside: number, up: number): void {
    this.#whole = false;
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const polar = Math.min(
      Math.PI - 0.02,
      Math.max(0.02, offset.angleTo(new Vector3(0, 1, 0)) - up),
    );
    const azimuth = Math.atan2(offset.x, offset.z) + aside;
    offset.setFromSphericalCoords(offset.length(), polar, azimuth);
    this.#camera.position.copy(this.#controls.target).add(offset);
    this.#controls.update();
  }

  zoom(factor: number): void {
    this.#whole = false;
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const length = Math.min(20, Math.max(0.15, offset.length() * factor));
    this.#camera.position.copy(this.#controls.target).add(offset.setLength(length));
    this.#controls.update();
  }

  /** The whole surface, from the front; at once where motion is not wanted. */
  resetView(options: { animated: boolean }): void {
    this.#whole = true;
    this.#go({
      offset: startDirection.clone().multiplyScalar(this.#wholeDistance()),
      target: new Vector3(),
      animated: options.animated,
    });
  }

  /** Puts a point of the scene in the middle, seen from straight above the surface there. */
  lookAt(position: Vector3): void {
    if (!this.#surface) return;
    this.#whole = false;
    const far = this.#camera.position.distanceTo(this.#controls.target);
    const offset = this.#surface.normal(this.#surface.nearest(position));
    offset.multiplyScalar(Math.min(far, closeDistance));
    this.#go({ offset, target: position.clone(), animated: true });
  }

  #go({ animated, ...to }: Place & { animated: boolean }): void {
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (animated && !still) {
      const target = this.#controls.target.clone();
      const from = { offset: this.#camera.position.clone().sub(target), target };
      this.#flight = { from, to, started: performance.now() };
    } else {
      this.#flight = null;
      this.#aim(to);
    }
    this.requestFrame();
  }

  #aim({ offset, target }: Place): void {
    this.#camera.position.copy(target).add(offset);
    this.#controls.target.copy(target);
    this.#controls.update();
  }

  #fly(now: number): void {
    if (!this.#flight) return;
    const { from, to, started } = this.#flight;
    const part = Math.min(1, Math.max(0, (now - started) / flightMilliseconds));
    const eased = 1 - (1 - part) ** 3;
    const [a, b] = [from.offset.clone().normalize(), to.offset.clone().normalize()];
    const turn = new Quaternion().slerp(new Quaternion().setFromUnitVectors(a, b), eased);
    const [near, far] = [from.offset.length(), to.offset.length()];
    const offset = a.applyQuaternion(turn).multiplyScalar(near + (far - near) * eased);
    this.#aim({ offset, target: from.target.clone().lerp(to.target, eased) });
    if (part < 1) this.requestFrame();
    else this.#flight = null;
  }

  /** From how far the bounding sphere, of radius 1, fills the stage. */
  #wholeDistance(): number {
    const half = (fieldOfView * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.#camera.aspect));
    return margin / Math.sin(narrow);
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.stage;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.#camera.aspect = clientWidth / clientHeight;
    this.#camera.updateProjectionMatrix();
    if (this.#whole) this.resetView({ animated: false });
    this.requestFrame();
  }
}
