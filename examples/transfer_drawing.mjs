// A drawing transferred to another mesh of the same shape: control points move to the nearest
// points there, and the engine traces the curves again.
import { load } from 'karcher';

const karcher = await load();
const coarse = karcher.shape('torus', 2000);
const fine = karcher.shape('torus', 20_000);

const drawing = [
  { kind: 'bspline', points: [10, 200, 420, 630].map((vertex) => ({ vertex })) },
  { kind: 'catmullrom', points: [50, 260, 480].map((vertex) => ({ vertex })), closed: true },
];

/**
 * The same curve's options on another mesh, and the distances of its points from their old places.
 */
function carried({ points, ...options }, from, to) {
  const found = points.map((point) => to.nearestPoint(from.position(point)));
  const away = found.map(({ position }, i) => {
    const before = from.position(points[i]);
    return Math.hypot(...position.map((x, k) => x - before[k]));
  });
  return {
    options: { ...options, points: found.map(({ point }) => point) },
    away: Math.max(...away),
  };
}

for (const figure of drawing) {
  const { options, away } = carried(figure, coarse, fine);
  const [before, after] = [coarse.curve(figure), fine.curve(options)];
  console.log(
    `${figure.kind}: points within ${away.toFixed(4)}, length ${before.length.toFixed(4)} and ${after.length.toFixed(4)}`,
  );
}
