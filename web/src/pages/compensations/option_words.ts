// SPDX-License-Identifier: Apache-2.0
// What a table depends on beside its test, in the words of the fields in which it was chosen.
import type { CompensationOptions } from '../../api/types';
import { position_unit, shortest, unit_sign } from '../../numbers';
import { number_keys, type NumberKey } from './form';
import { t } from './texts';

const positions: readonly NumberKey[] = ['start', 'end', 'step', 'reference', 'period'];

export function number_label(key: NumberKey, kind: 'linear' | 'rotary'): string {
  const unit = key === 'steps_per_unit' ? t('per', { unit: position_unit(kind) })
    : key === 'resolution' ? unit_sign(kind === 'linear' ? 'um' : 'arcsec')
    : positions.includes(key) ? position_unit(kind) : '';
  return unit === '' ? t(key) : `${t(key)} / ${unit}`;
}

/** "Spacing / mm: 25"; what is as usual is not told. */
export function option_words(options: CompensationOptions, kind: 'linear' | 'rotary'): string[] {
  const pair = (label: string, value: string) => t('pair', { label, value });
  return [
    ...(options.axis === undefined ? [] : [pair(t('axis_name'), options.axis)]),
    ...number_keys.flatMap((key) => (options[key] === undefined ? [] : [pair(number_label(key, kind), shortest(options[key], 9))])),
    ...(options.method === 'interpolation' ? [pair(t('method'), t('interpolation'))] : []),
    ...(options.curves === undefined ? [] : [pair(t('curves'), t(options.curves === 'both-ways' ? 'one_curve' : 'curve_beside'))]),
    ...(options.periodic === 'leave' ? [pair(t('periodic'), t('periodic_leave'))] : []),
    ...(['smooth', 'hold_ends', 'inch'] as const).flatMap((key) => (options[key] === true ? [t(key)] : [])),
    ...(options.turned_sign === true ? [t('is_turned')] : []),
    ...(options.existing_unit === undefined ? [] : [pair(t('existing_unit'), t(options.existing_unit === 'inch' ? 'unit_inch' : 'unit_mm'))]),
  ];
}
