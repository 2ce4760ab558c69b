import bunny from 'bunny';
import type { Karcher, Mesh } from 'karcher';
import type { SampleSource } from './meshes';

export type Tell = (done: number, stage: string) => void;

/** Creates the mesh of a sample; the caller owns it. */
export function makeSample(karcher: Karcher, source: SampleSource, tell: Tell = () => {}): Mesh {
  if (source.kind === 'shape') return karcher.shape(source.name, source.triangles);
  const coarse = karcher.meshFromArrays(bunny.positions.flat(), bunny.cells.flat());
  if (source.levels === 0) return coarse;
  tell(0.4, 'Refining');
  const fine = coarse.subdivide(source.levels);
  coarse.dispose();
  return fine;
}
