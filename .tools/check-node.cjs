// Stops with one sentence when Node is too old. Written so that any Node can read it.
var version = process.versions.node.split('.').map(Number);
if (version[0] < 20 || (version[0] === 20 && version[1] < 19)) {
  console.error(
    'Karcher needs Node 20.19 or newer, and this is Node ' +
      process.versions.node +
      ': see https://nodejs.org/en/download.',
  );
  process.exit(1);
}
