import { type Camera, Matrix4, Vector3 } from 'three';

export interface CurvePick {
  /** In the scene. */
  position: Vector3;
  /** From the place, in CSS pixels. */
  distance: number;
}

/**
 * The point of a polyline of the scene (x, y, z each) that is seen nearest to a place of the stage,
 * in CSS pixels from its corner; null where all of it is behind the camera.
 */
export function nearestOnScreen(
  line: Float32Array,
  camera: Camera,
  stage: { width: number; height: number },
  place: { x: number; y: number },
): CurvePick | null {
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const seen = (i: number, target: Vector3) => {
    target.fromArray(line, i).applyMatrix4(matrix);
    target.x = ((target.x + 1) / 2) * stage.width;
    target.y = ((1 - target.y) / 2) * stage.height;
    return target;
  };
  let best: { distance: number; at: number; part: number } | null = null;
  const [a, b] = [new Vector3(), new Vector3()];
  if (line.length >= 3) seen(0, b);
  for (let i = 3; i < line.length; i += 3) {
    a.copy(b);
    seen(i, b);
    if (a.z > 1 || b.z > 1) continue;
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const length = dx * dx + dy * dy;
    const along = ((place.x - a.x) * dx + (place.y - a.y) * dy) / (length || 1);
    const part = Math.min(1, Math.max(0, along));
    const distance = Math.hypot(a.x + part * dx - place.x, a.y + part * dy - place.y);
    if (!best || distance < best.distance) best = { distance, at: i, part };
  }
  if (!best) return null;
  const from = new Vector3().fromArray(line, best.at - 3);
  const to = new Vector3().fromArray(line, best.at);
  return { position: from.lerp(to, best.part), distance: best.distance };
}
