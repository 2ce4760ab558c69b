import { KarcherError } from './errors.js';

/** What the engine's memory can grow to: 32 bits of addresses. */
const memoryBytes = 2 ** 32;
/** Smaller things are tried: what is in use is counted for larger ones only. */
const largeBytes = 2 ** 26;

/**
 * The least bytes that a mesh takes, with what is derived from it at once, beside its vertices: a GLB file of
 * 500 instances of a torus of 20,000 triangles grows the engine's memory to 419 a triangle, of which half
 * a vertex takes 36.
 */
const triangleBytes = 380;
/** The same of a vertex that no face uses: its place, three times while the mesh is made. */
const vertexBytes = 72;

/** The least bytes that a solver keeps of a vertex once it went over the whole surface, and its answer. */
const distanceBytes = 56;
/** The least bytes of the graph of the k-rings for a triangle: arcs along its edges, of 16 bytes. */
const graphBytes = 48;

const meshBytes = (vertices: number, triangles: number) =>
  triangleBytes * triangles + vertexBytes * vertices;

const counted = (count: number) => count.toLocaleString('en');
const inGigabytes = (bytes: number) => `${(bytes / 2 ** 30).toPrecision(3)} GB`;

/**
 * Throws `KarcherError` outOfMemory for what cannot fit, whatever is done: `what` is the beginning of
 * the sentence. `inUse` is asked for large things only.
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

/** The same for a mesh: "the glTF file makes" 12 triangles of 8 vertices. */
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

/** Throws as `checkFits` does for distances to all vertices, which are kept at once. */
export function checkDistancesFit(vertices: number, inUse: () => number): void {
  const what = `distances to ${counted(vertices)} vertices take`;
  checkFits(distanceBytes * vertices, what, inUse);
}

/** The same for a graph, by what every one has. */
export function checkGraphFits(triangles: number, rings: number, inUse: () => number): void {
  checkFits(graphBytes * triangles, graphTakes(triangles, rings), inUse);
}

/**
 * The same by a part that is made, `done` of 1, which takes so many bytes. The rest may be a fifth less
 * than it lets expect.
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
