import { drawnAtOnce } from '../../model/arranging';
import { activeObject } from '../../model/drawing';
import type { ControlPoint, Vector } from '../../model/figure';
import { methodOptions } from '../../model/methods';
import { penOptions } from '../../model/pen';
import { anchorsOf, type StrokeSample } from '../../model/stroke';
import type { Pick } from '../../viewer/surface';
import type { SeenLine } from '../../viewer/vantage';
import type { Viewer } from '../../viewer/viewer';
import { drawnTangents } from '../engine/pen_drawing';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import type { Snapping } from './snapping';
import type { Hold, Place } from './stage_pointer';

/** The least distance of consecutive samples of a stroke, in CSS pixels. */
const leastStep = 1.5;
/**
 * A stroke is closed if its ends are at most `closesWithin` CSS pixels apart, and if it is more
 * than `leastLoop` times as long as this limit.
 */
const closesWithin = { mouse: 10, touch: 18 };
const leastLoop = 6;
/**
 * A stroke is fitted at most `mostRounds` times. Each further fit multiplies the tolerance by
 * `stricter` where the curve on the surface is too far from the stroke.
 */
const mostRounds = 4;
const stricter = 0.5;

/** A sample of a stroke: on the surface, in the scene and on the stage. */
interface Drawn extends Pick {
  x: number;
  y: number;
}

/**
 * Freehand drawing: a stroke on the surface becomes a curve of the pen, as one step of the history.
 */
