/**
 * Alignment: moves objects, or points of one object, onto a geodesic between two of these that lie
 * far apart.
 */
import type { SurfacePoint } from 'karcher';
import type { Command } from '../../model/commands';
import { type Drawing, type DrawnObject, objectOf } from '../../model/drawing';
import { isRound, plain, withLeg } from '../../model/figure';
import { withFittingLegs } from '../../model/legs';
import { placesOf } from '../../model/moving';
import { withSources } from '../../model/sources';
import type { Surface } from '../../viewer/surface';
import type { EngineClient } from '../../worker/client';
import type { Editor } from '../state/editor';
import { type State, selectedObjects } from '../state/state';
import { Move, movableObjects, replacing } from './moving';
import type { Session } from './session';

/**
 * The ways to align: `nearest` moves each part to the nearest place on the line, and `even` spaces
 * the parts evenly along the line.
 */
export type Alignment = 'nearest' | 'even';

/**
 * Objects that move as one: a single object, all objects of a group, all sources of a derived
 * object, or a point as its own figure.
 */
type Part = readonly DrawnObject[];

/** The smallest number of parts to align, since two parts always lie on a line. */
const fewest = 3;

/** The selected points or objects, if they can be aligned; otherwise an empty list. */
export function alignedParts(state: State): readonly Part[] {
  const { figure, selection, more, drawing } = state;
  const parts =
    typeof selection === 'number' && more.length > 0 && !isRound(figure.kind)
      ? pointParts(state)
      : wholes(drawing, selectedObjects(state));
  return parts.length < fewest ? [] : parts;
}

const selectedPoints = ({ selection, more }: State) =>
  [...more, selection as number].sort((a, b) => a - b);

function pointParts(state: State): Part[] {
  const { figure, drawing } = state;
  const [object] = movableObjects(drawing, [drawing.active]);
  if (!object) return [];
  return selectedPoints(state).map((index) => {
    const points = [withLeg(figure.points[index]!, null)];
    return [{ ...object, figure: { ...figure, points } }];
  });
}

/**
 * The movable ones of these objects and their sources, as parts. A group is one part, and so are
 * the sources of a derived object; parts that have an object in common are one.
 */
function wholes(drawing: Drawing, ids: readonly number[]): Part[] {
  const movable = movableObjects(drawing, ids);
  const keyOf = (id: number) => objectOf(drawing, id)?.group ?? id;
  return [...new Set(ids.map(keyOf))].reduce<Part[]>((parts, key) => {
    const own = withSources(
      drawing,
      ids.filter((id) => keyOf(id) === key),
    );
    const [common, others] = [true, false].map((is) =>
      parts.filter((part) => part.some(({ id }) => own.includes(id)) === is),
    );
    const all = new Set([...own, ...common!.flat().map(({ id }) => id)]);
    const part = movable.filter(({ id }) => all.has(id));
    return part.length > 0 ? [...others!, part] : parts;
  }, []);
}

/** Aligns the selection, as one step; throws a sentence if that is impossible. */
export async function align(
  editor: Editor,
  session: Session,
  surface: Surface,
  how: Alignment,
): Promise<void> {
  editor.interrupt();
  const { client } = session;
  const { state } = editor;
  const parts = alignedParts(state);
  if (!client || parts.length === 0) return;
  const places = await Promise.all(parts.map((part) => middleOf(client, part)));
  const goals = await goalsOf(client, surface, places, how);
  const moved = await Promise.all(
    parts.map(async (part, i) => {
      const goal = goals[i];
      if (!goal) return part.map(({ figure }) => figure);
      const objects = { drawing: state.drawing, objects: part };
      const move = await Move.of(session, surface, objects, places[i]!);
      const placed = await move.placed({ point: goal });
      if (typeof placed === 'string') throw new Error(placed);
      return placed.figures;
    }),
  );
  if (editor.state.drawing !== state.drawing) return;
  if (typeof state.selection === 'number' && state.more.length > 0) {
    const { figure } = state;
    const points = [...figure.points];
    for (const [i, index] of selectedPoints(state).entries()) {
      if (goals[i]) points[index] = moved[i]![0]!.points[0]!;
    }
    const to = withFittingLegs({ ...figure, points }, figure);
    const edit = { type: 'replace', from: figure, to } as const;
    editor.perform({ type: 'figure', id: state.drawing.active, edit });
    return;
  }
  const command: Command = replacing(parts.flat(), moved.flat());
  editor.perform(command);
}

