// SPDX-License-Identifier: Apache-2.0
import type { VolumetricFinding } from '../../api/types';
import { words_by } from '../../components/page_words';
import { t as of_volume } from '../volume/result_texts';
import { t } from './texts';

/** What the command line calls by a flag has a name of its own on this page; a flag with its word, where a choice has one. */
const named = {
  axis: 'axis_name', start: 'start', end: 'end', step: 'step', points: 'points', reference: 'reference', number: 'number', resolution: 'resolution',
  magnification: 'magnification', largest: 'largest', 'steps-per-unit': 'steps_per_unit', smooth: 'smooth', 'hold-ends': 'hold_ends', curves: 'curves',
  inch: 'inch', method: 'method', periodic: 'periodic', period: 'period', 'turned-sign': 'turned_sign', 'existing-unit': 'existing_unit', existing: 'flag_existing', retest: 'flag_retest',
  'curves both-ways': 'one_curve', 'curves with-backlash': 'curve_beside', 'periodic leave': 'periodic_leave', 'periodic keep': 'periodic_keep',
} as const;

/** A sentence of the program, its flags called as the fields of this page. */
export const page_words = words_by((flag) => {
  if (flag === 'output-axis') return of_volume('output_axis');  // of cross tables, which the page of the volume makes
  return flag in named ? t(named[flag as keyof typeof named]) : undefined;
});

export const in_page_words = (findings: readonly VolumetricFinding[]): VolumetricFinding[] =>
  findings.map((finding) => ({ ...finding, message: page_words(finding.message) }));
