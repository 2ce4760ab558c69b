import { Color, Group, Vector3 } from 'three';
import { type Comb, combOf, usualCurvature } from '../model/comb';
import { litSurface, type ViewerColors } from './colors';
import { FatLine } from './fat_line';
import type { Layer } from './layer';
import type { Surface } from './surface';

/** The distance between teeth, in units of the scene; a surface's diagonal is 2. */
const spacing = 0.011;
const [fewestTeeth, mostTeeth] = [16, 600];
/** The length that most teeth do not exceed at first, in units of the scene. */
const usualLength = 0.12;
/** The fraction of the teeth that do not exceed `usualLength`. */
const usualShare = 0.9;

/** The facts that a comb shows, in the surface's coordinates. */
export interface CombFacts {
  /** The greatest absolute geodesic curvature; null without teeth. */
  greatest: number | null;
  /** The number of places without teeth. */
  corners: number;
}

const teethOn = (length: number) =>
  Math.round(Math.min(mostTeeth, Math.max(fewestTeeth, length / spacing)));

/**
 * Teeth on the outer side of a curve. Their lengths are in proportion to the curve's geodesic
 * curvature.
 */
export class CombLayer implements Layer {
  readonly object = new Group();
  readonly #teeth = new FatLine({ width: 1, hidden: 0.3 }, 3);
  readonly #tips = new FatLine({ width: 2, hidden: 0.3 }, 3);
  #combs: Comb[] = [];
  /** A tooth's length for each unit of curvature, in the scene. */
  #unit = 0;
  #factor = 1;

  constructor() {
    this.object.add(this.#teeth.object, this.#tips.object);
  }

  /**
   * Shows the combs of lines in the surface's coordinates. The curvature at a tooth follows from
   * the points at the distance `meanEdge` before and after it. With `keepScale`, for a drag, the
   * teeth keep their length for a unit of curvature if it is known. Otherwise the method fits this
   * length again.
   */
  show(
    surface: Surface | null,
    lines: readonly Float32Array[],
    meanEdge: number,
    { keepScale }: { keepScale: boolean },
  ): CombFacts {
    const scale = surface?.frame.scale ?? 1;
    this.#combs = surface ? this.#combsOf(surface, lines, meanEdge * scale) : [];
    if (!keepScale || this.#unit === 0) {
      const usual = usualCurvature(this.#combs, usualShare);
      this.#unit = usual > 0 ? usualLength / usual : 0;
    }
    this.#draw();
    const sizes = this.#combs.flatMap(({ teeth }) => teeth.map((one) => Math.abs(one.curvature)));
    return {
      greatest: sizes.length > 0 ? Math.max(...sizes) * scale : null,
      corners: this.#combs.reduce((sum, { corners }) => sum + corners, 0),
    };
  }

  /** The factor on the fitted length of the teeth. */
  set factor(factor: number) {
    this.#factor = factor;
    this.#draw();
  }

  follow(camera: Vector3): void {
    this.#teeth.follow(camera);
    this.#tips.follow(camera);
  }

  setColors(colors: ViewerColors): void {
    for (const line of [this.#teeth, this.#tips]) {
      line.setColor(new Color(colors.center), litSurface(colors));
    }
  }

  #combsOf(surface: Surface, lines: readonly Float32Array[], window: number): Comb[] {
    const normalAt = (place: readonly [number, number, number]) =>
      surface.normal(surface.nearest(new Vector3(...place))).toArray();
    return lines.map((line) => combOf(surface.toScene(line), normalAt, teethOn, window));
  }

  #draw(): void {
    const unit = this.#unit * this.#factor;
    const tips = this.#combs.map(({ teeth, closed }) => {
      const line = teeth.flatMap(({ foot, curvature, left }) =>
        foot.map((value, axis) => value - unit * curvature * left[axis]!),
      );
      return Float32Array.from(closed && line.length > 0 ? [...line, ...line.slice(0, 3)] : line);
    });
    this.#tips.set(tips);
    this.#teeth.set(
      this.#combs.flatMap(({ teeth }, comb) =>
        teeth.map(({ foot }, i) =>
          Float32Array.from([...foot, ...tips[comb]!.subarray(3 * i, 3 * i + 3)]),
        ),
      ),
    );
  }
}
