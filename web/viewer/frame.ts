import type { Vector } from '../model/figure';
import type { UpAxis } from '../model/meshes';

/**
 * The map from a surface's coordinates to the scene's. It takes the bounding box's center to 0, its
 * diagonal to length 2, and the upward axis to y.
 */
export interface Frame {
  center: Vector;
  scale: number;
  up: UpAxis;
}

/**
 * A turn: for each coordinate of the scene, the surface's coordinate that it shows, and the sign.
 */
type Turn = readonly (readonly [axis: number, sign: number])[];

const [x, y, z]: Turn[] = [
  [
    [1, -1],
    [0, 1],
    [2, 1],
  ],
  [
    [0, 1],
    [1, 1],
    [2, 1],
  ],
  [
    [0, 1],
    [2, 1],
    [1, -1],
  ],
] as const;

/**
 * The given turn, followed by half a turn about the scene's z axis, which exchanges up and down.
 */
const over = (turn: Turn): Turn => turn.map(([axis, sign], i) => [axis, i < 2 ? -sign : sign]);

/** The turn for each upward axis. Each turn is a rotation. */
const turns: Readonly<Record<UpAxis, Turn>> = {
  ...{ x: x!, y: y!, z: z! },
  ...{ '-x': over(x!), '-y': over(y!), '-z': over(z!) },
};

/** Converts a direction from the surface's coordinates to the scene's. */
export function directionInScene(up: UpAxis, direction: ArrayLike<number>): Vector {
  return turns[up].map(([axis, sign]) => sign * direction[axis]!) as Vector;
}

/** Converts a direction from the scene's coordinates to the surface's. */
export function directionFromScene(up: UpAxis, direction: ArrayLike<number>): Vector {
  const result: Vector = [0, 0, 0];
  for (const [i, [axis, sign]] of turns[up].entries()) result[axis] = sign * direction[i]!;
  return result;
}

/** Converts places (x, y, z of each) from the surface's coordinates to the scene's. */
export function placesInScene(
  { center, scale, up }: Frame,
  places: ArrayLike<number>,
): Float32Array {
  const result = new Float32Array(places.length);
  for (const [i, [axis, sign]] of turns[up].entries()) {
    const middle = center[axis]!;
    for (let at = 0; at < places.length; at += 3) {
      result[at + i] = sign * (places[at + axis]! - middle) * scale;
    }
  }
  return result;
}

/** Converts a place from the surface's coordinates to the scene's, in doubles. */
export function placeInScene({ center, scale, up }: Frame, place: Vector): Vector {
  return directionInScene(
    up,
    place.map((value, axis) => (value - center[axis]!) * scale),
  );
}

/** Converts a place from the scene's coordinates to the surface's. */
export function placeFromScene({ center, scale, up }: Frame, place: ArrayLike<number>): Vector {
  return directionFromScene(up, place).map(
    (value, axis) => value / scale + center[axis]!,
  ) as Vector;
}
