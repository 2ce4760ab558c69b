import { type BufferGeometry, Color, Group, Mesh, type ShaderMaterial } from 'three';
import type { SurfacePart } from '../model/parts';

/** The opacity of the color over a part. */
const opacity = 0.35;

interface Drawn {
  geometry: BufferGeometry;
  meshes: Mesh[];
  color: string | null;
}

/** The parts of a cut surface, in the scene. */
export class SurfaceParts {
  readonly object = new Group();
  /** The meshes, by the triangles of their parts. */
  readonly #drawn = new Map<Int32Array, Drawn>();

  /** `clay` makes the mesh of a part, and `paint` the material of a color over it. */
  constructor(
    private readonly clay: (geometry: BufferGeometry) => Mesh,
    private readonly paint: (color: Color, opacity: number) => ShaderMaterial,
  ) {}

  show(
    parts: readonly { part: SurfacePart; color: string | null }[],
    geometryOf: (part: SurfacePart) => BufferGeometry,
  ): void {
    for (const [key, drawn] of this.#drawn) {
      if (!parts.some(({ part, color }) => part.triangles === key && color === drawn.color)) {
        const isKept = parts.some(({ part }) => part.triangles === key);
        this.#remove(drawn, !isKept);
        if (!isKept) this.#drawn.delete(key);
      }
    }
    for (const { part, color } of parts) {
      const before = this.#drawn.get(part.triangles);
      if (before && before.meshes.length > 0) continue;
      const geometry = before?.geometry ?? geometryOf(part);
      const meshes = [this.clay(geometry)];
      if (color) {
        const tint = new Mesh(geometry, this.paint(new Color(color), opacity));
        tint.renderOrder = 0.05;
        meshes.push(tint);
      }
      this.object.add(...meshes);
      this.#drawn.set(part.triangles, { geometry, meshes, color });
    }
  }

  dispose(): void {
    this.show([], () => {
      throw new Error('nothing is shown any more');
    });
  }

  #remove(drawn: Drawn, forgets: boolean): void {
    this.object.remove(...drawn.meshes);
    // The clay stays, since all surfaces share it.
    for (const { material } of drawn.meshes.slice(1)) (material as ShaderMaterial).dispose();
    drawn.meshes.length = 0;
    if (forgets) drawn.geometry.dispose();
  }
}
