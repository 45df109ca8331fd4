// SPDX-License-Identifier: Apache-2.0
// How the pages of captures call what `axiometry capture` calls by a flag.
import { words_by } from '../../components/page_words';
import { t as of_motion } from './motion_texts';
import { of_option, option_keys, t } from './texts';

const of_stops = {
  stops: 'stops', 'stops keys': 'keys', 'stops trigger': 'trigger', 'stops readings': 'readings', 'stops position': 'position',
  error: 'error', unit: 'unit', 'stop-column': 'stop_column', positive: 'positive', equipment: 'equipment',
} as const;
const of_streams = [...option_keys, 'reverse', 'zero'] as const;

/** A label without the unit, which a sentence needs not. */
const without_unit = (label: string): string => label.replace(' ({unit})', '');

export function capture_label(flag: string): string | undefined {
  if (flag in of_stops) return of_motion(of_stops[flag as keyof typeof of_stops]);
  if (flag === 'plan' || flag === 'part') return t(flag);
  const stated = of_streams.find((one) => one === flag);
  return stated && without_unit(of_option(stated));
}

export const capture_words = words_by(capture_label);
