import { batchMask, type Slices } from '../slices.js';

/** The faces that lie on an earlier face. */
export interface FacesOnOthers {
  /**
   * 1 for each face that lies on an earlier face with the same orientation; else 0. The engine
   * omits such faces.
   */
  same: Uint8Array;
  /**
   * Faces that lie on an earlier face with the opposite orientation. The engine omits such faces at
   * edges of more than two faces.
   */
  turned: number[];
}

/**
 * Finds the faces that lie on others. A face lies on another one if both have the same vertices.
 * All vertices are below `count`.
 */
export async function facesOnOthers(
  triangles: Int32Array,
  count: number,
  slices: Slices,
): Promise<FacesOnOthers> {
  const faces = triangles.length / 3;
  const lowest = (face: number) => {
    const at = 3 * face;
    return Math.min(triangles[at]!, triangles[at + 1]!, triangles[at + 2]!);
  };
  // Each vertex has a list of the faces whose lowest vertex it is. In `listed`, the lists follow
  // one another.
  const starts = new Int32Array(count + 1);
  for (let face = 0; face < faces; face++) starts[lowest(face)]!++;
  for (let i = 1; i <= count; i++) starts[i]! += starts[i - 1]!;
  const listed = new Int32Array(faces);
  for (let face = faces - 1; face >= 0; face--) listed[--starts[lowest(face)]!] = face;

  const found: FacesOnOthers = { same: new Uint8Array(faces), turned: [] };
  for (let i = 0; i < count; i++) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest(0.7);
    if (starts[i + 1]! < starts[i]! + 2) continue;
    /**
     * The first face for each pair of corners beside vertex `i`. A key names the pair, the lower
     * vertex first.
     */
    const first = new Map<string, { face: number; rises: boolean }>();
    for (const face of listed.subarray(starts[i], starts[i + 1])) {
      const k = [0, 1, 2].find((corner) => triangles[3 * face + corner] === i)!;
      const [p, q] = [triangles[3 * face + ((k + 1) % 3)]!, triangles[3 * face + ((k + 2) % 3)]!];
      if (p === i || q === i || p === q) continue;
      const key = `${Math.min(p, q)},${Math.max(p, q)}`;
      const before = first.get(key);
      if (before === undefined) first.set(key, { face, rises: p < q });
      else if (before.rises === p < q) found.same[face] = 1;
      else found.turned.push(face);
    }
  }
  return found;
}
