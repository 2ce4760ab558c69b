import type { FieldOptions } from 'karcher';

/** The quality of the shown curve: a fast draft, or the exact curve. */
export type Quality = 'draft' | 'exact';

/** The ways to compute centers of mass that the page offers, in the menu's order. */
const list = [
  {
    id: 'karcher',
    label: 'Karcher',
    options: { method: 'karcher', solver: 'fast' },
    refined: { method: 'karcher', solver: 'exact' },
  },
  {
    id: 'karcher-fast',
    label: 'Karcher, fast only',
    options: { method: 'karcher', solver: 'fast' },
  },
  {
    id: 'karcher-exact',
    label: 'Karcher, exact only',
    options: { method: 'karcher', solver: 'exact' },
  },
  {
    id: 'paper-exact',
    label: 'Paper (exact)',
    options: { method: 'paper', solver: 'exact' },
  },
  {
    id: 'paper-ring',
    label: 'Paper (exact, 1-ring)',
    options: { method: 'paper', solver: 'exact', star: 'ring' },
  },
  {
    id: 'paper-graph',
    label: 'Paper (graph of straight lines)',
    options: { method: 'paper', solver: 'graph' },
  },
] as const satisfies MethodEntry[];

interface MethodEntry {
  id: string;
  label: string;
  /** The options during an edit. They are also the final ones unless `refined` exists. */
  options: FieldOptions;
  /** The options of the final computation, in the background once the edit ends. */
  refined?: FieldOptions;
}

export type MethodId = (typeof list)[number]['id'];

export const methods: readonly (MethodEntry & { id: MethodId })[] = list;

export const defaultMethod: MethodId = list[0].id;

const find = (id: MethodId) => methods.find((method) => method.id === id)!;

export function methodOptions(id: MethodId): FieldOptions {
  return find(id).options;
}

/**
 * The options with which a method computes in the background; null if its first answer is final.
 */
export function refinedOptions(id: MethodId): FieldOptions | null {
  return find(id).refined ?? null;
}

/** The quality of a method's first answer; null for the paper's methods. */
export function qualityOf(id: MethodId): Quality | null {
  const { method, solver } = find(id).options;
  if (method !== 'karcher') return null;
  return solver === 'exact' ? 'exact' : 'draft';
}

export function isMethod(id: string | null): id is MethodId {
  return methods.some((method) => method.id === id);
}
