/** The history of a drawing and the drawing itself, which a tab keeps through reloads. */
import { apply, type Command, invert } from './commands';
import type { Drawing } from './drawing';
import { type History, historyOf } from './history';
import { drawingVersion, readDrawing, savedDrawing } from './saved_drawing';

/**
 * The largest length of a history's text, in characters: half for the steps done, half for those
 * undone. A tab's storage holds a few million. Of a longer history only the newest steps stay.
 */
const mostLetters = 1_500_000;

/** The texts of commands, so that each command is converted only once. */
const texts = new WeakMap<Command, string>();

function textOf(command: Command): string {
  let text = texts.get(command);
  if (text === undefined) {
    text = JSON.stringify(command);
    texts.set(command, text);
  }
  return text;
}

/** The texts of the last commands of a list, with at most this many characters in total. */
function lastOf(commands: readonly Command[], letters: number): string[] {
  let left = letters;
  const kept: string[] = [];
  for (const command of commands.toReversed()) {
    const text = textOf(command);
    left -= text.length;
    if (left < 0) break;
    kept.push(text);
  }
  return kept.reverse();
}

/** A drawing and its history as text; the drawing's link identifies it. */
export function savedWork(link: string, drawing: Drawing, history: Readonly<History>): string {
  const [done, undone] = [history.done, history.undone].map((one) => lastOf(one, mostLetters / 2));
  const head = JSON.stringify({ link, drawing: savedDrawing(drawing), version: drawingVersion });
  return `${head.slice(0, -1)},"done":[${done!.join(',')}],"undone":[${undone!.join(',')}],"activated":${JSON.stringify(history.activated)}}`;
}

/** The text that stores only a drawing's link, which takes less room than the drawing's history. */
export const savedLink = (link: string) => JSON.stringify({ link, version: drawingVersion });

const canonical = (drawing: Drawing) =>
  JSON.stringify(readDrawing(JSON.parse(JSON.stringify(savedDrawing(drawing)))));

/** The link of the drawing in a saved text; null if the text has none. */
export function linkOfWork(text: string): string | null {
  try {
    const { link, version } = JSON.parse(text);
    return version === drawingVersion && typeof link === 'string' ? link : null;
  } catch {
    return null;
  }
}

/** Whether two drawings are equal, whatever the order of fields in their parts. */
export function sameDrawing(a: Drawing, b: Drawing): boolean {
  try {
    return canonical(a) === canonical(b);
  } catch {
    // A step leads to an invalid drawing.
    return false;
  }
}

/**
 * The drawing and history in a saved text; null if the text belongs to another link. The history is
 * empty if it does not lead to this drawing.
 */
export function readWork(
  text: string,
  link: string,
): { drawing: Drawing; history: History } | null {
  try {
    const work = JSON.parse(text);
    if (work.link !== link || work.version !== drawingVersion) return null;
    readDrawing(work.drawing);
    const { objects, active } = work.drawing as Drawing;
    const drawing = { objects, active };
    const { done, undone, activated = [] } = work;
    const history: History = { done, undone, activated };
    return { drawing, history: leadsTo(drawing, history) ? history : historyOf() };
  } catch {
    return null;
  }
}

function leadsTo(drawing: Drawing, { done, undone, activated }: History): boolean {
  try {
    const all = [...done, ...activated];
    const first = all.toReversed().map(invert).reduce(apply, drawing);
    const again = all.reduce(apply, first);
    canonical(first);
    const step = activated.toReversed().map(invert).reduce(apply, again);
    canonical(undone.toReversed().reduce(apply, step));
    return sameDrawing(again, drawing);
  } catch {
    return false;
  }
}
