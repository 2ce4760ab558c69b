// The published schema of saved drawings.
import { readFileSync } from 'node:fs';
import Ajv from 'ajv/dist/2020.js';

const path = new URL('../../docs/drawing.schema.json', import.meta.url);
const ajv = new Ajv({ strict: true, strictTypes: false, strictRequired: false });
const schema = JSON.parse(readFileSync(path, 'utf8'));
ajv.addSchema(schema, 'file');

/** Whether a value is a saved file by the schema; the function's `errors` lists the faults. */
export const fitsFile = ajv.getSchema('file');
/** Whether a value is a drawing by the schema. */
export const fitsDrawing = ajv.compile({ $ref: 'file#/$defs/drawing' });

/** The schema's part at a reference, such as `#/$defs/point`. */
export const drawingSchema = (reference) =>
  reference
    .split('/')
    .slice(1)
    .reduce((part, name) => part[name], schema);

const compiled = new Map();
/** Whether a value fits a schema that has no references. */
export function fitsPart(part, value) {
  const fits = compiled.get(part) ?? ajv.compile(part);
  compiled.set(part, fits);
  return fits(value);
}
