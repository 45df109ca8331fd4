// SPDX-License-Identifier: Apache-2.0
import { useMemo } from 'preact/hooks';
import { Chart, type ChartModel } from '../../components/chart/chart';
import { language } from '../../settings';
import { t } from './texts';

interface Residual { value: number; sigma: number; aside: boolean }

/** The table of /identification/residuals: its last three columns, whatever stands before them. */
export function residuals_of(csv: string): Residual[] {
  return csv.trim().split('\n').slice(1).map((line) => {
    const [value, sigma, aside] = line.split(',').slice(-3);
    return { value: Number(value), sigma: Number(sigma), aside: aside === 'yes' };
  }).filter(({ value }) => Number.isFinite(value));
}

export function ResidualChart({ csv }: { csv: string }) {
  const model = useMemo(() => chart_of(residuals_of(csv)), [csv, language.value]);
  return (
    <>
      <h3>{t('residuals')}</h3>
      <p class="quiet">{t('residuals_how')}</p>
      <Chart {...model} name={t('residuals')} height={240} />
    </>
  );
}

function chart_of(list: Residual[]): ChartModel {
  const taken = list.map(({ value, aside }) => (aside ? null : value));
  // They do not count, and would press all that do onto the line of zero.
  const edge = 1.25 * list.reduce((most, { value, sigma, aside }) => Math.max(most, 2 * sigma, aside ? 0 : Math.abs(value)), 0);
  const set_aside = list.map(({ value, aside }) => (aside ? Math.min(edge, Math.max(-edge, value)) : null));
  return {
    x: list.map((_, k) => k + 1), x_label: t('reading'), y_label: t('residual'), y_zero: true,
    bands: [{ key: 'sigma', colour: '--series-1', opacity: 0.12, upper: list.map(({ sigma }) => 2 * sigma), lower: list.map(({ sigma }) => -2 * sigma) }],
    series: [
      { key: 'taken', label: t('taken_reading'), values: taken, colour: '--series-1', width: 0, shape: 'circle', size: list.length > 500 ? 3 : 5 },
      ...(set_aside.some((value) => value !== null) ? [{ key: 'aside', label: t('aside'), values: set_aside, colour: '--series-2', width: 0, shape: 'diamond' as const, size: 7 }] : []),
    ],
  };
}
