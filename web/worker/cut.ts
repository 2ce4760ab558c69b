/** The cut surface, with its parts in the form that the page lists, draws and saves. */
import type { CutPart, LongWorkOptions, Mesh, SurfacePoint } from 'karcher';
import type { Shell, SurfacePart } from '../model/parts';

type Corners = readonly [number, number, number];

export async function cutParts(
  mesh: Mesh,
  outlines: SurfacePoint[][],
  thickness: number,
  { progress = () => {} }: LongWorkOptions = {},
): Promise<SurfacePart[]> {
  const { solidOf, thickened } = await import('karcher/checkup');
  const [positions, triangles] = [mesh.positions(), mesh.triangles()];
  const shell = (made: { positions: Float64Array; triangles: Int32Array }): Shell => {
    const { area, closed, volume } = solidOf(made);
    return { positions: made.positions, triangles: made.triangles, area, closed, volume };
  };
  const cut = mesh.cut(outlines, { progress: (done) => progress(done, 'Cutting') });
  const parts = cut.map((part, i): SurfacePart => {
    progress((i + 1) / (cut.length + 1), `Measuring part ${i + 1} of ${cut.length}`);
    const weights = weightsOf(part, positions, triangles);
    const thick = thickness > 0 ? thickened(part, thickness, { positions, triangles }) : null;
    return {
      ...{ ...shell(part), faces: part.faces, weights, point: pointOf(part, weights) },
      thick: thick && { ...shell(thick), most: thick.most },
    };
  });
  return parts.sort((a, b) => b.area - a.area);
}

/** The second and third weight of each corner of a part's triangles, in the triangle's face. */
function weightsOf(part: CutPart, positions: Float64Array, triangles: Int32Array): Float32Array {
  const weights = new Float32Array(2 * part.triangles.length);
  const at = (of: Float64Array, vertex: number): Corners =>
    of.subarray(3 * vertex, 3 * vertex + 3) as unknown as Corners;
  part.triangles.forEach((vertex, i) => {
    const face = 3 * part.faces[Math.floor(i / 3)]!;
    const [a, b, c] = [0, 1, 2].map((k) => at(positions, triangles[face + k]!));
    const [u, v, d] = [b!, c!, at(part.positions, vertex)].map((to) =>
      to.map((x, k) => x - a![k]!),
    );
    const dot = (p: number[], q: number[]) => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
    const [uu, uv, vv, du, dv] = [dot(u!, u!), dot(u!, v!), dot(v!, v!), dot(d!, u!), dot(d!, v!)];
    const area = uu * vv - uv * uv;
    weights[2 * i] = area > 0 ? (vv * du - uv * dv) / area : 0;
    weights[2 * i + 1] = area > 0 ? (uu * dv - uv * du) / area : 0;
  });
  return weights;
}

/** The middle of the triangle that covers the largest part of its face. */
function pointOf({ faces }: CutPart, weights: Float32Array): SurfacePoint {
  let best = 0;
  let most = -1;
  for (let i = 0; i < faces.length; i++) {
    const [ax, ay, bx, by, cx, cy] = weights.subarray(6 * i, 6 * i + 6);
    const share = Math.abs((bx! - ax!) * (cy! - ay!) - (by! - ay!) * (cx! - ax!));
    if (share > most) [best, most] = [i, share];
  }
  const own = weights.subarray(6 * best, 6 * best + 6);
  const mean = (k: number) => Number(((own[k]! + own[k + 2]! + own[k + 4]!) / 3).toFixed(9));
  const [u, v] = [Math.max(0, mean(0)), Math.max(0, mean(1))];
  return { face: faces[best]!, bary: [Math.max(0, 1 - u - v), u, v] };
}
