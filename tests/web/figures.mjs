// The page's modules in Node, and a figure for them.
import { pageModule } from './page_module.mjs';

/** A module of web/. */
export const load = (path) => pageModule(`../../web/${path}`);

/** A point of the surface: a face, and the weights of its second and third corner. */
export const point = (face, u = 0.25, v = 0.5) => ({ face, bary: [1 - u - v, u, v] });
export const settings = {
  closed: false,
  degree: 3,
  clamped: false,
  knots: null,
  parametrization: 'centripetal',
  samples: 128,
  tolerance: null,
  marks: 0,
  levels: 'auto',
};
/** A curve of four points, with the settings of a new one. */
export const figure = {
  kind: 'bspline',
  settings,
  points: [1, 2, 3, 4].map((face) => point(face)),
  circle: null,
  circleForm: { type: 'arcs', arcs: 'auto' },
};
export const circle = { center: point(5), rim: { radius: 0.5, direction: [0, 0, 1] } };
export const ellipse = { ...circle, across: { radius: 0.2 } };
