import { KarcherError } from './errors.js';

/** The largest size of the engine's memory, which has 32-bit addresses. */
const memoryBytes = 2 ** 32;
/** Only data with more bytes than this needs a check of the free memory. */
const largeBytes = 2 ** 26;

/**
 * The least number of bytes for a triangle, without its vertices, but with the data that are
 * derived from it at once. Measured on a GLB file with 500 instances of a torus of 20,000
 * triangles: the engine's memory grows to 419 bytes for each triangle and half a vertex, of which
 * the half vertex takes 36.
 */
const triangleBytes = 380;
/**
 * The least number of bytes for a vertex that no face uses: three copies of its place during the
 * creation of the mesh.
 */
const vertexBytes = 72;

/**
 * The least number of bytes that a solver and its result keep for each vertex, after the solver has
 * covered the whole surface.
 */
const distanceBytes = 56;
/**
 * The least number of bytes that a graph of k-rings takes for each triangle: arcs of 16 bytes along
 * the triangle's edges.
 */
const graphBytes = 48;

const meshBytes = (vertices: number, triangles: number) =>
  triangleBytes * triangles + vertexBytes * vertices;

const counted = (count: number) => count.toLocaleString('en');
const inGigabytes = (bytes: number) => `${(bytes / 2 ** 30).toPrecision(3)} GB`;

/**
 * Throws `KarcherError` outOfMemory for data that certainly cannot fit. `what` is the beginning of
 * the error's sentence. Only large data needs `inUse`.
 */
export function checkFits(bytes: number, what: string, inUse: () => number = () => 0): void {
  if (bytes <= largeBytes) return;
  const free = memoryBytes - inUse();
  if (bytes <= free) return;
  throw new KarcherError(
    'outOfMemory',
    `${what} at least ${inGigabytes(bytes)} of memory, and the engine has ${inGigabytes(Math.max(0, free))} left`,
  );
}

/**
 * Throws what `checkFits` throws, for a mesh. `what` is the beginning of the sentence: "the glTF
 * file makes".
 */
export function checkMeshFits(
  vertices: number,
  triangles: number,
  what: string,
  inUse?: () => number,
): void {
  checkFits(
    meshBytes(vertices, triangles),
    `${what} ${counted(triangles)} triangles${vertices > 0 ? ` of ${counted(vertices)} vertices` : ''}, which take`,
    inUse,
  );
}

/** Throws what `checkFits` throws, for distances to all vertices. */
export function checkDistancesFit(vertices: number, inUse: () => number): void {
  const what = `distances to ${counted(vertices)} vertices take`;
  checkFits(distanceBytes * vertices, what, inUse);
}

/** Throws what `checkFits` throws, for a lower bound on the size of a graph. */
export function checkGraphFits(triangles: number, rings: number, inUse: () => number): void {
  checkFits(graphBytes * triangles, graphTakes(triangles, rings), inUse);
}

/**
 * Throws what `checkFits` throws, for the rest of a graph. The completed fraction `done` takes
 * `bytes`. The check takes a fifth off the extrapolated size of the rest, since the rest may be
 * smaller.
 */
export function checkGraphGoesOn(
  triangles: number,
  rings: number,
  made: { bytes: number; done: number },
  inUse: () => number,
): void {
  const rest = 0.8 * made.bytes * (1 / made.done - 1);
  checkFits(rest, `${graphTakes(triangles, rings)} for what is left of it`, inUse);
}

const graphTakes = (triangles: number, rings: number) =>
  `a graph of ${rings} ${rings === 1 ? 'ring' : 'rings'} on ${counted(triangles)} triangles takes`;
