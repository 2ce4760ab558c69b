// The examples with their sources, each in a page of its own, which the book shows in a frame.
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { build } from 'vite';
import { inRoot } from '../../.tools/shell.mjs';
import { png } from './picture.mjs';

const source = inRoot('build/book/live');
const sourceOf = (name) => readFileSync(inRoot(`examples/${name}`), 'utf8');

/** The examples in the order of examples/README.md, with its words. */
function listed() {
  const rows = sourceOf('README.md').matchAll(/^\| \[([\w.]+)\]\(\1\) \| (.*) \|$/gm);
  return [...rows].map(([, file, words]) => ({ file, words, name: file.replace(/\.\w+$/, '') }));
}

const titleOf = (name) =>
  name
    .replaceAll('_', ' ')
    .replace(/^\w/, (one) => one.toUpperCase())
    .replace('glb', 'GLB')
    .replace('react', 'React');
const languageOf = (file) => (file.endsWith('.mjs') ? 'js' : file.replace(/.*\./, ''));

/** An example in a frame below its words. */
const framed = ({ words, name }) =>
  `${words[0].toUpperCase()}${words.slice(1)}.\n\n` +
  `<iframe src="../live/${name}.html" title="${words.replaceAll('"', '')}" loading="lazy"></iframe>\n\n`;

/** The example of this name below the text of a page, in Markdown. */
export function withLive(text, name) {
  const example = listed().find((one) => one.name === name);
  return `${text}\n## Live\n\n${framed(example)}[Its program](../examples.md) is among the examples.\n`;
}

/** The page of the examples, as Markdown. */
export function examplesPage() {
  const parts = listed().map(
    (example) =>
      `## ${titleOf(example.name)}\n\n${framed(example)}` +
      `\`\`\`${languageOf(example.file)}\n${sourceOf(example.file)}\`\`\`\n`,
  );
  return `# Examples, live\n\nOne idea each. The programs are those that run in the frames.\n\n${parts.join('\n')}`;
}

const policy = [
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'",
  "connect-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:",
].join('; ');

const page = ({ file, name, words }) => `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <meta http-equiv="Content-Security-Policy" content="${policy}">
    <meta name="viewport" content="width=device-width">
    <meta name="color-scheme" content="light dark">
    <title>${titleOf(name)}: ${words}</title>
    <link rel="stylesheet" href="./live.css">
  </head>
  <body>
    <div id="root"></div>
    ${file.endsWith('.mjs') ? '<script type="module" src="./printed.js"></script>' : ''}
    <script type="module" src="./${file}"></script>
  </body>
</html>
`;

const style = `body { margin: 0; height: 100vh; overflow: hidden auto; background: light-dark(#e9ecf1, #1b1e24); }
#root:not(:empty) { height: 100%; }
canvas { display: block; touch-action: none; }
pre { margin: 0; padding: 16px; white-space: pre-wrap; font: 14px/1.5 ui-monospace, monospace; }
`;

/** The output of an example for Node, shown in a page. */
const printed = `const shown = document.body.appendChild(document.createElement('pre'));
const textOf = (value) => (typeof value === 'string' ? value : JSON.stringify(value));
console.log = (...values) => shown.append(values.map(textOf).join(' ') + '\\n');
`;

/** Writes a bunny to drag over, as a GLB, and a picture to lay on a surface. */
async function writeFiles() {
  const { default: bunny } = await import('bunny');
  const { load } = await import('../../dist/index.js');
  const { meshFile } = await import('../../dist/formats/index.js');
  const karcher = await load();
  const from = bunny.positions.flat();
  const mesh = karcher.meshFromArrays(centered(from), bunny.cells.flat()).subdivide(1);
  const part = { positions: mesh.positions(), triangles: mesh.triangles() };
  writeFileSync(`${source}/public/model.glb`, withMaterial(meshFile(part, 'glb')));
  const size = 256;
  const decal = png(size, size, (x, y) => {
    const [u, v] = [x, y].map((one) => (2 * (one + 0.5)) / size - 1);
    const radius = Math.hypot(u, v);
    const petals = 0.6 + 0.25 * Math.cos(5 * Math.atan2(v, u));
    if (radius < 0.2) return [0.95, 0.7, 0.05, 1];
    return [0.14, 0.31, 0.85, radius < petals ? 1 : 0];
  });
  writeFileSync(`${source}/public/decal.png`, decal);
}

/** Adds a material to a GLB. The default is metal, which is black in empty surroundings. */
function withMaterial(glb) {
  const bytes = Buffer.from(glb);
  const length = bytes.readUInt32LE(12);
  const file = JSON.parse(bytes.toString('utf8', 20, 20 + length));
  const color = { baseColorFactor: [0.6, 0.63, 0.68, 1], metallicFactor: 0, roughnessFactor: 0.9 };
  file.materials = [{ pbrMetallicRoughness: color }];
  file.meshes[0].primitives[0].material = 0;
  const text = JSON.stringify(file);
  const json = Buffer.from(text.padEnd(4 * Math.ceil(text.length / 4)));
  const head = Buffer.from(bytes.subarray(0, 20));
  head.writeUInt32LE(bytes.length + json.length - length, 8);
  head.writeUInt32LE(json.length, 12);
  return Buffer.concat([head, json, bytes.subarray(20 + length)]);
}

/** Positions scaled to a height of 2 and centered about the origin. */
function centered(positions) {
  const ends = [0, 1, 2].map((axis) => {
    const values = positions.filter((_, at) => at % 3 === axis);
    return [Math.min(...values), Math.max(...values)];
  });
  const scale = 2 / (ends[1][1] - ends[1][0]);
  return positions.map((one, at) => scale * (one - (ends[at % 3][0] + ends[at % 3][1]) / 2));
}

/** Builds the pages in `live` of the book's folder. */
export async function buildLive(book) {
  rmSync(source, { recursive: true, force: true });
  mkdirSync(`${source}/public`, { recursive: true });
  for (const file of readdirSync(inRoot('examples'))) {
    cpSync(inRoot(`examples/${file}`), `${source}/${file}`);
  }
  writeFileSync(`${source}/live.css`, style);
  writeFileSync(`${source}/printed.js`, printed);
  await writeFiles();
  const examples = listed();
  for (const one of examples) writeFileSync(`${source}/${one.name}.html`, page(one));
  await build({
    ...{ configFile: false, root: source, base: './', logLevel: 'error' },
    worker: { format: 'es' },
    build: {
      ...{ outDir: `${book}/live`, emptyOutDir: true, target: 'es2022' },
      ...{ chunkSizeWarningLimit: 2000, modulePreload: { polyfill: false } },
      rolldownOptions: {
        input: examples.map(({ name }) => `${source}/${name}.html`),
        checks: { pluginTimings: false },
      },
    },
  });
}
