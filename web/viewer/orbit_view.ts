import { MathUtils, MOUSE, PerspectiveCamera, Quaternion, Ray, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type ViewPlace, viewNames } from '../model/view_place';
import type { Surface } from './surface';
import { views } from './views';

const fieldOfView = 30;
const halfSlope = Math.tan((fieldOfView * Math.PI) / 360);
/** The radius of the ball around the scene's middle that holds the surface. */
const ballRadius = 1;
/** The extent that a surface rarely exceeds, relative to its bounding sphere's radius. */
const margin = 0.88;
/** The fraction of the stage's width that a surface may take. */
const widthTaken = 0.94;
const startDirection = new Vector3(0.34, 0.22, 1).normalize();
const flightMilliseconds = 260;
/** The largest distance at which the camera stops in front of a place. */
const closeDistance = 1.6;
/**
 * The range of the camera's distance from its target. At the smallest distance a pixel is as large
 * as the rounding of a coordinate of the scene on the graphics card.
 */
const [nearest, farthest] = [2e-4, 20];
/** The least distance from which the camera shows a whole ball. */
const nearestWhole = 0.16;
/** The smallest `reach` of a place that the view returns. */
const leastReach = 1e-4;
/** The range of the distance of the camera's near plane. */
const [leastNear, mostNear] = [1e-5, 0.002];
/** The factor on distances for a turn of the wheel by one pixel. */
const wheelFactor = 0.95 ** -0.01;
/**
 * The pixels that the wheel turns for a line and for a page, and the factor for a pinch on a
 * touchpad.
 */
const [pixelsOfLine, pixelsOfPage, pixelsOfPinch] = [16, 100, 10];
/**
 * The rings of the search for the surface around a place: the first radius in pixels, the ratio of
 * a radius to the previous one, and the number of rays of a ring.
 */
const [firstRing, nextRing, raysOfRing] = [4, 1.3, 32];
/** The factor on a fitted ball's radius, for some room around the ball. */
const roomAround = 1.25;

/** The place that the camera looks at, and the camera's offset from it. */
interface Place {
  offset: Vector3;
  target: Vector3;
}

/** The camera, and its motion by pointer, keys and flights. */
export class OrbitView {
  readonly camera = new PerspectiveCamera(fieldOfView, 1, 0.002, 100);
  /** The surface in view; null until there is one. */
  surface: Surface | null = null;
  readonly #controls: OrbitControls;
  /**
   * The camera's direction while the whole surface is in view; null after the user has moved the
   * view. While it is not null, the whole surface stays in view when the stage's size changes.
   */
  #whole: Vector3 | null = startDirection;
  #flight: { from: Place; to: Place; started: number } | null = null;
  /** The pivot of turns: a point of the scene, and its place in the camera's view. */
  #pivot: { point: Vector3; seen: Vector3 } | null = null;
  /** The pressed pointers with their places: two fingers zoom and move. */
  readonly #pointers = new Map<number, { x: number; y: number }>();
  /** The camera's place at the last call of `moved`. */
  readonly #told = new Vector3();

