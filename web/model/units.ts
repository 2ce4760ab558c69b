/** The unit of a surface's coordinates, which files seldom state. */
export const units = ['', 'mm', 'cm', 'm', 'in'] as const;
export type Unit = (typeof units)[number];

export const isUnit = (text: string | null): text is Unit => units.some((unit) => unit === text);

/**
 * The most likely unit of a file by its name: meters for glTF, millimeters for STL, the format of
 * prints.
 */
export function guessUnit(name: string): Unit {
  if (/\.stl$/i.test(name)) return 'mm';
  return /\.(glb|gltf)$/i.test(name) ? 'm' : '';
}

/** Four digits. From 10,000 on `toPrecision` would write an exponent. */
const fourDigits = (value: number) => {
  const text = value.toPrecision(4);
  return text.includes('e+') ? `${Number(text)}` : text;
};

const withUnit = (number: string, unit: string) => (unit ? `${number} ${unit}` : number);

export const formatLength = (length: number, unit: Unit = '') => withUnit(fourDigits(length), unit);

export const formatVolume = (volume: number, unit: Unit = '') =>
  withUnit(fourDigits(volume), unit && `${unit}³`);

export const formatArea = (area: number, unit: Unit = '') =>
  withUnit(fourDigits(area), unit && `${unit}²`);
