import {
  type BufferAttribute,
  BufferGeometry,
  type Camera,
  type Object3D,
  Points,
  PointsMaterial,
  Raycaster,
  Vector2,
  type Vector3,
} from 'three';
import { KarcherError } from '../errors.js';
import { liftMaterial } from './fat_line.js';
import type { SurfaceCurve } from './surface_curve.js';

/**
 * A control point appears nearer to the camera by this fraction of its distance from the camera.
 * The surface may lie in front of a visible point by the same fraction. The fraction is larger than
 * that of a line, since a sloping surface would hide more of a point's square.
 */
const nearer = 0.01;

function handleMaterial(): PointsMaterial {
  const material = new PointsMaterial({ color: 0x1a1a1a, size: 9, sizeAttenuation: false });
  liftMaterial(material, '#include <project_vertex>\n', nearer);
  return material;
}

/** For each element, the number of its drags and its `touchAction` without them. */
const dragsOn = new WeakMap<HTMLElement, { count: number; touchAction: string }>();

/** The options for dragging control points. */
export interface CurveDragOptions {
  /**
   * The distance from a control point, in pixels, within which a press takes hold of it; 12 by
   * default.
   */
  reach?: number;
}

/**
 * Lets the user drag the control points of a curve over its surface: draws the visible ones, and
 * listens to the pointer on an element. It stops the event of a press that takes hold of a point,
 * so that camera controls on the same element leave the view alone.
 */
export class CurveDrag {
  /**
   * A function that receives the error of an edit, such as `unreachable` if the pointer is over
   * another connected component of the mesh.
   */
  onError: ((error: unknown) => void) | undefined;
  /** The number of the dragged control point, or -1. */
  dragged = -1;
  readonly #curve: SurfaceCurve;
  readonly #object: Object3D;
  readonly #camera: Camera;
  readonly #element: HTMLElement;
  readonly #reach: number;
  #isDisposed = false;
  /** The pointer that drags a point, or dragged one. */
  #pointerId = -1;
  readonly #handles = new Points(new BufferGeometry(), handleMaterial());
  readonly #raycaster = new Raycaster();

  /** `object` draws the curve's surface. */
  constructor(
    curve: SurfaceCurve,
    object: Object3D,
    camera: Camera,
    element: HTMLElement,
    { reach = 12 }: CurveDragOptions = {},
  ) {
    this.#curve = curve;
    this.#object = object;
    this.#camera = camera;
    this.#element = element;
    this.#reach = reach;
    const drags = dragsOn.get(element) ?? { count: 0, touchAction: element.style.touchAction };
    dragsOn.set(element, drags);
    drags.count++;
    // Otherwise a finger would also scroll the page.
    element.style.touchAction = 'none';
    curve.add(this.#handles);
    curve.addEventListener('change', this.#show);
    this.#show();
    element.addEventListener('pointerdown', this.#press, { capture: true });
    element.addEventListener('pointermove', this.#move);
    element.addEventListener('pointerup', this.#release);
    element.addEventListener('pointercancel', this.#release);
  }

  /** Stops listening to the pointer; the curve stays. */
  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    const element = this.#element;
    const drags = dragsOn.get(element)!;
    if (--drags.count === 0) {
      element.style.touchAction = drags.touchAction;
      dragsOn.delete(element);
    }
    element.removeEventListener('pointerdown', this.#press, { capture: true });
    element.removeEventListener('pointermove', this.#move);
    element.removeEventListener('pointerup', this.#release);
    element.removeEventListener('pointercancel', this.#release);
    this.#curve.removeEventListener('change', this.#show);
    this.#handles.removeFromParent();
    this.#handles.geometry.dispose();
    this.#handles.material.dispose();
  }

  readonly #show = (): void => {
    const { surface, value } = this.#curve;
    const places = value.points.map((point) => surface.position(point));
    const { geometry } = this.#handles;
    const attribute = geometry.getAttribute('position') as BufferAttribute | undefined;
    if (attribute?.count === places.length) {
      places.forEach((place, i) => {
        attribute.setXYZ(i, place.x, place.y, place.z);
      });
      attribute.needsUpdate = true;
    } else {
      geometry.dispose();
      // `setFromPoints` would write into the old attribute, which has room for its own count only.
      geometry.deleteAttribute('position').setFromPoints(places);
    }
    geometry.computeBoundingSphere();
  };

  readonly #press = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    if (this.dragged >= 0 && event.pointerId !== this.#pointerId) return;
    this.dragged = this.#at(event);
    if (this.dragged < 0) return;
    this.#pointerId = event.pointerId;
    event.stopImmediatePropagation();
    this.#element.setPointerCapture(event.pointerId);
  };

  readonly #move = (event: PointerEvent): void => {
    if (this.dragged < 0 || event.pointerId !== this.#pointerId) return;
    const { surface } = this.#curve;
    this.#raycaster.setFromCamera(this.#pointer(event), this.#camera);
    const [hit] = this.#raycaster.intersectObject(this.#object, false);
    if (!hit) return;
    try {
      const moved = this.#curve.movePoint(this.dragged, surface.pointAt(hit));
      moved.catch((error) => this.onError?.(error));
    } catch (error) {
      if (!(error instanceof KarcherError)) throw error;
      this.onError?.(error);
    }
  };

  readonly #release = ({ pointerId }: PointerEvent): void => {
    if (pointerId === this.#pointerId) this.dragged = -1;
  };

  /** The pointer in the camera's picture, -1 to 1. */
  #pointer({ clientX, clientY }: PointerEvent): Vector2 {
    const { left, top, width, height } = this.#element.getBoundingClientRect();
    return new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
  }

  /** The control point nearest to the pointer, among the visible ones within reach. */
  #at(event: PointerEvent): number {
    const { width, height } = this.#element.getBoundingClientRect();
    const pointer = this.#pointer(event);
    let [nearest, distance] = [-1, this.#reach];
    this.#curve.value.points.forEach((point, i) => {
      const seen = this.#curve.surface.position(point).applyMatrix4(this.#curve.matrixWorld);
      const place = seen.clone();
      seen.project(this.#camera);
      if (Math.abs(seen.z) > 1) return;
      const away = Math.hypot(
        ((seen.x - pointer.x) * width) / 2,
        ((seen.y - pointer.y) * height) / 2,
      );
      if (away > distance || this.#isHidden(place, seen)) return;
      [nearest, distance] = [i, away];
    });
    return nearest;
  }

  /**
   * Whether the surface hides a place of the scene. `seen` is the place in the camera's picture.
   */
  #isHidden(place: Vector3, seen: Vector3): boolean {
    this.#raycaster.setFromCamera(new Vector2(seen.x, seen.y), this.#camera);
    const [hit] = this.#raycaster.intersectObject(this.#object, false);
    const far = this.#raycaster.ray.origin.distanceTo(place);
    return hit !== undefined && hit.distance < (1 - nearer) * far;
  }
}
