import { loadPeers } from 'karcher/peers';
import { grid } from './meshes.mjs';

/** The number of squares on each side. */
export const side = 12;

/** The module of the peers with a plane of squares, and five control points on it. */
export async function peersOnPlane() {
  const peers = await loadPeers();
  const plane = peers.karcher.meshFromObj(grid(side));
  return { peers, plane, points: [53, 58, 84, 98, 110].map((vertex) => ({ vertex })) };
}
