// The book's pages in their order, by file, under the headings of its side bar. The front page is
// docs/index.md; book/live.mjs writes docs/examples.md.
export const contents = {
  Start: [
    ['docs/five-steps.md', 'Five steps'],
    ['docs/which-call.md', 'Which call to take'],
    ['docs/examples.md', 'Examples, live'],
    ['docs/every-call.md', 'Every call, by example'],
    ['docs/faq.md', 'Questions'],
    ['docs/compare.md', 'How it compares'],
  ],
  Guides: [
    ['docs/javascript.md', 'In JavaScript'],
    ['docs/guides/three-js.md', 'With three.js'],
    ['docs/guides/react.md', 'With React'],
    ['docs/guides/node.md', 'In Node'],
    ['docs/guides/bundlers.md', 'Workers, bundlers, policies'],
    ['docs/guides/files.md', 'Files'],
    ['docs/command-line.md', 'On the command line'],
    ['docs/cpp.md', 'In C++'],
    ['docs/page.md', 'On the page'],
    ['docs/errors.md', 'Errors'],
  ],
  Algorithms: [
    ['docs/algorithms/means.md', 'Means'],
    ['docs/algorithms/fields.md', 'Near fields and log vectors'],
    ['docs/algorithms/distances.md', 'Exact and fast distances'],
    ['docs/algorithms/curves.md', 'Curves'],
    ['docs/steady-curves.md', 'Steady curves'],
    ['docs/algorithms/paths.md', 'Paths'],
    ['docs/algorithms/circles.md', 'Circles and ellipses'],
    ['docs/algorithms/regions.md', 'Regions, cuts and offsets'],
    ['docs/algorithms/editing.md', 'Editing on a surface'],
    ['docs/repairs.md', 'Repairs'],
  ],
  Accuracy: [
    ['docs/methods.md', 'Methods and accuracy'],
    ['docs/convergence.md', 'Finer and finer meshes'],
    ['docs/gallery.md', 'Meshes that are hard'],
    ['docs/everywhere.md', 'Curves on any mesh'],
    ['docs/repairs-study.md', 'Repairs, measured'],
  ],
  Project: [
    ['ARCHITECTURE.md', 'Architecture'],
    ['CONTRIBUTING.md', 'Contributing'],
    ['docs/coverage.md', 'Coverage'],
    ['SECURITY.md', 'Security'],
    ['CHANGELOG.md', 'Changelog'],
  ],
};

/** The pictures above pages (book/pictures.mjs), in words. */
export const drawn = {
  'docs/algorithms/means.md': [
    'means',
    'Four points on a bunny, and the shortest paths to their center of mass',
  ],
  'docs/algorithms/fields.md': [
    'fields',
    'Straightest paths of one length in all directions from a point',
  ],
  'docs/algorithms/distances.md': [
    'distances',
    'Exact distances from a point as colors, with their isolines',
  ],
  'docs/algorithms/curves.md': [
    'curves',
    'A B-spline and its control points joined by shortest paths',
  ],
  'docs/algorithms/paths.md': ['paths', 'Shortest paths from one point to eight others'],
  'docs/algorithms/circles.md': ['circles', 'Six circles about one point'],
  'docs/algorithms/regions.md': [
    'regions',
    'Two regions as colors, with offsets of their joint boundary inside and outside',
  ],
  'docs/algorithms/editing.md': ['editing', 'A curve before and after one of its points moved'],
};

/** The live example below a page (docs/book/live.mjs), by its name in examples/. */
export const live = {
  'docs/algorithms/means.md': 'mean',
  'docs/algorithms/fields.md': 'decal',
  'docs/algorithms/distances.md': 'distance_colors',
  'docs/algorithms/curves.md': 'drag_on_glb',
  'docs/algorithms/paths.md': 'cut_path',
  'docs/algorithms/regions.md': 'offset_seam',
  'docs/algorithms/editing.md': 'drag_on_glb',
};

/** The package's entries with types, and the names of their imports. */
export const entries = {
  'dist/index.d.ts': 'karcher',
  'dist/worker/index.d.ts': 'karcher/worker',
  'dist/three/index.d.ts': 'karcher/three',
  'dist/react/index.d.ts': 'karcher/react',
  'dist/formats/index.d.ts': 'karcher/formats',
  'dist/checkup/index.d.ts': 'karcher/checkup',
  'dist/statistics/index.d.ts': 'karcher/statistics',
  'dist/worker/own.d.ts': 'karcher/own-worker',
  'dist/peers/index.d.ts': 'karcher/peers',
};
