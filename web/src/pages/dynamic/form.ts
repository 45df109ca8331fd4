// SPDX-License-Identifier: Apache-2.0
// How a recording is evaluated: typed texts, and the options of a request that they stand for.
import type { DynamicOptions } from '../../api/types';
import { parsed } from '../../numbers';

/** Of numbers the name of the option, and its bounds as the program has them. */
interface Bounds { option: keyof DynamicOptions; above?: number; most?: number; is_whole?: boolean }
const numbers = {
  feed: { option: 'feed_per_min', above: 0, most: 1e9 },
  from: { option: 'from_s' },
  to: { option: 'to_s' },
  window: { option: 'window_s', above: 0, most: 1e9 },
  even: { option: 'even_percent', above: 0, most: 50 },
  rate: { option: 'rate_hz', above: 0, most: 1e9 },
  units_per_count: { option: 'units_per_count' },
  stream_axis: { option: 'stream_axis', above: 0, most: 1e6, is_whole: true },
} as const satisfies Record<string, Bounds>;

export type NumberKey = keyof typeof numbers;
export interface DynamicForm extends Record<NumberKey, string> {
  kind: 'linear' | 'rotary';
  stream: string;              // '' as it is recognised
  skip_damaged: boolean;
  reverse: boolean;
}

export const empty_form: DynamicForm = {
  kind: 'linear', stream: '', skip_damaged: false, reverse: false, feed: '', from: '', to: '', window: '', even: '', rate: '', units_per_count: '', stream_axis: '',
};

/** What is wrong with a typed number. */
export function fault_of(key: NumberKey, text: string): 'number' | 'whole' | 'bounds' | null {
  if (text.trim() === '') return null;
  const value = parsed(text);
  if (value === null || !Number.isFinite(value)) return 'number';
  const { above, most, is_whole }: Bounds = numbers[key];
  if (is_whole && !Number.isInteger(value)) return 'whole';
  return (above !== undefined && value <= above) || (most !== undefined && value > most) ? 'bounds' : null;
}
export const bounds_of = (key: NumberKey): { above: number; most: number } => ({ above: 0, most: 0, ...numbers[key] });

/** What is asked; null where a field is wrong. */
export function dynamic_options(form: DynamicForm): DynamicOptions | null {
  const options: DynamicOptions = {
    ...(form.kind === 'rotary' ? { kind: form.kind } : {}),
    ...(form.stream === '' ? {} : { stream: form.stream }),
    ...(form.skip_damaged ? { skip_damaged: true } : {}),
    ...(form.reverse ? { reverse: true } : {}),
  };
  for (const key of Object.keys(numbers) as NumberKey[]) {
    if (fault_of(key, form[key]) !== null) return null;
    const value = parsed(form[key]);
    if (value !== null) options[numbers[key].option] = value;
  }
  return options;
}
