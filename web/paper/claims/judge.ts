import { claims } from './claims';
import { Evidence, type JudgedClaim, type Measured, NotMeasured } from './types';

/** A verdict for every claim. */
export function judge(measured: Measured): JudgedClaim[] {
  const evidence = new Evidence(measured);
  return claims.map(({ id, where, claim, figure, judge }) => {
    try {
      return { id, where, claim, figure, ...judge(evidence) };
    } catch (error) {
      if (!(error instanceof NotMeasured)) throw error;
      return { id, where, claim, figure, verdict: 'not measured here', measured: error.message };
    }
  });
}
