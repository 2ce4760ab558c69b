import type { SurfacePoint } from 'karcher';
import { type Plane, planeThrough, type Symmetry } from '../../model/symmetry';
import { dotAt } from '../../viewer/object_lines';
import { sectionOf } from '../../viewer/section';
import type { Surface } from '../../viewer/surface';
import type { Viewer } from '../../viewer/viewer';
import {
  copiesOf,
  type ImagesOf,
  mirroredAcross,
  mirroredDerived,
  mirrorLine,
} from '../engine/mirroring';
import { copiedObjects, keptFigures, movableObjects, replacing } from '../engine/moving';
import { Newest } from '../engine/newest';
import { figuresInPlane, planeOfSymmetry } from '../engine/plane_mirror';
import type { Session } from '../engine/session';
import { isTorn } from '../engine/tearing';
import type { Editor } from '../state/editor';

/** Starts or ends the tool that moves, turns and scales the selection. */
export function toggleTransform(editor: Editor): void {
  editor.chooseSome();
  editor.setTool(editor.state.tool === 'transform' ? 'select' : 'transform');
}

/** Starts or ends the tool that mirrors the selection. */
export function toggleMirror(editor: Editor): void {
  editor.chooseSome();
  if (editor.state.tool === 'mirror') editor.rest();
  else if (editor.state.chosen.length > 0) editor.setTool('mirror');
}

/**
 * The mirror: the geodesic through two clicks, the plane through three, or the surface's plane of
 * symmetry.
 */
export type MirrorIn = 'line' | 'plane' | 'symmetry';

/** The purpose of the next click, by the number of earlier clicks. */
const hints: Record<MirrorIn, readonly string[]> = {
  line: [
    'Click the surface where the mirror line goes through',
    'Click a second point of the mirror line',
  ],
  plane: [
    'Click three points that the mirror plane goes through',
    'Click a second point of the mirror plane',
    'Click a third point of the mirror plane',
  ],
  symmetry: ['Click the surface to mirror across the line: both sides of it are alike'],
};

const torn =
  'The mirror image would be torn: the figure is too far from the line to have all of it beside it. Choose a line nearer to it.';

/** Mirrors the selection by clicks on the surface, in the geodesic or the plane through them. */
export class MirrorTool {
  /** Whether the originals stay, and the mirror images are copies. */
  copies = false;
  /** A listener for changes of the hint. */
  onChange: () => void = () => {};
  #in: MirrorIn = 'line';
  #clicked: SurfacePoint[] = [];
  /** The surface's plane of symmetry; null if it has none, undefined while the search goes on. */
  #symmetry: Symmetry | null | undefined;
  /** The surface to which `#symmetry` belongs. */
  #of: Surface | null = null;
  readonly #aimed = new Newest<SurfacePoint>((point) => this.#showLine(point));

