// Steps of a drag in WebAssembly, by the module that pages load: the twin of drag_bench.cpp.
//
//   node tests/bench/drag_bench.mjs MESH.obj PLAN LEVELS      (levels 'auto' or a number)
import { readFileSync } from 'node:fs';
import { load } from 'karcher';

const dragged = 1;
const [meshPath, planPath, levelsOrAuto] = process.argv.slice(2);
const levels = levelsOrAuto === 'auto' ? 'auto' : Number(levelsOrAuto);

/** The processor's milliseconds that the program has used. */
function processorMilliseconds() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

const karcher = await load();
const mesh = karcher.meshFromObj(readFileSync(meshPath));
const [count, ...lines] = readFileSync(planPath, 'utf8').trim().split('\n');
const places = lines.map((line) => {
  const [face, b1, b2] = line.split(' ').map(Number);
  return { face, bary: [1 - b1 - b2, b1, b2] };
});
const points = places.splice(0, Number(count));
const kind = points.length === 4 ? 'bezier' : 'bspline';
const curve = mesh.curve({ kind, points, samples: 128, levels });
curve.set({ ...curve.value(), levels: curve.levels });

let length = 0;

/** Drags there and back, until `ms` have passed; returns the time of each step. */
function drag(ms) {
  const steps = [];
  const dragThere = (place) => {
    const before = processorMilliseconds();
    curve.dragPoint(dragged, place);
    steps.push(processorMilliseconds() - before);
  };
  const start = processorMilliseconds();
  do {
    places.slice(1).forEach(dragThere);
    length = curve.path().length;
    places.slice(0, -1).reverse().forEach(dragThere);
  } while (processorMilliseconds() - start < ms);
  return steps;
}

const first = drag(1000).slice(0, 5);
const steps = drag(500);
console.log(
  JSON.stringify({ levels: curve.levels, stepMs: median(steps), firstMs: median(first), length }),
);
