// SPDX-License-Identifier: Apache-2.0
// The figures by which a calibration is known, as words and numbers.
import type { CalibrationFigure, CalibrationRow } from '../../api/types';
import { fixed } from '../../numbers';
import { is_motion_kind } from '../motions/form';
import { t } from './texts';
import { colon } from '../../i18n/colon';

const signs: Record<CalibrationFigure['unit'], string> = { um: 'µm', arcsec: '″', urad: 'µrad', '': '' };

export const sign_of = (unit: string): string => signs[unit as CalibrationFigure['unit']] ?? unit;

/** "C0Y", "C0Y_end_points". */
const is_location = (parameter: string): boolean => /^[ABC]0[YZ](_(end_points|least_squares))?$/.test(parameter);

/** Lengths and angles with one decimal, those of straightness and angles with two, χ²/ν with three, counts with none. */
export function figure_text(parameter: string, unit: string, value: number | null): string {
  if (motion_figure(parameter).figure || is_location(parameter)) return fixed(value, 2);
  return fixed(value, unit !== '' ? 1 : parameter === 'chi2_per_dof' ? 3 : 0);
}

const named = ['chi2_per_dof', 'rank', 'unknowns', 'unseen_errors', 'readings'] as const;
const of_volume = ['volume_largest', 'volume_percent_95', 'volume_mean'] as const;

const of_motion = ['straightness', 'straightness_both', 'angle_range', 'angle_range_both', 'motion_reversal', 'motion_repeatability', 'squareness', 'squareness_in_axes'] as const;
const references = ['end_points', 'least_squares'] as const;

/** "straightness_end_points": the figure, and about which reference where that is not the usual one. */
function motion_figure(parameter: string): { figure: (typeof of_motion)[number] | undefined; reference: (typeof references)[number] | undefined } {
  const reference = references.find((one) => parameter.includes(`_${one}`));
  const bare = reference ? parameter.replace(`_${reference}`, '') : parameter;
  return { figure: of_motion.find((one) => one === bare), reference };
}

/** "A (xyz)", "Largest error, T1", "EXX". */
export function figure_name(parameter: string, of: string): string {
  const volume = of_volume.find((one) => one === parameter);
  if (volume) return t(volume, { of });
  const known = named.find((one) => one === parameter);
  if (known) return t(known);
  const { figure: motion, reference } = motion_figure(parameter);
  if (motion) return `${of === '' ? '' : `${of}: `}${t(motion)}${reference ? ` (${t(reference)})` : ''}`;
  if (is_location(parameter)) return reference ? `${parameter.slice(0, 3)} (${t(reference)})` : parameter;
  if (/^E[XYZABC][XYZ]$/.test(parameter)) return `max |${parameter}|`;
  return of === '' ? parameter : `${parameter} (${of})`;
}

const find = (row: Pick<CalibrationRow, 'figures'>, parameter: string) => row.figures.filter((one) => one.parameter === parameter);

const worst = (figures: readonly CalibrationFigure[]): CalibrationFigure | null =>
  figures.reduce<CalibrationFigure | null>((most, one) => (most === null || one.value > most.value ? one : most), null);

/** What a calibration is known by: lines by A, where any has it, else by E; the 21 errors by the volume; a squareness by its
    location error where the sign is known, and not by its lines. */
export function is_main_figure({ parameter }: CalibrationFigure, _: number, figures: readonly CalibrationFigure[]): boolean {
  if (parameter === 'A' || parameter === 'E') return parameter === (figures.some((one) => one.parameter === 'A') ? 'A' : 'E');
  if (parameter === 'volume_percent_95' || parameter === 'volume_mean') return true;
  const is_squareness = (one: string): boolean => /^squareness(_in_axes)?(_(end_points|least_squares))?$/.test(one);
  if (figures.some((one) => is_squareness(one.parameter)))
    return is_location(parameter) || (is_squareness(parameter) && !figures.some((one) => is_location(one.parameter)));
  const { figure } = motion_figure(parameter);
  return figure === 'straightness' || figure === 'angle_range';
}

/** Of squareness C0Y and its like where the sign is known, else S; of the others the range of each error. */
function motion_headline({ kind, figures }: Pick<CalibrationRow, 'kind' | 'figures'>): string {
  const shown = figures.filter(is_main_figure);
  return (kind === 'squareness' ? shown.slice(0, 1) : shown).map(({ parameter, of, value, unit }) => `${of === '' ? figure_name(parameter, of) : of} ${figure_text(parameter, unit, value)} ${sign_of(unit)}`).join(', ');
}

/** What a list shows: of lines how many and the worst A and E, of the 21 errors the volume, χ²/ν and what is not told. */
export function headline(row: Pick<CalibrationRow, 'kind' | 'figures'>): string {
  if (row.kind === 'lines') {
    const lines = new Set(row.figures.map((one) => one.of)).size;
    const list = (['A', 'E'] as const).flatMap((key) => {
      const most = worst(find(row, key));
      return most ? [`${key} ≤ ${fixed(most.value, 1)} ${sign_of(most.unit)} (${most.of})`] : [];
    });
    return t('worst_lines', { n: lines, list: list.join(', ') });
  }
  if (is_motion_kind(row.kind)) return motion_headline(row);
  const largest = worst(find(row, 'volume_largest'));
  const mean = largest && find(row, 'volume_mean').find((one) => one.of === largest.of);
  const chi2 = find(row, 'chi2_per_dof')[0];
  const unseen = find(row, 'unseen_errors')[0];
  return [
    largest && `${t('largest')} ${fixed(largest.value, 1)} µm (${t('worst_tool', { tool: largest.of })})`,
    mean && `${t('mean')} ${fixed(mean.value, 1)} µm`,
    chi2 && `χ²/ν ${fixed(chi2.value, 2)}`,
    unseen && unseen.value > 0 && `${t('unseen')}${colon()} ${unseen.value}`,
  ].filter(Boolean).join(', ');
}
