import { claims } from './claims';
import { Evidence, type JudgedClaim, type Measured, NotMeasured } from './types';
import { num } from './words';

/** A verdict for every claim. */
export function judge(measured: Measured): JudgedClaim[] {
  return claims.map(({ id, where, claim, figure, judge }) => {
    const evidence = new Evidence(measured);
    try {
      const finding = judge(evidence);
      const told = `${finding.measured}${failures(evidence)}${busy(evidence)}`;
      return { id, where, claim, figure, ...finding, measured: told };
    } catch (error) {
      if (!(error instanceof NotMeasured)) throw error;
      return { id, where, claim, figure, verdict: 'not measured here', measured: error.message };
    }
  });
}

/** A sentence that says why times do not decide; empty if they do. */
function busy({ heldOpen, all: { load } }: Evidence): string {
  if (!heldOpen) return '';
  const why = load
    ? `was not quiet (load ${num(load.most)} on ${load.cores} cores)`
    : 'is not known to have been quiet';
  return ` The machine ${why}: what depends on time stays open.`;
}

/** A sentence about the failed methods, whose samples all count as lost; empty if none failed. */
function failures({ failed }: Evidence): string {
  if (failed.size === 0) return '';
  const list = [...failed].map(([line, reason]) => `${line} (${reason})`);
  return ` Failed, so that all of its samples count as lost: ${list.join('; ')}.`;
}
