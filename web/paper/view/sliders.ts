import { usualStretch } from '../../model/meshes';
import { make } from '../../panels/elements';
import type { CurveSpec, MeshSpec } from '../figures/types';

/** The logarithms of the smallest and the largest weight, 1/100 and 100. */
const [least, most] = [-2, 2];

/** Sliders for the weights or betas of a curve; null for curves that have none. */
export function sliders(curve: CurveSpec, change: (curve: CurveSpec) => void): HTMLElement | null {
  if (curve.kind !== 'rational' && curve.kind !== 'barycentric') return null;
  const rational = curve.kind === 'rational';
  const values = [...(rational ? curve.weights : curve.betas)];
  const box = make('div', '', { className: 'sliders' });
  values.forEach((value, i) => {
    const name = `${rational ? 'w' : 'β'}${'₁₂₃₄₅₆'[i]}`;
    const range = make('input', '', { type: 'range' });
    Object.assign(range, { min: `${least}`, max: `${most}`, step: '0.01' });
    range.value = `${Math.log10(value)}`;
    range.setAttribute('aria-label', name);
    const output = make('output', `${value}`);
    range.addEventListener('input', () => {
      values[i] = Number((10 ** Number(range.value)).toPrecision(3));
      output.textContent = `${values[i]}`;
      change(
        rational
          ? { kind: 'rational', weights: [...values] }
          : { kind: 'barycentric', betas: [...values] },
      );
    });
    const label = make('label');
    label.append(make('span', name), range, output);
    box.append(label);
  });
  return box;
}

/**
 * A slider for the cells of an anisotropic plane: the ratio of their length to their height. Null
 * for other meshes. When the reader releases the slider, the mesh changes.
 */
export function stretchSlider(
  mesh: MeshSpec,
  change: (mesh: MeshSpec) => void,
): HTMLElement | null {
  if (mesh.kind !== 'plane' || mesh.tessellation !== 'anisotropic') return null;
  const range = make('input', '', { type: 'range', min: '1', max: '50', step: '1' });
  range.value = `${mesh.stretch ?? usualStretch}`;
  range.setAttribute('aria-label', 'Anisotropy');
  const output = make('output', `${range.value} : 1`);
  range.addEventListener('input', () => {
    output.textContent = `${range.value} : 1`;
  });
  range.addEventListener('change', () => {
    const { stretch: _, ...plain } = mesh;
    const stretch = Number(range.value);
    change(stretch === usualStretch ? plain : { ...plain, stretch });
  });
  const label = make('label', '', { className: 'wide' });
  label.append(make('span', 'Anisotropy'), range, output);
  const box = make('div', '', { className: 'sliders' });
  box.append(label);
  return box;
}
