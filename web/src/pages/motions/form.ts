// SPDX-License-Identifier: Apache-2.0
// How readings are evaluated: typed texts, and the options of a request that they stand for.
import type { CalibrationKind } from '../../api/types';
import { parsed } from '../../numbers';

export type MotionKind = Extract<CalibrationKind, 'straightness' | 'angles' | 'squareness'>;
export const is_motion_kind = (kind: CalibrationKind): kind is MotionKind => kind === 'straightness' || kind === 'angles' || kind === 'squareness';

export type MotionOptions = Readonly<Record<string, unknown>>;

export interface MotionForm {
  reference: string;           // '' as it is usual
  instrument_a: string; instrument_b: string;
  error: string;
  positive: string;
  square_error: string; square_uncertainty: string;
  offset: readonly [string, string, string];
}

export const empty_form: MotionForm = {
  reference: '', instrument_a: '', instrument_b: '', error: '', positive: '', square_error: '', square_uncertainty: '', offset: ['', '', ''],
};

/** Of options that were kept. */
export function motion_form_of(options: MotionOptions): MotionForm {
  const text = (value: unknown): string => (value === undefined || value === null ? '' : String(value));
  const list = (value: unknown): string[] => (Array.isArray(value) ? value.map(text) : []);
  const instrument = list(options['instrument']);
  const offset = list(options['offset_mm']);
  return {
    reference: text(options['reference']),
    instrument_a: instrument[0] ?? '', instrument_b: instrument[1] ?? '',
    error: text(options['error']),
    positive: list(options['positive']).join(', '),
    square_error: text(options['square_error_arcsec']), square_uncertainty: text(options['square_uncertainty_arcsec']),
    offset: [offset[0] ?? '', offset[1] ?? '', offset[2] ?? ''],
  };
}

/** Whether a text is neither empty nor a number. */
export const is_no_number = (text: string): boolean => text.trim() !== '' && parsed(text) === null;

/** Some of the three, or what is none. */
export const is_no_offset = ({ offset }: MotionForm): boolean =>
  offset.some((text) => text.trim() !== '') && !offset.every((text) => parsed(text) !== null);

/** What is asked; null where a field is wrong. A field that the kind has no use for is not sent. */
export function motion_options(kind: MotionKind, form: MotionForm): MotionOptions | null {
  const square = kind === 'squareness';
  const numbers = [form.instrument_a, form.instrument_b, ...(square ? [form.square_error, form.square_uncertainty] : [])];
  if (numbers.some(is_no_number) || (kind === 'angles' && is_no_offset(form))) return null;
  const [a, b] = [parsed(form.instrument_a), parsed(form.instrument_b)];
  const senses = form.positive.split(/[\s,;]+/).filter((word) => word !== '');
  const error = parsed(form.square_error);
  const uncertainty = parsed(form.square_uncertainty);
  return {
    ...(form.reference === '' ? {} : { reference: form.reference }),
    ...(a === null && b === null ? {} : { instrument: [a ?? 0, b ?? 0] }),
    ...(form.error.trim() === '' || square ? {} : { error: form.error.trim() }),
    ...(senses.length === 0 ? {} : { positive: senses }),
    ...(square && error !== null ? { square_error_arcsec: error } : {}),
    ...(square && uncertainty !== null ? { square_uncertainty_arcsec: uncertainty } : {}),
    ...(kind === 'angles' && form.offset[0].trim() !== '' ? { offset_mm: form.offset.map((text) => parsed(text) ?? 0) } : {}),
  };
}
