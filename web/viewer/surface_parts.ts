import { type BufferGeometry, Color, Group, Mesh, type ShaderMaterial } from 'three';
import type { SurfacePart } from '../model/parts';

/** The opacity of the color over a part. */
const opacity = 0.35;

interface Drawn {
  geometry: BufferGeometry;
  edges: Mesh;
  meshes: Mesh[];
  color: string | null;
}

/** The parts of a cut surface, in the scene. */
export class SurfaceParts {
  readonly object = new Group();
  /** The meshes, by the triangles of their parts. */
  readonly #drawn = new Map<Int32Array, Drawn>();
  #edges = false;

  /**
   * `clay` returns the mesh of a part, `edges` the mesh of its triangles' edges, and `paint` the
   * material of a color over the part.
   */
  constructor(
    private readonly clay: (geometry: BufferGeometry) => Mesh,
    private readonly edges: (geometry: BufferGeometry) => Mesh,
    private readonly paint: (color: Color, opacity: number) => ShaderMaterial,
  ) {}

  /** Whether the edges of the parts' triangles are visible. */
  set edgesShown(shown: boolean) {
    this.#edges = shown;
    for (const { edges } of this.#drawn.values()) edges.visible = shown;
  }

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
      const edges = before?.edges ?? this.edges(geometry);
      edges.visible = this.#edges;
      const meshes = [this.clay(geometry), edges];
      if (color) {
        const tint = new Mesh(geometry, this.paint(new Color(color), opacity));
        tint.renderOrder = 0.05;
        meshes.push(tint);
      }
      this.object.add(...meshes);
      this.#drawn.set(part.triangles, { geometry, edges, meshes, color });
    }
  }

  dispose(): void {
    this.show([], () => {
      throw new Error('nothing is shown any more');
    });
  }

  #remove(drawn: Drawn, forgets: boolean): void {
    this.object.remove(...drawn.meshes);
    // The clay and the edges' material stay, since all surfaces share them.
    for (const { material } of drawn.meshes.slice(2)) (material as ShaderMaterial).dispose();
    drawn.meshes.length = 0;
    if (forgets) drawn.geometry.dispose();
  }
}
