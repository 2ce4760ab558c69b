import type { LongWorkOptions } from 'karcher';
import {
  type CompareOptions,
  type CurvePlan,
  type MethodOptions,
  type Peers,
  Ruler,
  runMethod,
  standardOptions,
} from 'karcher/peers';
import { makeMesh } from '../../model/made_mesh';
import { NearestPoints } from '../lab/nearest';
import { type TableCell, type TableMethod, type TableRow, tableMethods } from './rows';

/**
 * The largest number of triangles for measurements by exact paths. On larger meshes, these would
 * take longer than the methods.
 */
const mostMeasured = 60_000;

export interface TableOptions {
  rows: readonly TableRow[];
  /** The methods; all of them by default. */
  methods?: readonly TableMethod[];
  /** The number of samples a segment. */
  samples: number;
  /** The time in milliseconds after which a method gives up a row. */
  budgetMs: number;
}

export interface TableEvents {
  /** Receives a row before its mesh is made. */
  row(row: TableRow): void;
  /** Receives a cell before its method begins. */
  method(cell: Pick<TableCell, 'row' | 'method' | 'triangles' | 'segments'>): void;
  progress(done: number, stage: string): void;
  cell(cell: TableCell): void;
}

/** The options for the table. For two points, our method has exact distances, like the paper's. */
function tableOptions(method: TableMethod, plan: CurvePlan): MethodOptions {
  const exact = method === 'karcher' && plan.points.length === 2;
  return exact ? { method, solver: 'exact' } : standardOptions(method, plan);
}

/**
 * Measures all methods in all rows, one after the other. Each method has its own copy of the row's
 * mesh. Rejects with the signal's reason.
 */
export async function runTable(
  peers: Peers,
  { rows, methods = tableMethods, samples, budgetMs }: TableOptions,
  events: TableEvents,
  signal?: AbortSignal,
): Promise<void> {
  const work: CompareOptions & LongWorkOptions = { signal, budgetMs, progress: events.progress };
  for (const row of rows) {
    events.row(row);
    const mesh = await makeMesh(peers.karcher, row.mesh);
    try {
      const nearest = new NearestPoints(mesh.positions(), mesh.triangles());
      const points = row.points.map((place) => ({ vertex: nearest.vertex(place) }));
      const plan = peers.plan(points, samples);
      const { triangles } = mesh.info;
      const ruler = triangles <= mostMeasured ? new Ruler(mesh, plan) : undefined;
      for (const method of methods) {
        signal?.throwIfAborted();
        const cell = { row: row.id, method, triangles, segments: plan.first.length };
        events.method(cell);
        const options = tableOptions(method, plan);
        const { curve: _, ...result } = await runMethod(peers, mesh, plan, options, null, {
          ...work,
          ruler,
        });
        events.cell({ ...cell, result });
      }
    } finally {
      mesh.dispose();
    }
  }
}