  /** `problem` receives a sentence if no mirror image exists. */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly problem: (sentence: string) => void,
  ) {
    let tool = editor.state.tool;
    editor.subscribe((state) => {
      if (state.tool === tool) return;
      tool = state.tool;
      this.#begin();
    });
  }

  /** Chooses the kind of mirror. */
  set in(what: MirrorIn) {
    this.#in = what;
    this.#begin();
  }

  /** The purpose of the next click, in words. */
  get hint(): string {
    if (this.#in === 'symmetry' && this.#symmetry === undefined) {
      return 'Looking for the plane in which the surface is symmetric';
    }
    if (this.#in === 'symmetry' && this.#symmetry === null) {
      return 'The surface has no plane of symmetry: choose a plane of three clicks';
    }
    return hints[this.#in][this.#clicked.length]!;
  }

  /**
   * The difference between the surface's sides, relative to its diagonal; null unless the mirror is
   * the surface's plane of symmetry.
   */
  get apart(): number | null {
    return this.#in === 'symmetry' ? (this.#symmetry?.apart ?? null) : null;
  }

  /** Shows the line or the plane through the clicks and a point, if the point completes it. */
  aim(point: SurfacePoint): void {
    if (this.#clicked.length === hints[this.#in].length - 1) this.#aimed.push(point);
  }

  /** Resolves when all effects of the click are done. */
  async click(point: SurfacePoint): Promise<void> {
    if (this.#in === 'symmetry') return this.mirrorInSymmetry();
    const clicked = [...this.#clicked, point];
    if (clicked.length < hints[this.#in].length) {
      this.#clicked = clicked;
      this.#showClicks();
      this.onChange();
      return;
    }
    this.#begin();
    const [first, second, third] = clicked as [SurfacePoint, SurfacePoint, SurfacePoint];
    if (this.#in === 'line') {
      const { client } = this.session;
      return this.#mirror((objects) => mirroredAcross(client!, first, second, objects));
    }
    const { surface } = this.viewer;
    const plane = surface && planeOf(surface, [first, second, third]);
    if (!plane) this.problem('A plane goes through three points that do not lie on a line.');
    else await this.#mirror((objects) => figuresInPlane(surface, plane, objects));
  }

  /**
   * Mirrors the selection in the surface's plane of symmetry, if it has one. For a new surface,
   * begins the search for the plane instead.
   */
  async mirrorInSymmetry(): Promise<void> {
    const { surface } = this.viewer;
    const symmetry = this.#symmetry;
    if (surface !== this.#of) this.#begin();
    else if (surface && symmetry) {
      await this.#mirror((objects) => figuresInPlane(surface, symmetry.plane, objects));
    }
  }

  async #mirror(imagesOf: ImagesOf): Promise<void> {
    const { editor, session } = this;
    const { client } = session;
    const { drawing, chosen } = editor.state;
    const ids = chosen.length > 0 ? chosen : [drawing.active];
    const objects = movableObjects(drawing, ids);
    const kept = copiesOf(objects, keptFigures(session, objects));
    if (!client || objects.length === 0) return;
    try {
      const figures = await imagesOf(kept);
      if (editor.state.drawing !== drawing) return;
      const { surface } = this.viewer;
      if (!figures) this.problem('The mirror image would leave the surface.');
      else if (surface && (await isTorn(client, surface, objects, figures))) this.problem(torn);
      else if (editor.state.drawing !== drawing) return;
      else {
        const all = copiedObjects(drawing, ids);
        const images = await Promise.all(
          all.map(
            (object) =>
              figures[objects.indexOf(object)] ??
              mirroredDerived(session, drawing, object, imagesOf),
          ),
        );
        if (editor.state.drawing !== drawing) return;
        const own = all.map(({ id }) => id);
        if (this.copies) editor.objects.add(copiesOf(all, images), own);
        else editor.perform(replacing(all, images));
      }
    } catch (error) {
      this.problem(`There is no mirror image: ${error instanceof Error ? error.message : error}.`);
    }
  }

  #showClicks(): void {
    const { surface } = this.viewer;
    if (surface) {
      this.viewer.aids.showFrame(this.#clicked.map((point) => dotAt(surface.position(point))));
    }
  }

  async #showLine(point: SurfacePoint): Promise<void> {
    const clicked = this.#clicked;
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!client || !surface) return;
    if (this.#in === 'plane') {
      const plane = planeOf(surface, [...clicked, point]);
      this.viewer.aids.showFrame(plane ? sectionOf(surface, plane) : []);
    }
    if (this.#in !== 'line') return;
    const line = await mirrorLine(client, clicked[0]!, point).catch(() => null);
    if (!line || this.#clicked !== clicked) return;
    const places = line.flatMap((one) => surface.position(one).toArray());
    this.viewer.aids.showFrame([Float32Array.from(places)]);
  }

  /** Forgets the clicks. If the mirror is the surface's plane of symmetry, looks for this plane. */
  #begin(): void {
    const isShown = this.#clicked.length > 0 || this.#symmetry;
    this.#clicked = [];
    this.#aimed.drop();
    this.#symmetry = undefined;
    if (isShown) this.viewer.aids.showFrame([]);
    if (this.editor.state.tool !== 'mirror') return;
    if (this.#in === 'symmetry') void this.#findSymmetry();
    this.onChange();
  }

  async #findSymmetry(): Promise<void> {
    const { surface } = this.viewer;
    if (!surface) return;
    const symmetry = await planeOfSymmetry(surface, surface.directionInScene(this.viewer.right));
    const { tool } = this.editor.state;
    if (tool !== 'mirror' || this.#in !== 'symmetry' || this.viewer.surface !== surface) return;
    [this.#symmetry, this.#of] = [symmetry, surface];
    this.viewer.aids.showFrame(symmetry ? sectionOf(surface, symmetry.plane) : []);
    this.onChange();
  }
}

function planeOf(surface: Surface, points: readonly SurfacePoint[]): Plane | null {
  if (points.length < 3) return null;
  const [a, b, c] = points.map((point) => surface.position(point).toArray());
  return planeThrough(a!, b!, c!);
}
