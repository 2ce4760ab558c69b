// `npm start`: sets up, builds, serves the page and the book, and prints its address.
//
//   npm start -- [--port N] [--host]
import { parseArgs } from 'node:util';
import { buildBook, buildFacade, buildPage, buildWasm } from './build.mjs';
import { setUp } from './setup.mjs';
import { root } from './shell.mjs';

let options;
try {
  const known = { port: { type: 'string', default: '4173' }, host: { type: 'boolean' } };
  options = parseArgs({ options: known }).values;
  const isPort = /^\d{1,5}$/.test(options.port) && Number(options.port) <= 65535;
  if (!isPort) throw new Error(`'${options.port}' is not a port: a number from 0 to 65535 is.`);
} catch (error) {
  console.error(`${error.message}\nUsage: npm start -- [--port N] [--host]`);
  process.exit(1);
}

await setUp('build');
try {
  await buildWasm();
  await buildFacade();
  await buildPage();
  await buildBook();
} catch (error) {
  console.error(error.message);
  process.exit(1);
}

const { preview } = await import('vite');
let server;
try {
  server = await preview({
    configFile: `${root}vite.config.ts`,
    preview: { port: Number(options.port), host: options.host },
  });
} catch (error) {
  console.error(`The page cannot be served at port ${options.port}: ${error.message}`);
  process.exit(1);
}
console.log('\nKarcher is at (Ctrl-C ends it):');
for (const url of [...server.resolvedUrls.local, ...server.resolvedUrls.network]) {
  console.log(`  ${url}`);
}