/**
 * The center of mass of a part's places. Of a circle or an ellipse only the center counts, and of an
 * anchor only its own place.
 */
async function middleOf(client: EngineClient, part: Part): Promise<SurfacePoint> {
  const places = part.flatMap(({ figure }) => {
    const { kind, circle, points } = figure;
    if (isRound(kind) && circle) return [circle.center];
    return points.length === 1 ? points : placesOf({ ...figure, circle: null });
  });
  if (places.length === 1) return plain(places[0]!);
  const { point } = await client.mesh.centerOfMass(
    places.map(plain),
    places.map(() => 1 / places.length),
  );
  return plain(point);
}

/**
 * The target of each place on the line; null for the line's two ends, which stay. One end is the
 * place farthest from the first place, and the other end is the place farthest from that end.
 */
async function goalsOf(
  client: EngineClient,
  surface: Surface,
  places: readonly SurfacePoint[],
  how: Alignment,
): Promise<(SurfacePoint | null)[]> {
  const farthestFrom = async (index: number) => {
    const lengths = await distancesFrom(client, places[index]!, places);
    return lengths.indexOf(Math.max(...lengths));
  };
  const first = await farthestFrom(0);
  const last = await farthestFrom(first);
  const path = await client.mesh.shortestPath(plain(places[first]!), plain(places[last]!));
  if (!(path.length > 0)) throw new Error('All of it lies at one place.');
  const corners = path.points().map((point) => surface.position(point));
  const lengths = [0];
  for (const [i, corner] of corners.slice(1).entries()) {
    lengths.push(lengths[i]! + corner.distanceTo(corners[i]!));
  }
  const at = (part: number): SurfacePoint => {
    const length = part * lengths.at(-1)!;
    const after = Math.max(
      1,
      lengths.findIndex((one) => one >= length),
    );
    const [from, to] = [lengths[after - 1]!, lengths[after]!];
    const within = to > from ? (length - from) / (to - from) : 0;
    return surface.nearest(corners[after - 1]!.clone().lerp(corners[after]!, within));
  };
  const between = places.map((_, i) => i).filter((i) => i !== first && i !== last);
  const nearest = await Promise.all(
    between.map(async (i) => ({ i, part: await nearestPart(client, places[i]!, at) })),
  );
  if (how === 'even') nearest.sort((a, b) => a.part - b.part);
  const goals: (SurfacePoint | null)[] = places.map(() => null);
  for (const [rank, { i, part }] of nearest.entries()) {
    goals[i] = at(how === 'even' ? (rank + 1) / (places.length - 1) : part);
  }
  return goals;
}

/**
 * The search for the nearest point of a line takes `rounds` rounds, each of which compares `looks`
 * points. Each round after the first searches between the best point's neighbors.
 */
const looks = 33;
const rounds = 4;

/** The fraction of a line's length at which the line is nearest to a place. */
async function nearestPart(
  client: EngineClient,
  place: SurfacePoint,
  at: (part: number) => SurfacePoint,
): Promise<number> {
  let [from, to] = [0, 1];
  for (let round = 0; round < rounds; round++) {
    const parts = Array.from({ length: looks }, (_, i) => from + ((to - from) * i) / (looks - 1));
    const lengths = await distancesFrom(client, place, parts.map(at));
    const best = lengths.indexOf(Math.min(...lengths));
    [from, to] = [parts[Math.max(0, best - 1)]!, parts[Math.min(looks - 1, best + 1)]!];
  }
  return (from + to) / 2;
}

async function distancesFrom(
  client: EngineClient,
  from: SurfacePoint,
  places: readonly SurfacePoint[],
): Promise<number[]> {
  const { vectors } = await client.mesh.logMap(plain(from), places.map(plain));
  return places.map((_, i) => Math.hypot(...vectors.subarray(3 * i, 3 * i + 3)));
}
