import type { LongWorkOptions, Mesh } from 'karcher';
import { CurveMeter, type MethodOptions, type Peers, type PreparedMethod } from 'karcher/peers';
import { makeMesh } from '../../worker/made_mesh';
import type { MeshSpec } from '../figures/types';
import { NearestPoints } from './nearest';

/** A mesh with what was prepared on it, for figures whose points are dragged. */
export class Scene {
  readonly positions: Float64Array;
  readonly triangles: Int32Array;
  readonly nearest: NearestPoints;
  readonly meter: CurveMeter;
  readonly #peers: Peers;
  readonly #methods = new Map<string, Promise<PreparedMethod>>();

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

  /** A method on this mesh, prepared once. A failure is kept too, but for an aborted preparation. */
  method(options: MethodOptions, work: LongWorkOptions): Promise<PreparedMethod> {
    const key = JSON.stringify(options);
    const known = this.#methods.get(key);
    if (known) return known;
    const made = this.#peers.prepare(this.mesh, options, work);
    this.#methods.set(key, made);
    made.catch(() => {
      if (work.signal?.aborted) this.#methods.delete(key);
    });
    return made;
  }

  async dispose(): Promise<void> {
    for (const made of this.#methods.values()) {
      await made.then(
        (method) => method.dispose(),
        () => {},
      );
    }
    this.mesh.dispose();
  }
}
