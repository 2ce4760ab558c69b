import type { SurfacePoint } from 'karcher';
import { emptyDocument } from '../../editor/document';
import { formatLink } from '../../editor/link';
import type { CurveSpec, MeshSpec } from '../figures/types';
import { editorKey } from '../lab/meshes';

/** Where the editor shows the same curve; null where it has no such mesh or curve. */
export function editorLink(
  mesh: MeshSpec,
  curve: CurveSpec,
  points: readonly SurfacePoint[],
): string | null {
  const key = editorKey(mesh);
  if (!key) return null;
  if (curve.kind === 'circle') {
    const [center, rim] = points;
    const circle = { center: center!, rim: rim! };
    return `./index.html#${formatLink(key, 'karcher', { ...emptyDocument, kind: 'circle', circle })}`;
  }
  if (curve.kind === 'center') {
    const weighted = points.map((point, i) => ({ ...point, weight: curve.weights[i]! }));
    const document = { ...emptyDocument, kind: 'center' as const, points: weighted };
    return `./index.html#${formatLink(key, 'karcher', document)}`;
  }
  if (curve.kind !== 'bspline' && curve.kind !== 'bezier') return null;
  const document = { ...emptyDocument, kind: curve.kind, points: [...points] };
  return `./index.html#${formatLink(key, 'karcher', document)}`;
}
