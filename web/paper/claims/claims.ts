import { figureClaims } from './figure_claims';
import { limitClaims } from './limit_claims';
import { methodClaims } from './method_claims';
import type { Claim } from './types';

/** The claims of the paper, in its order, section by section. */
export const claims: readonly Claim[] = [...methodClaims, ...figureClaims, ...limitClaims];
