import type { MeshInfo } from 'karcher';
import type { Distances, ShownDistances } from './editor/engine/distances';
import type { Session } from './editor/engine/session';
import type { View } from './editor/engine/view';
import type { Editor } from './editor/state/editor';
import type { State } from './editor/state/state';
import type { Vector } from './model/figure';
import { arraysOf, type MeshArrays } from './model/mesh_blobs';
import type { Viewer } from './viewer/viewer';

/** Copies of the page's contents, for tests and for the browser's console. */
export interface Inspection {
  /** Whether the engine has answered the newest state, including its control polygon. */
  readonly settled: boolean;
  /** Whether the engine is working, even if the drawing changes only after this work. */
  readonly busy: boolean;
  /** The revision of the visible state. */
  readonly shown: number;
  /** The number of triangles of the surface; 0 without one. */
  readonly triangles: number;
  /** Whether the newest view is visible, and no motion is under way. */
  readonly still: boolean;
  state(): State;
  view(): View;
  distances(): ShownDistances | null;
  /**
   * The place in the window that shows a place in the surface's coordinates; null if it is hidden.
   */
  seen(position: Vector): { x: number; y: number } | null;
  /** The surface's face at a place of the window, and the size of a pixel there; null beside the surface. */
  under(x: number, y: number): { face: number; place: Vector; pixel: number } | null;
  /** The objects with a halo, by their ids. */
  marked(): readonly number[];
  info(): MeshInfo | null;
  mesh(): Promise<({ info: MeshInfo } & MeshArrays) | null>;
}

declare global {
  interface Window {
    readonly karcherPage: Inspection;
  }
}

export function exposeState(
  editor: Editor,
  session: Session,
  viewer: Viewer,
  distances: Distances,
): void {
  const inspection: Inspection = {
    get settled() {
      return session.settled && session.view.revision === editor.state.revision;
    },
    get busy() {
      return session.client?.busy ?? false;
    },
    get shown() {
      return session.view.revision;
    },
    get triangles() {
      return session.client?.info.triangles ?? 0;
    },
    get still() {
      return viewer.still;
    },
    state: () => structuredClone(editor.state),
    view: () => structuredClone(session.view),
    distances: () => structuredClone(distances.shown),
    seen(position) {
      const { x, y, hidden } = viewer.seen(Float32Array.from(position));
      const box = viewer.box;
      return hidden[0] ? null : { x: box.left + x[0]!, y: box.top + y[0]! };
    },
    under(x, y) {
      const picked = viewer.pick(x, y);
      if (!picked) return null;
      const { point, position } = picked;
      const place = viewer.surface!.fromScene(position);
      return { face: point.face, place, pixel: viewer.reach(position, 1) };
    },
    marked: () => viewer.marked(editor.state.drawing.active),
    info: () => structuredClone(session.client?.info ?? null),
    async mesh() {
      const { client } = session;
      if (!client) return null;
      return { info: structuredClone(client.info), ...(await arraysOf(client.arrays)) };
    },
  };
  Object.defineProperty(window, 'karcherPage', { value: Object.freeze(inspection) });
}
