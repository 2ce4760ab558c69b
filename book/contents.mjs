// The book's pages, in their order, under the headings of its side bar: files as they are. The front page is
// docs/index.md.
export const contents = {
  Start: [['docs/five-steps.md', 'Five steps']],
  Guides: [
    ['docs/javascript.md', 'In JavaScript'],
    ['docs/command-line.md', 'On the command line'],
    ['docs/cpp.md', 'In C++'],
    ['docs/page.md', 'On the page'],
    ['docs/errors.md', 'Errors'],
  ],
  Accuracy: [
    ['docs/methods.md', 'Methods and accuracy'],
    ['docs/steady-curves.md', 'Steady curves'],
    ['docs/convergence.md', 'Finer and finer meshes'],
    ['docs/gallery.md', 'Meshes that are hard'],
    ['docs/everywhere.md', 'Curves on any mesh'],
    ['docs/repairs.md', 'Repairs'],
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

/** The package's entries with types, by the names that they are imported by. */
export const entries = {
  'dist/index.d.ts': 'karcher',
  'dist/worker/index.d.ts': 'karcher/worker',
  'dist/three/index.d.ts': 'karcher/three',
  'dist/react/index.d.ts': 'karcher/react',
  'dist/formats/index.d.ts': 'karcher/formats',
  'dist/checkup/index.d.ts': 'karcher/checkup',
  'dist/worker/own.d.ts': 'karcher/own-worker',
  'dist/peers/index.d.ts': 'karcher/peers',
};
