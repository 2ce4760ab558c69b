import type { CurveSamples, Mesh } from 'karcher';
import { CurveMeter, type CurvePlan, type Peers, type Ruler, runMethod } from 'karcher/peers';
import { methodOf } from '../figures/lines';
import type { LineId } from '../figures/types';

/** The results of a uniform cubic B-spline that the studies need. */
export interface Spline {
  samples: CurveSamples | null;
  lost: number;
  of: number;
}

/** The B-spline that a method computes. */
export async function splineBy(
  peers: Peers,
  mesh: Mesh,
  plan: CurvePlan,
  id: LineId,
): Promise<Spline> {
  const run = await runMethod(peers, mesh, plan, methodOf(id), null, { once: true });
  return { samples: run.curve?.samples ?? null, lost: run.lost ?? 0, of: run.samples ?? 0 };
}

/**
 * The residual of a spline's samples by exact paths, and their turning noise relative to the true
 * curve, if there is one.
 */
export async function measured(
  mesh: Mesh,
  ruler: Ruler,
  { samples }: Spline,
  truth: CurveSamples | null,
): Promise<{ residual: number | null; turning: number | null }> {
  if (!samples) return { residual: null, turning: null };
  const { residual } = await ruler.measure(samples);
  const turning = truth && new CurveMeter(mesh).measure(samples, truth).turningNoise;
  return { residual: residual?.median ?? null, turning };
}
