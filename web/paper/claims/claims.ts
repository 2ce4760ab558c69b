import { figureClaims } from './figure_claims';
import { limitClaims } from './limit_claims';
import { methodClaims } from './method_claims';
import type { Claim } from './types';

/** What the paper claims, in its order, section by section. */
export const claims: readonly Claim[] = [...methodClaims, ...figureClaims, ...limitClaims];
