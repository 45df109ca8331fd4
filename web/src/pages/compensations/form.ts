// SPDX-License-Identifier: Apache-2.0
// What is typed beside a table, and the options that it makes.
import type { CompensatedControl, CompensationOptions } from '../../api/types';
import { parsed } from '../../numbers';
import { t } from './texts';
import { has_grid, has_use, other_curves, type OtherCurves } from './uses';

export const number_keys = ['start', 'end', 'step', 'points', 'reference', 'number', 'resolution', 'magnification', 'largest', 'steps_per_unit', 'period'] as const;
export type NumberKey = (typeof number_keys)[number];
export type Faults = Partial<Record<NumberKey, string>>;

export interface TableForm {
  axis: string;
  texts: Readonly<Record<NumberKey, string>>;
  method: 'least-squares' | 'interpolation';
  smooth: boolean;
  hold_ends: boolean;
  curves: OtherCurves | null;              // null: those of the control
  inch: boolean;
  periodic: 'keep' | 'leave';
  turned_sign: boolean;
  existing_unit: 'mm' | 'inch' | null;     // null: that of the new table
}

const no_texts = Object.fromEntries(number_keys.map((key) => [key, ''])) as Record<NumberKey, string>;
export const new_form: TableForm = { axis: '', texts: no_texts, method: 'least-squares', smooth: false, hold_ends: false, curves: null, inch: false, periodic: 'keep', turned_sign: false, existing_unit: null };

const whole: readonly NumberKey[] = ['points', 'number', 'magnification', 'largest'];
const above_zero: readonly NumberKey[] = ['step', 'resolution', 'steps_per_unit', 'points', 'magnification', 'period'];

/** The fields of numbers that a control has a use for, in the order in which they stand. */
export function offered_numbers(control: CompensatedControl): NumberKey[] {
  const grid: NumberKey[] = !has_grid(control) ? [] : control.limits.step !== null ? ['start', 'end', 'points'] : ['start', 'end', 'step', 'points'];
  const special = (['number', 'resolution', 'magnification', 'largest', 'steps_per_unit'] as const).filter((key) => has_use(control, key));
  return [...grid, 'reference', ...special];
}

/** The same of a table that is made of a test. */
export const making_numbers = (control: CompensatedControl): NumberKey[] => [...offered_numbers(control), 'period'];

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

/** What is known beside a form. */
export interface Beside {
  keys?: readonly NumberKey[];           // the fields of numbers that are shown
  expected_period?: number | null;       // of the test
  with_existing?: boolean;
}

export interface ReadForm { options: CompensationOptions | null; faults: Faults }

/** The options of a form: only what the control has a use for, whatever was typed for another one. null where a field is wrong. */
export function read_form(control: CompensatedControl, kind: 'linear' | 'rotary', form: TableForm, beside: Beside = {}): ReadForm {
  const { keys = offered_numbers(control), expected_period = null, with_existing = false } = beside;
  const faults: Faults = {};
  const numbers: Partial<Record<NumberKey, number>> = {};
  for (const key of keys) {
    const { value, fault } = read(key, form.texts[key]);
    if (fault !== null) faults[key] = fault;
    if (value !== null) numbers[key] = value;
  }
  const leaves = form.periodic === 'leave' && keys.includes('period');
  if (leaves && form.texts.period.trim() === '' && expected_period === null) faults.period = t('fault_period');
  const options: CompensationOptions = {
    control: control.id, ...numbers,
    ...(form.axis.trim() !== '' ? { axis: form.axis.trim() } : {}),
    ...(form.method === 'interpolation' ? { method: form.method } : {}),
    ...(form.smooth ? { smooth: true } : {}),
    ...(form.hold_ends && has_grid(control) ? { hold_ends: true } : {}),
    ...(form.curves !== null && other_curves(control).includes(form.curves) ? { curves: form.curves } : {}),
    ...(form.inch && counts_in_lengths(control, kind) ? { inch: true } : {}),
    ...(leaves ? { periodic: 'leave' as const } : {}),
    ...(form.turned_sign && has_use(control, 'turned_sign') ? { turned_sign: true } : {}),
    ...(form.existing_unit !== null && with_existing && counts_in_lengths(control, kind) ? { existing_unit: form.existing_unit } : {}),
  };
  return { options: Object.keys(faults).length > 0 ? null : options, faults };
}

/** Whether its numbers may be in mm or in inches. */
export const counts_in_lengths = (control: CompensatedControl, kind: 'linear' | 'rotary'): boolean => kind === 'linear' && has_use(control, 'inch');

/** Options that are chosen beside the control and the existing table. */
const elsewhere = ['control', 'turned_sign', 'existing_unit'];

/** How many of the others are not the usual ones. */
export const chosen_count = (options: CompensationOptions | null): number => Object.keys(options ?? {}).filter((key) => !elsewhere.includes(key)).length;

/** Those others as usual. */
export const as_usual = ({ turned_sign, existing_unit }: TableForm): TableForm => ({ ...new_form, turned_sign, existing_unit });

/** Of the way in which an existing table is read: what of the options says how its numbers are meant. */
export function reading_options(options: CompensationOptions, kind: 'linear' | 'rotary'): Record<string, unknown> {
  const keys = ['axis', 'number', 'reference', 'resolution', 'magnification', 'largest', 'step', 'steps_per_unit', 'turned_sign'] as const;
  const in_inch = options.existing_unit === undefined ? options.inch === true : options.existing_unit === 'inch';
  return { kind, ...Object.fromEntries(keys.filter((key) => options[key] !== undefined).map((key) => [key, options[key]])), ...(in_inch ? { inch: true } : {}) };
}
