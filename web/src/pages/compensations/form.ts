// SPDX-License-Identifier: Apache-2.0
// What is typed beside a table, and the options that it makes.
import type { CompensatedControl, CompensationOptions } from '../../api/types';
import { parsed } from '../../numbers';
import { t } from './texts';
import { has_grid, has_use } from './uses';

export const number_keys = ['start', 'end', 'step', 'points', 'reference', 'number', 'resolution', 'magnification', 'largest', 'steps_per_unit'] as const;
export type NumberKey = (typeof number_keys)[number];
export type Faults = Partial<Record<NumberKey, string>>;

export interface TableForm {
  axis: string;
  texts: Readonly<Record<NumberKey, string>>;
  method: 'least-squares' | 'interpolation';
  smooth: boolean;
  hold_ends: boolean;
  one_curve: boolean;
  inch: boolean;
}

const no_texts = Object.fromEntries(number_keys.map((key) => [key, ''])) as Record<NumberKey, string>;
export const new_form: TableForm = { axis: '', texts: no_texts, method: 'least-squares', smooth: false, hold_ends: false, one_curve: false, inch: false };

const whole: readonly NumberKey[] = ['points', 'number', 'magnification', 'largest'];
const above_zero: readonly NumberKey[] = ['step', 'resolution', 'steps_per_unit', 'points', 'magnification'];

/** The fields of numbers that a control has a use for, in the order in which they stand. */
export function offered_numbers(control: CompensatedControl): NumberKey[] {
  const grid: NumberKey[] = !has_grid(control) ? [] : control.limits.step !== null ? ['start', 'end', 'points'] : ['start', 'end', 'step', 'points'];
  const special = (['number', 'resolution', 'magnification', 'largest', 'steps_per_unit'] as const).filter((key) => has_use(control, key));
  return [...grid, 'reference', ...special];
}

/** The same of a table that is only read. */
export const reading_numbers = (control: CompensatedControl): NumberKey[] => [
  ...(has_use(control, 'read_step') ? ['step' as const] : []), 'reference',
  ...(['number', 'resolution', 'magnification', 'largest', 'steps_per_unit'] as const).filter((key) => has_use(control, key)),
];

/** A number, nothing where none was typed, or what is wrong with it. */
function read(key: NumberKey, text: string): { value: number | null; fault: string | null } {
  if (text.trim() === '') return { value: null, fault: null };
  const value = parsed(text);
  if (value === null) return { value: null, fault: t('fault_number', { text: text.trim() }) };
  if (whole.includes(key) && !Number.isInteger(value)) return { value: null, fault: t('fault_whole', { text: text.trim() }) };
  if (above_zero.includes(key) && !(value > 0)) return { value: null, fault: t('fault_above', { text: text.trim() }) };
  if (whole.includes(key) && value < 0) return { value: null, fault: t('fault_whole', { text: text.trim() }) };
  return { value, fault: null };
}

export interface ReadForm { options: CompensationOptions | null; faults: Faults }

/** The options of a form: only what the control has a use for, whatever was typed for another one. null where a field is wrong. */
export function read_form(control: CompensatedControl, kind: 'linear' | 'rotary', form: TableForm, keys: readonly NumberKey[] = offered_numbers(control)): ReadForm {
  const faults: Faults = {};
  const numbers: Partial<Record<NumberKey, number>> = {};
  for (const key of keys) {
    const { value, fault } = read(key, form.texts[key]);
    if (fault !== null) faults[key] = fault;
    if (value !== null) numbers[key] = value;
  }
  const options: CompensationOptions = {
    control: control.id, ...numbers,
    ...(form.axis.trim() !== '' ? { axis: form.axis.trim() } : {}),
    ...(form.method === 'interpolation' ? { method: form.method } : {}),
    ...(form.smooth ? { smooth: true } : {}),
    ...(form.hold_ends && has_grid(control) ? { hold_ends: true } : {}),
    ...(form.one_curve && control.limits.curves !== 'both-ways' ? { curves: 'both-ways' as const } : {}),
    ...(form.inch && kind === 'linear' && has_use(control, 'inch') ? { inch: true } : {}),
  };
  return { options: Object.keys(faults).length > 0 ? null : options, faults };
}

/** How many of the options are not the usual ones. */
export const chosen_count = (options: CompensationOptions | null): number => Object.keys(options ?? {}).length - (options === null ? 0 : 1);

/** Of the way in which a table is read: what of the options says how its numbers are meant. */
export function reading_options(options: CompensationOptions, kind: 'linear' | 'rotary'): Record<string, unknown> {
  const keys = ['axis', 'inch', 'number', 'reference', 'resolution', 'magnification', 'largest', 'step', 'steps_per_unit'] as const;
  return { kind, ...Object.fromEntries(keys.filter((key) => options[key] !== undefined).map((key) => [key, options[key]])) };
}
