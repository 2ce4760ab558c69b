/** A drag that bends a segment of the pen: the curve follows the pointer at a fixed parameter. */
import type { CurveOptions, FieldOptions, SurfacePoint } from 'karcher';
import type { FigureCommand } from '../../model/commands';
import { type Figure, plain, type Vector } from '../../model/figure';
import { type OnSegment, penOptions } from '../../model/pen';
import type { DrawnTangents } from '../../model/pen_legs';
import { bendingParts, withBentSegment } from '../../model/pen_shape';
import type { Surface } from '../../viewer/surface';
import type { EngineClient, LooseCurve } from '../../worker/client';
import { directionOf } from './circle_drawing';
import { drawnTangents } from './pen_drawing';

/**
 * The corrections end when the bent curve is this near to the pointer, relative to the surface's
 * diagonal.
 */
const nearEnough = 1e-7;

const sum = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

export class Bend {
  /**
   * The correction of the vector to the pointer, found in earlier steps. It compensates for the
   * surface's curvature.
   */
  #correction: Vector = [0, 0, 0];

  private constructor(
    private readonly client: EngineClient,
    private readonly surface: Pick<Surface, 'carry'>,
    private readonly figure: Figure,
    private readonly drawn: readonly DrawnTangents[],
    private readonly options: FieldOptions,
    private readonly at: OnSegment,
    private readonly curve: LooseCurve,
    private readonly place: SurfacePoint,
  ) {}

  /**
   * Takes hold of a figure's segment at a parameter. `drawn` contains the places of the handles.
   * The caller must call `end`.
   */
  static async of(
    client: EngineClient,
    surface: Pick<Surface, 'carry'>,
    figure: Figure,
    drawn: readonly DrawnTangents[],
    options: FieldOptions,
    at: OnSegment,
  ): Promise<Bend> {
    const curve = await client.looseCurve(await segmentValue(client, figure, options, at));
    try {
      const { point } = await curve.pointAt(at.t);
      return new Bend(client, surface, figure, drawn, options, at, curve, plain(point));
    } catch (error) {
      curve.dispose();
      throw error;
    }
  }

  end(): void {
    this.curve.dispose();
  }

  /**
   * The command that bends the segment so that it passes through a point. On a plane the first step
   * is exact. Elsewhere each correction adds the vector from the curve to the point.
   */
  async through(point: SurfacePoint, corrections: number): Promise<FigureCommand> {
    const { client, surface, figure, place } = this;
    const enough = nearEnough * client.info.diagonal;
    const wanted = await this.#way(place, point);
    let best: { figure: Figure; off: number; correction: Vector } | null = null;
    for (let step = 0; step <= corrections; step++) {
      const correction = this.#correction;
      const bent = this.#bent(sum(wanted, correction));
      const value = await segmentValue(client, bent, this.options, this.at);
      const there = plain((await this.curve.placeOn(value, this.at.t)).point);
      const off = await this.#way(there, point);
      const length = Math.hypot(...off);
      if (best && length >= best.off) {
        this.#correction = best.correction;
        break;
      }
      best = { figure: bent, off: length, correction };
      this.#correction = sum(correction, surface.carry(there, place)(off));
      if (length <= enough) break;
    }
    return { type: 'replace', from: figure, to: best!.figure };
  }

  /** The anchors whose handles move. */
  get anchors(): number[] {
    return [this.at.from, this.at.to];
  }

  #bent(by: Vector): Figure {
    const { surface, figure, at, place, drawn } = this;
    const parts = bendingParts(at.t);
    const vectors = [at.from, at.to].map((index, i) => {
      const carried = surface.carry(place, figure.points[index]!)(by);
      return carried.map((value) => parts[i]! * value) as Vector;
    });
    return withBentSegment(figure, drawn, at, vectors as [Vector, Vector]);
  }

  /** The log vector of the point `to` at the point `from`. */
  async #way(from: SurfacePoint, to: SurfacePoint): Promise<Vector> {
    const path = await this.client.mesh.shortestPath(from, plain(to));
    if (!(path.length > 0)) return [0, 0, 0];
    return directionOf(path.polyline({ bits: 64 })).map((value) => path.length * value) as Vector;
  }
}

/**
 * The value of a curve that consists of one segment of a figure, with the given number of samples.
 */
export async function segmentValue(
  client: EngineClient,
  figure: Figure,
  options: FieldOptions,
  { from, to }: Pick<OnSegment, 'from' | 'to'>,
  samples = 2,
): Promise<CurveOptions> {
  const points = [figure.points[from]!, figure.points[to]!];
  const settings = { ...figure.settings, closed: false, samples, tolerance: null };
  const segment: Figure = { ...figure, points, settings };
  return penOptions(segment, await drawnTangents(client, segment), options);
}
