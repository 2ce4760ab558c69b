/**
 * Figure 2: the transport of a vector from a vertex v into a face t of its star, along the segment
 * to the face's centroid. At v, the segment has the direction theta_vt in a frame rescaled to a
 * full turn. At the centroid, theta_tv is the direction back to v. The vector's angle changes by
 * theta_tv + pi - theta_vt.
 */

type Plane = [number, number];

/**
 * The star of a vertex in space: `apex` is the vertex, and `ring` holds its neighbours,
 * counterclockwise.
 */
export interface Star {
  apex: [number, number, number];
  ring: readonly [number, number, number][];
}

/** A pyramid over an irregular hexagon. With height 0 it is flat. */
export function pyramid(height: number): Star {
  const radii = [1, 1.15, 0.9, 1.1, 0.95, 1.2];
  const degrees = [0, 52, 118, 176, 236, 305];
  return {
    apex: [0, 0, height],
    ring: radii.map((radius, i) => {
      const angle = (degrees[i]! * Math.PI) / 180;
      return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
    }),
  };
}

export interface Transport {
  /**
   * The vertices of the ring around v, after the star is laid flat with rescaled angles. The origin
   * is v.
   */
  ring: Plane[];
  /** The direction and distance of the face's centroid from v. */
  thetaVt: number;
  distance: number;
  /** The face in its own plane: v is the origin, the first edge the x axis. */
  face: [Plane, Plane, Plane];
  centroid: Plane;
  /** The angle, at the centroid, of the direction back to v. */
  thetaTv: number;
  /** The angle from the frame of v to the face's frame. */
  rotation: number;
  /** The angle that v lacks to a full turn. */
  defect: number;
}

/** The transport into face `t`, between the neighbours t and t + 1. */
export function transportInto({ apex, ring }: Star, t: number): Transport {
  const edges = ring.map((place) => place.map((x, c) => x - apex[c]!) as [number, number, number]);
  const lengths = edges.map((edge) => Math.hypot(...edge));
  const next = (i: number) => (i + 1) % edges.length;
  const angles = edges.map((edge, i) => {
    const other = edges[next(i)]!;
    const dot = edge.reduce((sum, x, c) => sum + x * other[c]!, 0);
    return Math.acos(dot / (lengths[i]! * lengths[next(i)]!));
  });
  const total = angles.reduce((a, b) => a + b);
  const scale = (2 * Math.PI) / total;
  const before = angles.map((_, i) => angles.slice(0, i).reduce((a, b) => a + b, 0));
  const polar = (radius: number, angle: number): Plane => [
    radius * Math.cos(angle),
    radius * Math.sin(angle),
  ];
  const face: [Plane, Plane, Plane] = [
    [0, 0],
    [lengths[t]!, 0],
    polar(lengths[next(t)]!, angles[t]!),
  ];
  const centroid: Plane = [(face[1][0] + face[2][0]) / 3, (face[1][1] + face[2][1]) / 3];
  const inFace = Math.atan2(centroid[1], centroid[0]);
  const thetaVt = scale * (before[t]! + inFace);
  const thetaTv = inFace + Math.PI;
  return {
    ring: lengths.map((radius, i) => polar(radius, scale * before[i]!)),
    thetaVt,
    distance: Math.hypot(...centroid),
    face,
    centroid,
    thetaTv,
    rotation: thetaTv + Math.PI - thetaVt,
    defect: 2 * Math.PI - total,
  };
}
