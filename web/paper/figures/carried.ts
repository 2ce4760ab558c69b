import { onTorus } from './surfaces';
import type { MeshSpec, Vector } from './types';

/** One of the two surfaces between which the figure carries a drawing, and its control points. */
export interface CarriedSide {
  title: string;
  mesh: MeshSpec;
  /** The places near which the three or four control points lie, in the order of the corners. */
  points: Vector[];
  /** The direction to the camera. */
  from: Vector;
}

export const carriedSides: { source: CarriedSide; target: CarriedSide } = {
  source: {
    title: 'Drawn on a torus',
    mesh: { kind: 'shape', name: 'torus', triangles: 5_000 },
    points: [onTorus(66, 100), onTorus(66, 20), onTorus(114, 20), onTorus(114, 100)],
    from: [0, 0.75, 1],
  },
  target: {
    title: 'Carried to a sphere',
    mesh: { kind: 'shape', name: 'sphere', triangles: 5_000 },
    points: [
      [0.5, -0.5, 0.71],
      [0.5, 0.55, 0.67],
      [-0.5, 0.5, 0.71],
      [-0.55, -0.45, 0.71],
    ],
    from: [0, 0.1, 1],
  },
};

/** The place of the drawing's middle on the source. */
export const carriedMiddle: Vector = onTorus(90, 60);

/** The drawing's size, in units of the source, and the number of points on a side of the star. */
export const carriedSize = 0.26;
const pointsASide = 10;

/** The drawing in the plane, in units of its size: a five-pointed star in a circle, both closed. */
export function drawingInPlane(): [number, number][][] {
  const tip = (k: number): [number, number] => {
    const radius = k % 2 === 0 ? 1 : 0.42;
    const angle = Math.PI / 2 + (k * Math.PI) / 5;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  const star: [number, number][] = [];
  for (let k = 0; k < 10; k++) {
    const [a, b] = [tip(k), tip(k + 1)];
    for (let i = 0; i < pointsASide; i++) {
      const s = i / pointsASide;
      star.push([a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]);
    }
  }
  star.push(tip(10));
  const circle = Array.from({ length: 6 * pointsASide + 1 }, (_, i): [number, number] => {
    const angle = (2 * Math.PI * i) / (6 * pointsASide);
    return [1.15 * Math.cos(angle), 1.15 * Math.sin(angle)];
  });
  return [star, circle];
}
