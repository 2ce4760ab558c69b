import type { LongWorkOptions, Mesh } from 'karcher';
import {
  CurveMeter,
  type MethodOptions,
  type Peers,
  type PreparedCurves,
  warm,
} from 'karcher/peers';
import { makeMesh } from '../../model/made_mesh';
import type { MeshSpec } from '../figures/types';
import { NearestPoints } from './nearest';

interface OwnMethod {
  mesh: Mesh;
  method: PreparedCurves;
}

/** A mesh and the methods prepared for it, for figures whose points the reader can drag. */
export class Scene {
  readonly positions: Float64Array;
  readonly triangles: Int32Array;
  readonly nearest: NearestPoints;
  readonly meter: CurveMeter;
  readonly #peers: Peers;
  readonly #methods = new Map<string, Promise<OwnMethod>>();

  private constructor(
    peers: Peers,
    readonly spec: MeshSpec,
    readonly mesh: Mesh,
  ) {
    this.#peers = peers;
    this.positions = mesh.positions();
    this.triangles = mesh.triangles();
    this.nearest = new NearestPoints(this.positions, this.triangles);
    this.meter = new CurveMeter(mesh);
  }

  static async make(peers: Peers, spec: MeshSpec): Promise<Scene> {
    return new Scene(peers, spec, await makeMesh(peers.karcher, spec));
  }

  get flat(): boolean {
    return this.spec.kind === 'plane';
  }

  /**
   * Prepares a method once, on its own copy of the mesh. There the method cannot reuse the work of
   * other methods, so that its measured time is complete. The scene also keeps a failure, but not
   * an abort.
   */
  async method(options: MethodOptions, work: LongWorkOptions): Promise<PreparedCurves> {
    const key = JSON.stringify(options);
    const known = this.#methods.get(key);
    if (known) return (await known).method;
    const made = this.#prepare(options, work);
    this.#methods.set(key, made);
    made.catch(() => {
      if (work.signal?.aborted) this.#methods.delete(key);
    });
    return (await made).method;
  }

  async #prepare(options: MethodOptions, work: LongWorkOptions): Promise<OwnMethod> {
    await warm(this.#peers, options);
    const mesh = this.#peers.karcher.meshFromArrays(this.positions, this.triangles);
    try {
      return { mesh, method: await this.#peers.prepare(mesh, options, work) };
    } catch (error) {
      mesh.dispose();
      throw error;
    }
  }

  async dispose(): Promise<void> {
    for (const made of this.#methods.values()) {
      await made.then(
        ({ mesh, method }) => {
          method.dispose();
          mesh.dispose();
        },
        () => {},
      );
    }
    this.mesh.dispose();
  }
}
