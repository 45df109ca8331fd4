// SPDX-License-Identifier: Apache-2.0
// How the page of straightness, angles and squareness calls the options that were kept.
import { t } from './texts';

const fields = {
  reference: 'reference', error: 'error', positive: 'positive', square_error_arcsec: 'square_error', square_uncertainty_arcsec: 'square_uncertainty', offset_mm: 'offset',
} as const;
const references = ['least-squares', 'end-points', 'none'] as const;

/** Options that were kept as their fields call them, a pair or more for each; nothing where one has no field. */
export function kept_motion_option(key: string, value: unknown): readonly (readonly [label: string, value: unknown])[] | undefined {
  if (key === 'instrument' && Array.isArray(value)) return [[t('instrument_a'), value[0]], [t('instrument_b'), value[1] ?? 0]];
  if (!(key in fields)) return undefined;
  const reference = key === 'reference' ? references.find((one) => one === value) : undefined;
  return [[t(fields[key as keyof typeof fields]), reference ? t(reference) : value]];
}