  /** The view calls `moved` to request a frame. */
  constructor(
    private readonly stage: HTMLElement,
    private readonly moved: () => void,
  ) {
    // This listener runs before the controls: the surface under the pointer becomes the pivot of
    // turns and the target of zooms.
    stage.addEventListener('pointerdown', (event) => this.#hold(event), { capture: true });
    stage.addEventListener('wheel', (event) => this.#wheel(event), {
      ...{ capture: true, passive: false },
    });
    window.addEventListener('pointermove', (event) => this.#pinch(event), { capture: true });
    // This listener runs after the controls' listeners, which do not report small changes of a near
    // view.
    window.addEventListener('pointermove', () => {
      if (this.#pointers.size > 0 && !this.#told.equals(this.camera.position)) this.#tell();
    });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      window.addEventListener(type, ({ pointerId }) => {
        this.#pivot = null;
        this.#pointers.delete(pointerId);
      });
    }
    this.#controls = new OrbitControls(this.camera, stage);
    // The controls' own cursor would hide the cursors that show the effect of a gesture.
    stage.style.cursor = '';
    this.#controls.enableZoom = false;
    this.#controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.ROTATE };
    this.#controls.maxDistance = farthest;
    let touched = false;
    this.#controls.addEventListener('start', () => {
      touched = true;
      this.#flight = null;
    });
    this.#controls.addEventListener('end', () => {
      touched = false;
    });
    this.#controls.addEventListener('change', () => {
      if (touched) this.#whole = null;
      this.#keepPivot();
      this.#tell();
    });
  }

  #tell(): void {
    this.#told.copy(this.camera.position);
    this.moved();
  }

  /** Whether the main button moves the view instead of turning it. */
  set moves(moves: boolean) {
    this.#controls.mouseButtons.LEFT = moves ? MOUSE.PAN : MOUSE.ROTATE;
  }

  /** The visible point of the surface at a place of the window; null beside the surface. */
  #at(x: number, y: number): Vector3 | null {
    const { left, top, width, height } = this.stage.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const origin = this.camera.position;
    const place = new Vector3((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height, 0.5);
    const direction = place.unproject(this.camera).sub(origin).normalize();
    const depth = this.surface?.depth(new Ray(origin.clone(), direction)) ?? Infinity;
    return Number.isFinite(depth) ? direction.multiplyScalar(depth).add(origin) : null;
  }

  /** A visible point of the surface near a place of the window; null without one. */
  #near(x: number, y: number): Vector3 | null {
    const { left, top, width, height } = this.stage.getBoundingClientRect();
    for (let ring = firstRing; ring < width + height; ring *= nextRing) {
      for (let ray = 0; ray < raysOfRing; ray++) {
        const angle = (2 * Math.PI * ray) / raysOfRing;
        const [h, v] = [x + ring * Math.cos(angle), y + ring * Math.sin(angle)];
        const isOn = h >= left && v >= top && h <= left + width && v <= top + height;
        const point = isOn ? this.#at(h, v) : null;
        if (point) return point;
      }
    }
    return null;
  }

  get #middle(): { x: number; y: number } {
    const { left, top, width, height } = this.stage.getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }

  /**
   * Moves the controls' target to the depth of the surface at a place of the window. If the place
   * is beside the surface, the middle of the window replaces it. The view does not change, but the
   * controls move it in proportion to the target's distance. Returns the surface's point, or null
   * if neither place shows the surface.
   */
  #turnTo(x: number, y: number): Vector3 | null {
    const { x: h, y: v } = this.#middle;
    const point = this.#at(x, y) ?? this.#at(h, v);
    if (point && !this.#flight) this.#putTarget(point);
    return point;
  }

  #putTarget(point: Vector3): void {
    const { target } = this.#controls;
    const { position } = this.camera;
    const forward = target.clone().sub(position).normalize();
    const depth = point.clone().sub(position).dot(forward);
    if (depth > 0) target.copy(position).addScaledVector(forward, Math.max(nearest, depth));
  }

  /**
   * Zooms at the surface's visible point at a place of the window: multiplies the distances of the
   * camera and its target from this point. If the place is beside the surface, the point is a
   * visible one nearby or, without one, the target. The point stays in place in the window, and no
   * step passes through the surface.
   */
  #zoomAt(x: number, y: number, factor: number): void {
    this.#flight = null;
    this.#whole = null;
    const { target } = this.#controls;
    const { position } = this.camera;
    const point = this.#at(x, y) ?? this.#near(x, y) ?? target.clone();
    this.#putTarget(point);
    const far = position.distanceTo(point);
    const least = Math.min(1, nearest / far);
    const most = Math.max(1, farthest / far);
    const by = Math.min(most, Math.max(least, factor)) - 1;
    for (const place of [position, target]) place.addScaledVector(place.clone().sub(point), by);
    this.#controls.update();
    this.#tell();
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    if (this.#pointers.size > 0) return;
    const unit =
      event.deltaMode === WheelEvent.DOM_DELTA_LINE
        ? pixelsOfLine
        : event.deltaMode === WheelEvent.DOM_DELTA_PAGE
          ? pixelsOfPage
          : 1;
    // A pinch on a touchpad is a wheel event with Ctrl.
    const pixels = event.deltaY * unit * (event.ctrlKey ? pixelsOfPinch : 1);
    this.#zoomAt(event.clientX, event.clientY, wheelFactor ** pixels);
  }

  /** Zooms at the place between two fingers as their distance changes. */
  #pinch({ pointerId, clientX, clientY }: PointerEvent): void {
    if (!this.#pointers.has(pointerId)) return;
    const apart = () => {
      const [one, other] = [...this.#pointers.values()];
      return other ? Math.hypot(one!.x - other.x, one!.y - other.y) : 0;
    };
    const before = apart();
    this.#pointers.set(pointerId, { x: clientX, y: clientY });
    const after = apart();
    if (before === 0 || after === 0) return;
    const [one, other] = [...this.#pointers.values()];
    this.#zoomAt((one!.x + other!.x) / 2, (one!.y + other!.y) / 2, before / after);
  }

  /** Adapts the camera's near plane to the surface's distance, before a frame is drawn. */
  fitDepth(): void {
    const away = this.surface?.distanceWithin(this.camera.position, 2 * mostNear) ?? null;
    const near = away === null ? mostNear : Math.min(mostNear, Math.max(leastNear, away / 2));
    if (near === this.camera.near) return;
    this.camera.near = near;
    this.camera.updateProjectionMatrix();
  }

  #hold(event: PointerEvent): void {
    this.#flight = null;
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const found = this.#turnTo(event.clientX, event.clientY);
    const isBeside = !this.#at(event.clientX, event.clientY);
    // If the press is beside a surface that is completely in sight, the turn is about the surface's
    // middle, so that the whole surface stays in sight.
    const isWhole = isBeside && this.camera.position.length() > ballRadius;
    const point = isWhole ? new Vector3() : found;
    const { mouseButtons } = this.#controls;
    const moves =
      event.ctrlKey ||
      event.metaKey ||
      event.shiftKey ||
      this.#pointers.size > 1 ||
      !event.isPrimary;
    const isTurned =
      !moves && (event.button === 2 || (event.button === 0 && mouseButtons.LEFT === MOUSE.ROTATE));
    const { position, quaternion } = this.camera;
    const seen = point?.clone().sub(position).applyQuaternion(quaternion.clone().invert());
    this.#pivot = point && seen && isTurned ? { point, seen } : null;
  }

  /**
   * Moves the camera so that the pivot is back at its place in the view. The controls alone turn
   * about the middle of the stage.
   */
  #keepPivot(): void {
    if (!this.#pivot) return;
    const { point, seen } = this.#pivot;
    const { position, quaternion } = this.camera;
    const to = point.clone().sub(seen.clone().applyQuaternion(quaternion));
    this.#controls.target.add(to.clone().sub(position));
    position.copy(to);
  }

  /** Fits a ball into the stage, seen from the present direction or from another one. */
  fit(center: Vector3, radius: number, direction: Vector3 | null): void {
    this.#whole = null;
    const from = direction ?? this.camera.position.clone().sub(this.#controls.target);
    const far = (roomAround * radius) / Math.sin(this.#narrowAngle);
    const offset = from.clone().setLength(Math.min(farthest, Math.max(nearestWhole, far)));
    this.#go({ offset, target: center.clone() }, true);
  }

  /** Adapts to another size of the stage. */
  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.#showWhole(false);
  }

  /** Turns the view about its target, by angles in radians. */
  orbit(aside: number, up: number): void {
    this.#whole = null;
    const offset = this.camera.position.clone().sub(this.#controls.target);
    const polar = Math.min(
      Math.PI - 0.02,
      Math.max(0.02, offset.angleTo(new Vector3(0, 1, 0)) - up),
    );
    const azimuth = Math.atan2(offset.x, offset.z) + aside;
    offset.setFromSphericalCoords(offset.length(), polar, azimuth);
    this.camera.position.copy(this.#controls.target).add(offset);
    this.#controls.update();
  }

  /** Zooms in the middle of the stage. */
  zoom(factor: number): void {
    const { x, y } = this.#middle;
    this.#zoomAt(x, y, factor);
  }

  /** Moves the view by a number of CSS pixels, measured at the middle of the stage. */
  pan(x: number, y: number): void {
    const { height } = this.stage.getBoundingClientRect();
    const { x: h, y: v } = this.#middle;
    this.#turnTo(h, v);
    this.#whole = null;
    const { camera } = this;
    const { target } = this.#controls;
    const seen =
      2 * Math.tan(MathUtils.degToRad(camera.fov) / 2) * camera.position.distanceTo(target);
    const by = new Vector3(x, -y, 0)
      .multiplyScalar(seen / height)
      .applyQuaternion(camera.quaternion);
    camera.position.add(by);
    target.add(by);
    this.#controls.update();
    this.#tell();
  }

  /**
   * Returns to the default view of the whole; at once if `animated` is false or the user does not
   * want motion.
   */
  reset({ animated }: { animated: boolean }): void {
    this.#whole = startDirection;
    this.#showWhole(animated);
  }

  /** The place of the camera, now or after the present flight; null for the default view. */
  get place(): ViewPlace | null {
    if (this.#whole) return viewNames.find((name) => views[name] === this.#whole) ?? null;
    const { offset, target } = this.#flight?.to ?? {
      target: this.#controls.target,
      offset: this.camera.position.clone().sub(this.#controls.target),
    };
    const { radius, phi, theta } = new Spherical().setFromVector3(offset);
    return {
      azimuth: MathUtils.radToDeg(theta),
      elevation: 90 - MathUtils.radToDeg(phi),
      reach: Math.max(leastReach, radius * Math.sin(this.#narrowAngle)),
      target: target.toArray(),
    };
  }

  /**
   * Shows the scene from a place. The ball of radius `reach` around the place's target just fits.
   */
  show(place: ViewPlace, { animated }: { animated: boolean }): void {
    if (typeof place === 'string') {
      this.#whole = views[place];
      this.#showWhole(animated);
      return;
    }
    this.#whole = null;
    const { azimuth, elevation, reach, target } = place;
    const far = Math.min(farthest, Math.max(nearest, reach / Math.sin(this.#narrowAngle)));
    const [polar, around] = [90 - elevation, azimuth].map(MathUtils.degToRad) as [number, number];
    const offset = new Vector3().setFromSphericalCoords(far, polar, around);
    this.#go({ offset, target: new Vector3(...target) }, animated);
  }

  #showWhole(animated: boolean): void {
    if (!this.#whole) return;
    const offset = this.#whole.clone().multiplyScalar(this.#wholeDistance(this.#whole));
    this.#go({ offset, target: new Vector3() }, animated);
  }

  /** Puts a point in the middle, seen from a direction. */
  lookAt(target: Vector3, direction: Vector3): void {
    this.#whole = null;
    const far = this.camera.position.distanceTo(this.#controls.target);
    const offset = direction.clone().setLength(Math.min(far, closeDistance));
    this.#go({ offset, target: target.clone() }, true);
  }

  /** Continues a flight. The viewer calls it before it draws a frame. */
  advance(now: number): void {
    if (!this.#flight) return;
    const { from, to, started } = this.#flight;
    const part = Math.min(1, Math.max(0, (now - started) / flightMilliseconds));
    const eased = 1 - (1 - part) ** 3;
    const [a, b] = [from.offset.clone().normalize(), to.offset.clone().normalize()];
    const turn = new Quaternion().slerp(new Quaternion().setFromUnitVectors(a, b), eased);
    const [near, far] = [from.offset.length(), to.offset.length()];
    const offset = a.applyQuaternion(turn).multiplyScalar(near + (far - near) * eased);
    this.#aim({ offset, target: from.target.clone().lerp(to.target, eased) });
    if (part < 1) this.moved();
    else this.#flight = null;
  }

  #go(to: Place, animated: boolean): void {
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (animated && !still) {
      const target = this.#controls.target.clone();
      const from = { offset: this.camera.position.clone().sub(target), target };
      this.#flight = { from, to, started: performance.now() };
    } else {
      this.#flight = null;
      this.#aim(to);
    }
    this.moved();
  }

  #aim({ offset, target }: Place): void {
    this.camera.position.copy(target).add(offset);
    this.#controls.target.copy(target);
    this.#controls.update();
  }

  /** Half the angle of view along the stage's narrower side, in radians. */
  get #narrowAngle(): number {
    return Math.atan(halfSlope * Math.min(1, this.camera.aspect));
  }

  /** The distance from which the surface, in a bounding sphere of radius 1, fits into the stage. */
  #wholeDistance(direction: Vector3): number {
    const narrow = this.#narrowAngle;
    const wide = widthTaken * halfSlope * this.camera.aspect;
    const width = this.surface?.widthDistance(direction, wide) ?? 0;
    return Math.max(margin / Math.sin(narrow), width);
  }
}
