// SPDX-License-Identifier: Apache-2.0
// Options that were kept, in the words of the fields that ask for them.
import type { CalibrationKind } from '../../api/types';
import { kept_option, type Options } from '../../components/evaluation_options';
import { typed } from '../../numbers';
import { is_motion_kind } from '../motions/form';
import { kept_motion_option } from '../motions/words';
import { t } from './texts';
import { colon, semicolon } from '../../i18n/colon';

function value_text(value: unknown): string {
  if (typeof value === 'boolean') return t(value ? 'yes' : 'no');
  if (typeof value === 'number') return typed(value);
  if (Array.isArray(value)) return value.map(value_text).join(', ');
  if (value !== null && typeof value === 'object') return Object.entries(value).map(([name, member]) => `${name} ${value_text(member)}`).join(', ');
  return value === null ? t('unstated') : String(value);
}

/** "Curves: B-splines; Spans: 6"; nothing where none was asked for. One without a field has the name that it was kept under. */
export function told_options(kind: CalibrationKind, options: Options): string {
  return Object.entries(options).flatMap(([key, value]) => {
    const of_lengths = is_motion_kind(kind) ? undefined : kept_option(key, value);
    const pairs = (is_motion_kind(kind) ? kept_motion_option(key, value) : of_lengths && [of_lengths]) ?? [[key, value] as const];
    return pairs.map(([label, one]) => `${label}${colon()} ${value_text(one)}`);
  }).join(semicolon());
}
