/** Drawings and curves as text for other programs. */
import type { CurvePoints } from 'karcher';
import type { View } from '../editor/engine/view';
import type { State } from '../editor/state/state';
import { isRound } from '../model/figure';
import { gathered } from '../model/gathered';
import { formatLink, type Link, parseLink } from '../model/link';
import { readDrawing, savedDrawing } from '../model/saved_drawing';
import type { TracedCurve } from '../model/traced';
import type { ViewPlace } from '../model/view_place';

const format = 'karcher-curve';
const version = 2;
/** The largest length of a file, in characters. Even the largest drawing is shorter. */
const longestFile = 256 * 1024 * 1024;

/** The shortest decimal for a Float32 coordinate. */
export function shortest(value: number): string {
  for (let digits = 6; digits < 9; digits++) {
    const text = value.toPrecision(digits);
    if (Math.fround(Number(text)) === Math.fround(value)) return `${Number(text)}`;
  }
  return `${Number(value.toPrecision(9))}`;
}

/**
 * The text of an OBJ file, in parts. Each polyline has its vertices and one line element. The
 * vertices of all marks and one point element follow. `marks` has x, y, z of each mark.
 */
export function* partsOfObj(
  polylines: readonly Float32Array[],
  marks: ArrayLike<number>,
  title: string,
): Generator<string> {
  yield `# ${title}\n`;
  let first = 1;
  const elements = polylines.map((places): ['l' | 'p', ArrayLike<number>] => ['l', places]);
  if (marks.length > 0) elements.push(['p', marks]);
  for (const [element, places] of elements) {
    const count = places.length / 3;
    for (let i = 0; i < count; i++) {
      yield `v ${[0, 1, 2].map((axis) => shortest(places[3 * i + axis]!)).join(' ')}\n`;
    }
    yield `${element} ${Array.from({ length: count }, (_, i) => first + i).join(' ')}\n`;
    first += count;
  }
}

/** A surface's file within a drawing's file. */
export interface FileInside {
  name: string;
  bytes: Blob;
}

/** The largest size in bytes of a file inside another; a larger one would make the page wait. */
export const longestInside = 16 * 1024 * 1024;
/**
 * The number of bytes that one step encodes, and the number of characters that one step decodes.
 * Base64 turns three bytes into four characters.
 */
const encodedAtOnce = 3 * 256 * 1024;
const decodedAtOnce = 4 * 256 * 1024;

/**
 * A complete description of a drawing: all of its objects, a link that opens it again with the same
 * view, and the engine's results for the edited object.
 */
export function jsonOf(state: State, view: View, place: ViewPlace | null): string {
  const { curve, isolines } = view;
  const { kind, settings, points, circle, circleForm } = state.figure;
  return `${JSON.stringify({
    format,
    version,
    link: formatLink(state.mesh, state.method, state.drawing, place),
    surface: state.mesh,
    method: state.method,
    drawing: savedDrawing(state.drawing),
    kind,
    ...(isRound(kind) ? { circle, ...circleForm, ...radiiOf(view) } : { settings, points }),
    quality: view.quality,
    center: view.center ?? undefined,
    length: (curve ?? isolines)?.length,
    samples: curve && samplesOf(curve),
    marks: curve?.marks ? marksOf(curve.marks) : undefined,
    lost: curve?.lost,
    polyline: curve && coordinatesOf(curve.polyline),
    lines: isolines?.lines.map(({ polyline, ...line }) => ({
      ...line,
      polyline: coordinatesOf(polyline),
    })),
  })}\n`;
}

/** A drawing's JSON with the file of its surface, as the parts of a text. */
export async function partsWithFile(json: string, { name, bytes }: FileInside): Promise<string[]> {
  const parts = [
    `${json.slice(0, json.lastIndexOf('}'))},"file":{"name":${JSON.stringify(name)},"base64":"`,
  ];
  for (let at = 0; at < bytes.size; at += encodedAtOnce) {
    parts.push(await base64Of(bytes.slice(at, at + encodedAtOnce)));
  }
  return [...parts, '"}}\n'];
}

function base64Of(bytes: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve((reader.result as string).replace(/^[^,]*,/, ''));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(bytes);
  });
}

function* bytesOf(base64: string): Generator<Uint8Array<ArrayBuffer>> {
  for (let at = 0; at < base64.length; at += decodedAtOnce) {
    yield Uint8Array.from(atob(base64.slice(at, at + decodedAtOnce)), (letter) =>
      letter.charCodeAt(0),
    );
  }
}

const radiiOf = ({ circle }: View) =>
  circle?.across
    ? { radii: [circle.radius, circle.across.radius], direction: circle.direction }
    : { radius: circle?.radius };

const coordinatesOf = (polyline: Float32Array) =>
  Array.from(polyline, (value) => Number(shortest(value)));

const three = (values: Float64Array, i: number) => Array.from(values.subarray(3 * i, 3 * i + 3));

function marksOf({ parameter, face, bary, position }: CurvePoints) {
  return Array.from(parameter, (at, i) => ({
    parameter: at,
    face: face[i]!,
    bary: three(bary, i),
    position: three(position, i),
  }));
}

function samplesOf({ samples, lost }: TracedCurve) {
  const { count, segment, t, face, bary, position } = samples;
  return Array.from({ length: count }, (_, i) => ({
    segment: segment[i]!,
    t: t[i]!,
    face: face[i]!,
    bary: three(bary, i),
    position: three(position, i),
    center: !lost.some((one) => one.segment === segment[i] && one.from <= t[i]! && t[i]! <= one.to),
  }));
}

/**
 * The link in a file by `jsonOf`, and the surface's file if it is inside. Throws for any other
 * file.
 */
export async function readJson(text: string): Promise<{ link: Link; file: File | null }> {
  const notOurs = 'the file is JSON, but no drawing that this page saved';
  if (text.length > longestFile) throw new Error('the file is too long for a drawing');
  let content: Partial<Record<'format' | 'version' | 'link' | 'drawing' | 'file', unknown>> | null;
  try {
    content = JSON.parse(text);
  } catch {
    throw new Error('the file is not JSON');
  }
  if (content?.format !== format || typeof content.link !== 'string') throw new Error(notOurs);
  const link = parseLink(content.link);
  if (!link) throw new Error(notOurs);
  // In files of version 1 the link holds everything.
  if (content.version === 1) return { link, file: null };
  if (content.version !== version) {
    throw new Error(`the file is a drawing in JSON of version ${content.version}, which is newer`);
  }
  const drawing = readDrawing(content.drawing);
  const file = content.file === undefined ? null : await fileInside(content.file);
  return { link: { ...link, drawing, unread: { points: 0, circles: 0 } }, file };
}

async function fileInside(value: unknown): Promise<File> {
  const { name, base64 } = (value ?? {}) as Partial<Record<'name' | 'base64', unknown>>;
  try {
    if (typeof name !== 'string' || typeof base64 !== 'string') throw new Error();
    return new File(await gathered(bytesOf(base64)), name);
  } catch {
    throw new Error('the file of the surface that is inside cannot be read');
  }
}
