// A curve with its own basis: trigonometric weights, which draw a closed loop through no point
// twice.
import { load } from 'karcher';

const karcher = await load();
const mesh = karcher.shape('sphere', 5000);
const points = [10, 60, 140, 90].map((vertex) => ({ vertex }));

/** A bump for each point, all of one shape; they sum to 1 for three points or more. */
const basis = (t, count) =>
  Array.from({ length: count }, (_, i) => {
    const angle = 2 * Math.PI * (t - i / count);
    return (1 + Math.cos(angle)) / count;
  });

const curve = mesh.curve({ kind: 'custom', points, basis, samples: 64 });
console.log(`a loop of length ${curve.length.toFixed(3)}, ${curve.bridged().length} bridges`);
