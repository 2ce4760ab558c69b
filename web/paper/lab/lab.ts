import type { CurveSamples, LongWorkOptions } from 'karcher';
import {
  type DragMeasures,
  type Peers,
  type ReferenceSamples,
  Ruler,
  type RulerMeasures,
} from 'karcher/peers';
import { blobsOf } from '../../model/mesh_blobs';
import { madeKey } from '../../model/meshes';
import type { LineId, LineResult, MeshSpec, Panel, Vector } from '../figures/types';
import { type Carried, carry } from './carry';
import { type KnownCenter, lookForOthers } from './center';
import { dragLine, traceLine } from './lines';
import type { CarryJob, DrawnMesh, Placed } from './protocol';
import { Scene } from './scene';
import { planOf, referenceOf, type Task } from './task';

/** The largest number of meshes that the lab keeps, with the methods prepared for them. */
const mostScenes = 6;

/** Computes panels. All numbers of the figures come from here, in a page and in Node. */
export class Lab {
  readonly #scenes = new Map<string, Promise<Scene>>();

  constructor(readonly peers: Peers) {}

  /** A mesh for drawing. */
  async mesh(spec: MeshSpec): Promise<DrawnMesh> {
    const scene = await this.#scene(spec);
    return { info: scene.mesh.info, arrays: blobsOf(scene) };
  }

  /** The points of a panel's mesh that are nearest to points of space. */
  async place(spec: MeshSpec, points: readonly Vector[]): Promise<Placed> {
    const { mesh, nearest } = await this.#scene(spec);
    const placed = points.map((place) => nearest.point(place));
    return { points: placed, places: placed.map((point) => mesh.position(point)) };
  }

  async #task({ mesh, curve, samples }: Panel, points: readonly Vector[]): Promise<Task> {
    const scene = await this.#scene(mesh);
    return { peers: this.peers, scene, ...(await this.place(mesh, points)), curve, samples };
  }

  /**
   * Computes the lines of a panel, and passes each to `show` when it is ready. The measurements by
   * exact paths take longer and follow. Rejects with the signal's reason.
   */
  async trace(
    panel: Panel,
    points: readonly Vector[],
    lines: readonly LineId[],
    show: (line: LineResult) => void,
    measured: (id: LineId, ruler: RulerMeasures) => void,
    work: LongWorkOptions = {},
  ): Promise<void> {
    const task = await this.#task(panel, points);
    let reference: Promise<ReferenceSamples> | undefined;
    const getReference = () => {
      reference ??= referenceOf(task, work);
      return reference;
    };
    const traced: { id: LineId; samples: CurveSamples }[] = [];
    for (const id of lines) {
      work.signal?.throwIfAborted();
      const { line, samples } = await traceLine(task, id, getReference, work);
      show(line);
      if (samples) traced.push({ id, samples });
    }
    if (traced.length === 0) return;
    const ruler = new Ruler(task.scene.mesh, planOf(task));
    await ruler.compareWith(await getReference(), work);
    for (const { id, samples } of traced) measured(id, await ruler.measure(samples, work));
  }

  /**
   * Measures the behaviour of the methods' curves in a drag of a control point, and passes each
   * result to `measured`. Skips lines without a method and lines that fail. Rejects with the
   * signal's reason.
   */
  async drag(
    panel: Panel,
    points: readonly Vector[],
    lines: readonly LineId[],
    measured: (id: LineId, drag: DragMeasures) => void,
    work: LongWorkOptions = {},
  ): Promise<void> {
    const task = await this.#task(panel, points);
    for (const id of lines) {
      work.signal?.throwIfAborted();
      const drag = await dragLine(task, id, work);
      if (drag) measured(id, drag);
    }
  }

  /** Carries a drawing from one mesh to another by the weights of the drawing's points. */
  async carry({ source, target, middle, points }: CarryJob): Promise<Carried> {
    const [from, to] = [await this.#scene(source), await this.#scene(target)];
    return carry(from, to, middle, points);
  }

  /** The center of mass of these points and weights, and other minima of their energy. */
  async center(spec: MeshSpec, points: readonly Vector[], weights: readonly number[]) {
    return lookForOthers(await this.#scene(spec), points, weights) satisfies KnownCenter;
  }

  /** All lines of a panel at once. */
  async lines(panel: Panel, points: readonly Vector[]): Promise<LineResult[]> {
    const results: LineResult[] = [];
    await this.trace(
      panel,
      points,
      panel.lines,
      (line) => results.push(line),
      (id, ruler) => {
        results.find((line) => line.id === id)!.ruler = ruler;
      },
    );
    return results;
  }

  async #scene(spec: MeshSpec): Promise<Scene> {
    const key = madeKey(spec);
    const known = this.#scenes.get(key);
    const scene = known ?? Scene.make(this.peers, spec);
    // Moves the scene to the end, so that the first entry is always the one that is unused for
    // longest.
    this.#scenes.delete(key);
    this.#scenes.set(key, scene);
    if (!known) {
      scene.catch(() => this.#scenes.delete(key));
      await scene;
      await this.#forgetOldest();
    }
    return scene;
  }

  async #forgetOldest(): Promise<void> {
    while (this.#scenes.size > mostScenes) {
      const [key, oldest] = this.#scenes.entries().next().value!;
      this.#scenes.delete(key);
      await (await oldest).dispose();
    }
  }
}
