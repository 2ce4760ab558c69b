import { type State, selectedObjects } from '../editor/state/state';
import { type CurveSettings, isCurve } from '../model/figure';
import { make } from './elements';

/**
 * Returns a function that reads a setting of the selected curves: undefined if their values differ.
 */
export function sharedSettings(state: State) {
  const ids = selectedObjects(state);
  const selected = state.drawing.objects
    .filter(({ id, figure: { kind } }) => ids.includes(id) && isCurve(kind))
    .map(({ figure }) => figure.settings);
  const all = selected.length > 0 ? selected : [state.figure.settings];
  return <Key extends keyof CurveSettings>(key: Key): CurveSettings[Key] | undefined => {
    const value = all[0]![key];
    return all.every((settings) => settings[key] === value) ? value : undefined;
  };
}

/** Shows a shared value. If it is undefined, the control shows that the values are mixed. */
export function showShared(
  control: HTMLInputElement | HTMLSelectElement,
  value: string | number | boolean | undefined,
): void {
  if (control instanceof HTMLInputElement) {
    control.checked = value === true;
    control.indeterminate = value === undefined;
    return;
  }
  const mixed = control.querySelector('option[value=""]');
  if (value === undefined && !mixed) {
    control.prepend(make('option', 'mixed', { value: '', hidden: true }));
  }
  control.value = value === undefined ? '' : `${value}`;
}
