// SPDX-License-Identifier: Apache-2.0
// Figures as a line of text, in lists.
import type { CompensationFigure, CompensationHead, TestRow } from '../../api/types';
import { shown_of } from '../../components/figure_cell';
import { decimals_for, fixed, unit_sign } from '../../numbers';
import { t } from './texts';

/** "A 6.1 µm, E 4.0 µm" of a test. */
export function figure_line({ figures, unit }: TestRow): string {
  return (['A', 'E'] as const).flatMap((parameter) => {
    const shown = shown_of(figures, parameter);
    return shown ? [`${parameter} ${shown.value} ${unit_sign(unit)}`] : [];
  }).join(', ');
}

/** E; of a test in one direction that one's. */
export const main_figure = (figures: readonly CompensationFigure[]): CompensationFigure | null =>
  ['E', 'E_up', 'E_down'].map((key) => figures.find(({ parameter }) => parameter === key)).find((one) => one !== undefined) ?? null;

/** "E 12.3 → 1.4 µm predicted, 1.6 measured again": with the decimals of the largest. */
export function effect_line({ figures, unit }: Pick<CompensationHead, 'figures' | 'unit'>): string {
  const found = main_figure(figures);
  if (found === null || found.before === null || found.predicted === null) return '';
  const decimals = Math.max(decimals_for(found.before, 2), 1);
  const values = { symbol: found.parameter.replace('_up', '↑').replace('_down', '↓'), before: fixed(found.before, decimals), predicted: fixed(found.predicted, decimals), unit: unit_sign(unit) };
  return found.retest === null ? t('effect', values) : t('effect_again', { ...values, again: fixed(found.retest, decimals) });
}

/** As short as a mark on a chart may be: what stands before the first comma of a control's title. */
export function short_control(title: string): string {
  const first = title.split(/,|\s\(/)[0] ?? title;
  return first.length > 22 ? `${first.slice(0, 21)}…` : first;
}
