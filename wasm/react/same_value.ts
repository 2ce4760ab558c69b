/** Whether two values have the same numbers, strings and functions, in arrays and plain objects. */
export function isSameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  const [names, others] = [Object.keys(a), Object.keys(b)];
  if (names.length !== others.length) return false;
  return names.every(
    (name) =>
      name in b && isSameValue(a[name as keyof typeof a] as unknown, b[name as keyof typeof b]),
  );
}
