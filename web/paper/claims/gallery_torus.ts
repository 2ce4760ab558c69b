import type { Mesh, SurfacePoint } from 'karcher';
import type { Peers } from 'karcher/peers';
import { galleryFigure } from '../figures/splines';
import { NearestPoints } from '../lab/nearest';

/** The gallery's torus with this many triangles, and its control points. */
export function galleryTorus(
  peers: Peers,
  triangles: number,
): { mesh: Mesh; points: SurfacePoint[] } {
  const mesh = peers.karcher.shape('torus', triangles);
  const nearest = new NearestPoints(mesh.positions(), mesh.triangles());
  return { mesh, points: galleryFigure.points.torus!.map((place) => nearest.point(place)) };
}
