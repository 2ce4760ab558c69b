import { claims } from './claims';
import { Evidence, type JudgedClaim, type Measured, NotMeasured } from './types';

/** A verdict for every claim. */
export function judge(measured: Measured): JudgedClaim[] {
  return claims.map(({ id, where, claim, figure, judge }) => {
    const evidence = new Evidence(measured);
    try {
      const finding = judge(evidence);
      const told = `${finding.measured}${failures(evidence)}`;
      return { id, where, claim, figure, ...finding, measured: told };
    } catch (error) {
      if (!(error instanceof NotMeasured)) throw error;
      return { id, where, claim, figure, verdict: 'not measured here', measured: error.message };
    }
  });
}

/** Which samples were counted as lost because their method failed. */
function failures({ failed }: Evidence): string {
  if (failed.size === 0) return '';
  const list = [...failed].map(([line, reason]) => `${line} (${reason})`);
  return ` Failed, so that all of its samples count as lost: ${list.join('; ')}.`;
}
