import type { FileInfo } from '../formats/index.js';
import { load } from '../load.js';
import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import type { Arguments } from './arguments.js';
import { curveOptions, readCurves } from './curve_arguments.js';
import { fieldOptions, type Option } from './options.js';
import { samplingOf, samplingOptions } from './sampling.js';

/** The options for the curves along which a command divides a surface. */
export const outlineOptions: readonly Option[] = [
  ...curveOptions.map((option) =>
    option.name === 'number' ? { ...option, default: 'all of them' } : option,
  ),
  ...samplingOptions,
  ...fieldOptions,
];

/** The mesh, its file's marks, and the curves on it as paths. */
export async function readOutlines(
  args: Arguments,
): Promise<{ mesh: Mesh; file: FileInfo; outlines: Path[] }> {
  const how = { ...samplingOf(args), ...args.field() };
  const records = await readCurves(args);
  const read = await args.meshFile();
  const { mesh, file } = await read(await load());
  const outlines = records.map((record) => {
    const curve = mesh.curve({ ...record, ...how });
    const path = curve.path();
    curve.dispose();
    return path;
  });
  return { mesh, file, outlines };
}
