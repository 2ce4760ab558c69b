/**
 * How deep each vertex of a surface lies in a hollow, from -1 on a ridge to 1, 0 where it is flat: what
 * its neighbors' places have along its normal, at first of the nearest ones, and then of ever wider
 * neighborhoods, whose share is as large. So small relief is seen as large one is.
 */
export function hollowsOf(
  positions: Float32Array,
  normals: Float32Array,
  triangles: Uint32Array,
): Float32Array {
  const count = positions.length / 3;
  const hollows = new Float32Array(count);
  const degrees = new Float32Array(count);
  for (let i = 0; i < triangles.length; i++) degrees[triangles[i]!]! += 2;
  let smooth = positions;
  for (let width = 0; width < widths; width++) {
    for (let round = 0; round < (width === 0 ? 1 : 4 ** width - 4 ** (width - 1)); round++) {
      smooth = averaged(smooth, triangles, degrees);
    }
    // An edge is half as long as its ends' neighborhoods are wide, and each round widens them as a walk.
    const reach = 2 ** width * meanEdge(positions, triangles);
    for (let i = 0; i < count; i++) {
      let rise = 0;
      for (let axis = 3 * i; axis < 3 * i + 3; axis++) {
        rise += (smooth[axis]! - positions[axis]!) * normals[axis]!;
      }
      hollows[i]! += Math.tanh((steepness * rise) / reach) / widths;
    }
  }
  return hollows;
}

/** Neighborhoods of 1, 4 and 16 rounds of averages. */
const widths = 3;
/** A rise of an eighth of a neighborhood's width is dark. */
const steepness = 8;

/** Each vertex in the middle of its neighbors; each triangle tells of two of them. */
function averaged(
  positions: Float32Array,
  triangles: Uint32Array,
  degrees: Float32Array,
): Float32Array {
  const sums = new Float32Array(positions.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i]!, 3 * triangles[i + 1]!, 3 * triangles[i + 2]!];
    for (let axis = 0; axis < 3; axis++) {
      const [x, y, z] = [positions[a + axis]!, positions[b + axis]!, positions[c + axis]!];
      sums[a + axis]! += y + z;
      sums[b + axis]! += x + z;
      sums[c + axis]! += x + y;
    }
  }
  for (let i = 0; i < sums.length; i++) {
    const degree = degrees[Math.floor(i / 3)]!;
    // Half way: a vertex and its neighbors would change places else.
    sums[i] = degree > 0 ? (positions[i]! + sums[i]! / degree) / 2 : positions[i]!;
  }
  return sums;
}

function meanEdge(positions: Float32Array, triangles: Uint32Array): number {
  let sum = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b] = [3 * triangles[i]!, 3 * triangles[i + 1]!];
    sum += Math.hypot(
      positions[a]! - positions[b]!,
      positions[a + 1]! - positions[b + 1]!,
      positions[a + 2]! - positions[b + 2]!,
    );
  }
  return (3 * sum) / triangles.length || 1;
}
