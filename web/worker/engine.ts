/**
 * The worker that runs the engine: `karcher/worker-thread` with additional calls for the page's
 * meshes.
 */
import {
  type CutPart,
  type DistanceOptions,
  type Karcher,
  KarcherError,
  type LongWorkOptions,
  load,
  type Mesh,
  type PointLike,
  type SurfacePoint,
} from 'karcher';
import type { FileInfo } from 'karcher/formats';
import { serve } from 'karcher/own-worker';
import { arraysOf, blobsOf, type MeshBlobs } from '../model/mesh_blobs';
import type { MeshSource, UpAxis } from '../model/meshes';
import { curvesFile, partFile } from './curves_file';
import { cutParts } from './cut';
import { combined, offsetOf } from './derived';
import { tracedDistances } from './distances';
import { boxAround } from './extent';
import { centroidOf, fillOf } from './fills';
import { framedAt, putDown } from './framed';
import { patternOf } from './patterns';
import { inPieces } from './pieces';

interface Loaded {
  mesh: Mesh;
  arrays: MeshBlobs;
  /** The properties of the surface's file; null for other surfaces. */
  file: FileInfo | null;
  /** The axis that seems to point up. */
  up: UpAxis;
}

/** The page's names for the stages of reading a file. */
const fileStages: Record<string, string> = {
  cutting: 'Cutting polygons',
  making: 'Making the surface',
};

const takenFrom = (mesh: Mesh) => ({
  positions: mesh.positions(),
  triangles: mesh.triangles(),
});

/** The calls of this worker; all others are calls of the mesh. */
const calls = {
  async load(source: MeshSource, { progress = () => {} }: LongWorkOptions): Promise<Loaded> {
    progress(0, 'Starting the engine');
    const karcher = await load();
    progress(0.2, 'Reading the surface');
    if (source.kind !== 'file') {
      const mesh = await meshOf(karcher, source, progress);
      return { mesh, arrays: blobsOf(takenFrom(mesh)), file: null, up: 'y' };
    }
    const { guessUp, meshFromFile } = await import('karcher/formats');
    const { content, name, parts, weld } = source;
    const bytes = new Uint8Array(await content.arrayBuffer());
    const read = (wanted: readonly number[] | null) =>
      meshFromFile(karcher, bytes, {
        ...{ name, ...(wanted && { parts: wanted }), ...(weld !== null && { weld }) },
        progress: (done, stage) =>
          progress(0.2 + 0.6 * done, fileStages[stage] ?? 'Reading the file'),
      });
    const whole = await read(parts).catch((error: unknown) => {
      // The key may name a connected piece of a file without parts, so the whole file is read.
      if (parts && error instanceof KarcherError && error.code === 'badArgument') return read(null);
      throw error;
    });
    const { mesh, file } = await inPieces(karcher, whole, parts);
    const arrays = takenFrom(mesh);
    const up = guessUp(arrays.positions, arrays.triangles, file.format);
    return { mesh, arrays: blobsOf(arrays), file, up };
  },
  distances: (mesh: Mesh, from: PointLike, options: DistanceOptions) =>
    tracedDistances(mesh, from, options),
  fill: fillOf,
  centroid: centroidOf,
  pattern: patternOf,
  offset: offsetOf,
  combined,
  cut: cutParts,
  curvesFile,
  partFile,
  async pointsOnPart(mesh: Mesh, part: CutPart, points: SurfacePoint[]) {
    const { pointsOnPart } = await import('karcher/formats');
    return pointsOnPart(part, takenFrom(mesh), points);
  },
  framedAt,
  putDown,
  boxAround,
};

serve(calls);

async function meshOf(
  karcher: Karcher,
  source: Exclude<MeshSource, { kind: 'file' }>,
  progress: NonNullable<LongWorkOptions['progress']>,
): Promise<Mesh> {
  switch (source.kind) {
    case 'arrays': {
      const { positions, triangles } = await arraysOf(source.arrays);
      return karcher.meshFromArrays(positions, triangles);
    }
    case 'bunny':
    case 'shape': {
      const { makeSample } = await import('../model/sample_mesh');
      return makeSample(karcher, source, progress);
    }
    default: {
      const { makeMesh } = await import('../model/made_mesh');
      return makeMesh(karcher, source, progress);
    }
  }
}
