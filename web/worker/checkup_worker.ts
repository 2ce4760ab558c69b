/** The worker that checks a surface, so that neither the page nor the engine waits. */
import type { LongWorkOptions, MeshInfo } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { serve } from 'karcher/own-worker';
import { type CheckedUp, type Kept, mostPlaces, outlineLength } from '../model/checked_up';
import { arraysOf, type MeshArrays, type MeshBlobs } from '../model/mesh_blobs';

serve({
  async checkUp(
    info: MeshInfo,
    blobs: MeshBlobs,
    kept: Kept,
    work: LongWorkOptions,
  ): Promise<CheckedUp> {
    const arrays = await arraysOf(blobs);
    const { positions, triangles } = arrays;
    const found = await checkUp(
      { info, positions: () => positions, triangles: () => triangles, kept: () => kept },
      work,
    );
    const { needles, caps } = found;
    const outlines = { needles: around(needles, arrays), caps: around(caps, arrays) };
    return { ...found, outlines };
  },
});

/** The outlines of the first `mostPlaces` of these triangles. */
function around(faces: Int32Array, { positions, triangles }: MeshArrays): Float32Array {
  const lines = new Float32Array(outlineLength * Math.min(mostPlaces, faces.length));
  for (let i = 0; i < lines.length; i++) {
    const face = faces[Math.floor(i / outlineLength)]!;
    const corner = Math.floor((i % outlineLength) / 3) % 3;
    lines[i] = positions[3 * triangles[3 * face + corner]! + (i % 3)]!;
  }
  return lines;
}