export class FreehandGestures {
  /** The tolerance between curve and stroke, in CSS pixels. */
  tolerance = 3;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly snapping: Snapping,
    /** A listener for the sentence that says why a stroke ends early or makes no curve. */
    private readonly stopped: (why: string) => void,
  ) {}

  take(press: Place): Hold | null {
    if (this.editor.state.tool !== 'freehand' || press.shift) return null;
    const first = this.#at(press, this.snapping.pick(press));
    if (!first) return null;
    const stroke = [first];
    const show = () => {
      const line = stroke.flatMap(({ position }) => position.toArray());
      this.viewer.aids.showStroke(Float32Array.from(line));
    };
    return {
      drag: (_, way) => {
        for (const place of way) {
          const [last, next] = [
            stroke.at(-1)!,
            this.#at(place, this.viewer.pick(place.x, place.y)),
          ];
          if (next && Math.hypot(next.x - last.x, next.y - last.y) >= leastStep) stroke.push(next);
        }
        show();
      },
      release: async (place, dragged) => {
        const end = this.#at(place, this.snapping.pick(place));
        if (end && stroke.length > 1) stroke[stroke.length - 1] = end;
        if (dragged && stroke.length > 1) {
          await this.#draw(stroke, press.touch).catch(() =>
            this.stopped(
              'The stroke made no curve: there is no way along the surface between its ends.',
            ),
          );
        }
        this.viewer.aids.showStroke(null);
      },
      cancel: () => this.viewer.aids.showStroke(null),
    };
  }

  /** The surface's point under a place, and its position on the stage. */
  #at({ x, y }: Place, pick: Pick | null): Drawn | null {
    if (!pick) return null;
    const { left, top } = this.viewer.box;
    const { point, position } = pick;
    return { point, position, x: x - left, y: y - top };
  }

  async #draw(stroke: Drawn[], touch: boolean): Promise<void> {
    const { mesh } = this.editor.state;
    const whole = stroke.length;
    stroke.length = await this.#countOnOnePart(stroke);
    if (stroke.length < whole) {
      this.stopped(
        'The stroke ends where another part of the surface begins: a curve lies on one part.',
      );
    }
    if (stroke.length < 2) return;
    const [first, last] = [stroke[0]!, stroke.at(-1)!];
    const within = touch ? closesWithin.touch : closesWithin.mouse;
    const length = stroke.reduce((sum, { x, y }, i) => {
      const before = stroke[i - 1];
      return before ? sum + Math.hypot(x - before.x, y - before.y) : 0;
    }, 0);
    const gap = Math.hypot(last.x - first.x, last.y - first.y);
    const closed = gap <= within && length > leastLoop * within && stroke.length > 3;
    if (closed) stroke[stroke.length - 1] = first;
    const points = await this.#fitted(stroke, closed);
    const { editor } = this;
    if (editor.state.mesh !== mesh) return;
    // Another gesture may have begun during the fit. The command starts from the drawing without it.
    editor.interrupt();
    const command = drawnAtOnce(editor.state.drawing, points, closed);
    editor.perform(command, { selection: null, chosen: [] });
  }

  /**
   * The number of samples until a stroke leaves the component of the surface on which it begins.
   */
  async #countOnOnePart(stroke: readonly Drawn[]): Promise<number> {
    const { client } = this.session;
    if (!client || client.info.components < 2) return stroke.length;
    const isJoined = (place: number) =>
      client.mesh.shortestPath(stroke[0]!.point, stroke[place]!.point).then(
        () => true,
        () => false,
      );
    if (await isJoined(stroke.length - 1)) return stroke.length;
    let [joined, apart] = [0, stroke.length - 1];
    while (apart - joined > 1) {
      const middle = (joined + apart) >> 1;
      if (await isJoined(middle)) joined = middle;
      else apart = middle;
    }
    return apart;
  }

  /**
   * The anchors of a curve near a stroke. Repeats the fit until the drawn curve is within the
   * tolerance, but makes at most `mostRounds` fits.
   */
  async #fitted(stroke: readonly Drawn[], closed: boolean): Promise<ControlPoint[]> {
    const { viewer, tolerance } = this;
    const surface = viewer.surface!;
    let samples = stroke.map(({ point, position }): StrokeSample => {
      const pixel = viewer.reach(position, 1);
      const normal = surface.directionFromScene(surface.normal(point)) as Vector;
      const place = surface.fromScene(position);
      return { point, place, normal, tolerance: tolerance * pixel, pixel };
    });
    let points = anchorsOf(samples, closed);
    for (let round = 1; round < mostRounds; round++) {
      const line = await this.#seen(points, closed);
      const off = line && stroke.map((place) => distanceTo(line, place));
      if (!off?.some((distance) => distance > tolerance)) break;
      samples = samples.map((sample, i) => {
        const near = off.slice(Math.max(0, i - 3), i + 4);
        const isOff = near.some((distance) => distance > tolerance);
        return isOff ? { ...sample, tolerance: stricter * sample.tolerance } : sample;
      });
      points = anchorsOf(samples, closed);
    }
    return points;
  }

  /** The line of the anchors' curve on the stage; null if the anchors have no curve. */
  async #seen(points: readonly ControlPoint[], closed: boolean): Promise<SeenLine | null> {
    const { editor, session, viewer } = this;
    const { client } = session;
    if (!client) return null;
    const { figure } = activeObject(editor.state.drawing);
    const drawn = { ...figure, points, settings: { ...figure.settings, closed } };
    const options = methodOptions(editor.state.method);
    const value = penOptions(drawn, await drawnTangents(client, drawn), options);
    const curve = await client.curve(value).catch(() => null);
    return curve && viewer.seen(curve.polyline);
  }
}

/** The distance between a place and a line, both on the stage. */
function distanceTo(line: SeenLine, place: { x: number; y: number }): number {
  let least = Infinity;
  for (let i = 1; i < line.x.length; i++) {
    const [x, y] = [line.x[i - 1]!, line.y[i - 1]!];
    const [dx, dy] = [line.x[i]! - x, line.y[i]! - y];
    const along = ((place.x - x) * dx + (place.y - y) * dy) / (dx * dx + dy * dy || 1);
    const part = Math.min(1, Math.max(0, along));
    least = Math.min(least, Math.hypot(x + part * dx - place.x, y + part * dy - place.y));
  }
  return least;
}
