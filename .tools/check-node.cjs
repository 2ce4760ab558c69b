// Stops with one sentence if Node is too old. Any Node can read this script.
var version = process.versions.node.split('.').map(Number);
if (version[0] < 20 || (version[0] === 20 && version[1] < 19)) {
  console.error(
    'Karcher needs Node 20.19 or newer, and this is Node ' +
      process.versions.node +
      ': see https://nodejs.org/en/download.',
  );
  process.exit(1);
}
