// Runs several files of node:test in one process, where they share modules that are slow to load.
import { pathToFileURL } from 'node:url';

for (const file of process.argv.slice(2)) await import(pathToFileURL(file).href);
