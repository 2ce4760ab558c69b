import type { FieldOptions } from 'karcher';

/** The ways to compute centers of mass that the page offers, in the menu's order. */
const list = [
  {
    id: 'karcher-fast',
    label: 'Karcher (fast)',
    options: { method: 'karcher', solver: 'fast' },
  },
  {
    id: 'karcher-exact',
    label: 'Karcher (exact)',
    options: { method: 'karcher', solver: 'exact' },
  },
  {
    id: 'paper-exact',
    label: 'Paper (exact)',
    options: { method: 'paper', solver: 'exact' },
  },
  {
    id: 'paper-graph',
    label: 'Paper (graph)',
    options: { method: 'paper', solver: 'graph' },
  },
] as const satisfies { id: string; label: string; options: FieldOptions }[];

export type MethodId = (typeof list)[number]['id'];

export const methods: readonly { id: MethodId; label: string; options: FieldOptions }[] = list;

export const defaultMethod: MethodId = list[0].id;

export function methodOptions(id: MethodId): FieldOptions {
  return methods.find((method) => method.id === id)!.options;
}

export function isMethod(id: string | null): id is MethodId {
  return methods.some((method) => method.id === id);
}
