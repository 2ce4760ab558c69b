import { Path } from './path.js';
import type { BridgedInterval, CurveSamples, CurveTimes, DrawnLeg, Status } from './types.js';

/** The data of a view: the engine's bytes (bindings/view.h), and the names of its statuses. */
export interface ViewData {
  bytes: Uint8Array;
  statusNames: readonly Status[];
}

/**
 * The data for drawing a curve. All arrays lie in one buffer, which the caller may keep or
 * transfer.
 */
export class CurveView {
  /** x, y, z of the path's points, in the requested 32 or 64 bits. */
  readonly polyline: Float32Array | Float64Array;
  /**
   * A number for each point of the path: 1 if the piece before it does not consist of centers of
   * mass, else 0.
   */
  readonly unconverged: Uint8Array;
  /** The length from the start to each point of the path. */
  readonly lengths: Float64Array;
  /** The length of the path, in units of the mesh. */
  readonly length: number;
  /** The samples, with the status of the search for each. */
  readonly samples: CurveSamples;
  /** The intervals in which the curve's points are not centers of mass, with the reasons. */
  readonly bridged: BridgedInterval[];
  /**
   * The drawn legs of the control polygon, if the curve uses them. To drag the curve's points, pass
   * these legs to `Curve.set` together with the moved points.
   */
  readonly drawnLegs: readonly DrawnLeg[];
  /** x, y, z of the points of the drawn legs, leg by leg. */
  readonly legs: readonly (Float32Array | Float64Array)[];
  /** The knots of a B-spline; empty for other kinds. */
  readonly knots: Float64Array;
  /** The number of segments. Parameters run from 0 to this number. */
  readonly segmentCount: number;
  /** The number of levels, even if `levels: 'auto'` chose it. */
  readonly levels: number;
  /** The durations of the steps of the last edit, or of the curve's creation. */
  readonly times: CurveTimes;
  readonly #data: ViewData;
  readonly #closed: boolean;
  readonly #points: { face: Int32Array; bary: Float64Array } | undefined;

  /** @internal Curves return views. */
  constructor(data: ViewData) {
    const { bytes, statusNames } = data;
    const read = new Reader(bytes);
    const [vertices, count, bridges, knots, stages, segments, length, closed, levels, ...has] =
      read.doubles(13);
    const [double, points, legs, legPoints] = has;
    const [polygon, fields, trace, bridge, join] = read.doubles(stages!);
    this.knots = read.doubles(knots!);
    const t = read.doubles(count!);
    const bary = read.doubles(3 * count!);
    const position = read.doubles(3 * count!);
    const [from, to] = [read.doubles(bridges!), read.doubles(bridges!)];
    this.lengths = read.doubles(vertices!);
    const legBary = read.doubles(3 * legPoints!);
    const pathBary = points ? read.doubles(3 * vertices!) : undefined;
    const places = (of: number) => (double ? read.doubles(3 * of) : read.floats(3 * of));
    this.polyline = places(vertices!);
    const legPlaces = places(legPoints!);
    const [segment, face] = [read.integers(count!), read.integers(count!)];
    const bridgedSegments = read.integers(bridges!);
    const counts = read.integers(legs!);
    const legFace = read.integers(legPoints!);
    let end = 0;
    const parts = Array.from(counts, (points) => {
      end += points;
      return [end - points, end] as const;
    });
    this.legs = parts.map(([from, to]) => legPlaces.subarray(3 * from, 3 * to));
    this.drawnLegs = parts.map(([from, to]) => ({
      face: legFace.subarray(from, to),
      bary: legBary.subarray(3 * from, 3 * to),
    }));
    if (pathBary) this.#points = { face: read.integers(vertices!), bary: pathBary };
    this.unconverged = read.bytes(vertices!);
    const status = Array.from(read.bytes(count!), (code) => statusNames[code]!);
    const reasons = read.bytes(bridges!);
    this.length = length!;
    this.segmentCount = segments!;
    this.levels = levels!;
    this.times = { polygon, fields, trace, bridge, join } as CurveTimes;
    this.samples = { count: count!, segment, t, face, bary, position, status };
    this.bridged = Array.from(bridgedSegments, (number, i) => ({
      segment: number,
      t0: from[i]!,
      t1: to[i]!,
      reason: statusNames[reasons[i]!]!,
    }));
    this.#closed = closed === 1;
    this.#data = data;
  }

  /** @internal The view's data. */
  data(): ViewData {
    return this.#data;
  }

  /**
   * @internal The path of the curve. The view must have 64-bit positions and the faces and weights
   *   of the path's points.
   */
  path(): Path {
    const position = this.polyline as Float64Array;
    const { length, lengths } = this;
    return new Path({ closed: this.#closed, length, lengths, position, ...this.#points! });
  }
}

/** A reader of consecutive arrays. Arrays of wide numbers come first, so that all are aligned. */
class Reader {
  readonly #bytes: Uint8Array;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  doubles = (count: number) => new Float64Array(this.#bytes.buffer, this.#next(8 * count), count);
  floats = (count: number) => new Float32Array(this.#bytes.buffer, this.#next(4 * count), count);
  integers = (count: number) => new Int32Array(this.#bytes.buffer, this.#next(4 * count), count);
  bytes = (count: number) => new Uint8Array(this.#bytes.buffer, this.#next(count), count);

  #next(bytes: number): number {
    const start = this.#bytes.byteOffset + this.#at;
    this.#at += bytes;
    return start;
  }
}
