// SPDX-License-Identifier: Apache-2.0
import type { VolumetricFinding } from '../../api/types';
import { t } from './texts';

/** What the command line calls by a flag has a name of its own on this page. */
const named = {
  axis: 'axis_name', start: 'start', end: 'end', step: 'step', points: 'points', reference: 'reference', number: 'number', resolution: 'resolution',
  magnification: 'magnification', largest: 'largest', 'steps-per-unit': 'steps_per_unit', smooth: 'smooth', 'hold-ends': 'hold_ends', curves: 'curves',
  inch: 'inch', method: 'method', periodic: 'periodic', period: 'period', 'turned-sign': 'turned_sign', 'existing-unit': 'existing_unit', existing: 'flag_existing', retest: 'flag_retest',
} as const;

/** A flag with its word, where a choice has a name of its own. */
const chosen = {
  'curves both-ways': 'one_curve', 'curves with-backlash': 'curve_beside', 'periodic leave': 'periodic_leave', 'periodic keep': 'periodic_keep',
} as const;

/** A sentence of the program, its flags called as the fields of this page. */
export const page_words = (text: string): string =>
  text.replace(/--([a-z]+(?:-[a-z]+)*)( (?:both-ways|with-backlash|leave|keep)\b)?/g, (all, name: string, word = '') => {
    const choice = `${name}${word}`;
    if (choice in chosen) return t('quoted', { text: t(chosen[choice as keyof typeof chosen]) });
    return name in named ? `${t('quoted', { text: t(named[name as keyof typeof named]) })}${word}` : all;
  });

export const in_page_words = (findings: readonly VolumetricFinding[]): VolumetricFinding[] =>
  findings.map((finding) => ({ ...finding, message: page_words(finding.message) }));
