import type { SurfacePoint } from 'karcher';
import type { Viewer } from '../../viewer/viewer';
import { copiesOf, mirroredAcross, mirrorLine } from '../engine/mirroring';
import { movableObjects, replacing } from '../engine/moving';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import { isTorn } from '../engine/tearing';
import type { Editor } from '../state/editor';

/** Takes the tool that moves, turns and scales what is selected, or puts it away. */
export function toggleTransform(editor: Editor): void {
  editor.chooseSome();
  editor.setTool(editor.state.tool === 'transform' ? 'select' : 'transform');
}

/** Takes the tool that mirrors what is selected, or puts it away. */
export function toggleMirror(editor: Editor): void {
  editor.chooseSome();
  if (editor.state.tool === 'mirror') editor.rest();
  else if (editor.state.chosen.length > 0) editor.setTool('mirror');
}

/** Two clicks on the surface mirror what is selected in the geodesic through them. */
export class MirrorTool {
  /** Whether copies are mirrored, and what is selected stays. */
  copies = false;
  /** Called when the first point is placed, and when it is no more. */
  onChange: () => void = () => {};
  #first: SurfacePoint | null = null;
  readonly #aimed = new Newest<SurfacePoint>((point) => this.#showLine(point));

  /** `problem` is called with a sentence where there is no mirror image. */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly problem: (sentence: string) => void,
  ) {
    editor.subscribe(({ tool }) => {
      if (tool !== 'mirror') this.#drop();
    });
  }

  /** Whether the next click is the second one. */
  get hasFirst(): boolean {
    return this.#first !== null;
  }

  /** Shows the line through the first click and a point. */
  aim(point: SurfacePoint): void {
    if (this.#first) this.#aimed.push(point);
  }

  /** Resolves when all that a click leads to is done. */
  async click(point: SurfacePoint): Promise<void> {
    const first = this.#first;
    if (!first) {
      this.#first = point;
      this.onChange();
      return;
    }
    this.#drop();
    const { editor, session } = this;
    const { client } = session;
    const { drawing, chosen } = editor.state;
    const objects = movableObjects(drawing, chosen.length > 0 ? chosen : [drawing.active]);
    if (!client || objects.length === 0) return;
    try {
      const figures = await mirroredAcross(client, first, point, objects);
      if (editor.state.drawing !== drawing) return;
      const { surface } = this.viewer;
      if (!figures) this.problem('The mirror image would leave the surface.');
      else if (surface && (await isTorn(client, surface, objects, figures))) {
        this.problem(
          'The mirror image would be torn: the figure is too far from the line to have all of it beside it. Choose a line nearer to it.',
        );
      } else if (editor.state.drawing !== drawing) return;
      else if (this.copies) editor.addObjects(copiesOf(objects, figures));
      else editor.perform(replacing(objects, figures));
    } catch (error) {
      this.problem(`There is no mirror image: ${error instanceof Error ? error.message : error}.`);
    }
  }

  async #showLine(point: SurfacePoint): Promise<void> {
    const first = this.#first;
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!first || !client || !surface) return;
    const line = await mirrorLine(client, first, point).catch(() => null);
    if (!line || this.#first !== first) return;
    const places = line.flatMap((one) => surface.position(one).toArray());
    this.viewer.aids.showFrame([Float32Array.from(places)]);
  }

  #drop(): void {
    if (!this.#first) return;
    this.#first = null;
    this.#aimed.drop();
    this.viewer.aids.showFrame([]);
    this.onChange();
  }
}
