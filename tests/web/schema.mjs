// The published schema of saved drawings.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv/dist/2020.js';

const path = new URL('../../docs/drawing.schema.json', import.meta.url);
const ajv = new Ajv({ strict: true, strictTypes: false, strictRequired: false });
ajv.addSchema(JSON.parse(readFileSync(path, 'utf8')), 'file');

/** Whether a value is a saved file by the schema; the function's `errors` lists the faults. */
export const fitsFile = ajv.getSchema('file');
/** Whether a value is a drawing by the schema. */
export const fitsDrawing = ajv.compile({ $ref: 'file#/$defs/drawing' });
