// SPDX-License-Identifier: Apache-2.0
// The same figures of the same machine as they were kept over the years. Positions have a trend of their own: nothing of a
// test is here, and nothing of this there.
import { useMemo } from 'preact/hooks';
import type { CalibrationFigure, CalibrationPage, CalibrationRow, KeptCalibration } from '../../api/types';
import { query } from '../../api/client';
import { use_get } from '../../api/use';
import { Chart, Swatch, type ChartModel, type ChartSeries } from '../../components/chart/chart';
import { day_seconds } from '../../components/dates';
import { FailureNotice } from '../../components/failure';
import { go } from '../../router';
import { figure_name, is_main_figure, sign_of } from './figures';
import { t } from './texts';

const name_of = ({ parameter, of, unit }: CalibrationFigure): string => `${parameter} ${of} ${unit}`;

/** One that does not say when it was measured stands where it was kept. */
const seconds_of = (row: CalibrationRow): number => day_seconds(row.measured_on) ?? day_seconds(row.received_at) ?? 0;

/** Those of one day keep their order, a few hours apart. */
function times(rows: readonly CalibrationRow[]): number[] {
  let last = -Infinity;
  return rows.map((row) => (last = Math.max(seconds_of(row), last + 3 * 3600)));
}

/** The figures that this one is known by, of all that have them in their unit; u as two of it to either side. */
function model_of(main: readonly CalibrationFigure[], rows: readonly CalibrationRow[]): ChartModel {
  const series = main.map((figure, k): ChartSeries => {
    const found = rows.map(({ figures }) => figures.find((one) => name_of(one) === name_of(figure)) ?? null);
    return {
      key: name_of(figure), label: `${figure_name(figure.parameter, figure.of)}, ${sign_of(figure.unit)}`, colour: `--series-${(k % 8) + 1}`, width: 1.5, shape: 'circle', across: true,
      values: found.map((one) => one?.value ?? null),
      whisker: found.map((one): readonly [number, number] | null => (one && one.u !== null ? [one.value - 2 * one.u, one.value + 2 * one.u] : null)),
    };
  });
  const units = [...new Set(main.map(({ unit }) => sign_of(unit)))].join(', ');
  return { x: times(rows), x_kind: 'time', x_label: t('measured'), y_label: units, y_decimals: 2, series };
}

/** Nothing where no other one has these figures. */
export function CalibrationHistory({ calibration }: { calibration: KeptCalibration }) {
  const page = use_get<CalibrationPage>(`/api/calibrations${query({ kind: calibration.kind, machine: calibration.machine?.id ?? null, order: 'measured', descending: 0, limit: 500 })}`);
  const main = useMemo(() => calibration.figures.filter(is_main_figure), [calibration]);
  const rows = useMemo(() => {
    const machine = calibration.machine?.id;
    const same_machine = (row: CalibrationRow) => machine !== undefined && row.machine?.id === machine;
    const has_any = ({ figures }: CalibrationRow) => figures.some((one) => main.some((figure) => name_of(figure) === name_of(one)));
    return (page.data?.calibrations ?? []).filter((row) => same_machine(row) && has_any(row)).sort((a, b) => seconds_of(a) - seconds_of(b) || a.id - b.id);
  }, [page.data, main, calibration]);
  if (page.error) return <FailureNotice error={page.error} retry={page.reload} />;
  if (rows.length < 2 || main.length === 0) return null;
  const model = model_of(main, rows);
  return (
    <section class="panel calibration-history">
      <header><h2>{t('history')}</h2></header>
      <p class="row small">{model.series.map((series) => <span key={series.key}><Swatch series={series} /> {series.label}</span>)}</p>
      <Chart {...model} name={t('history')} height={260} on_choose={({ index }) => { const row = rows[index]; if (row) go(`/calibrations/${row.id}`); }} />
      <p class="quiet small">{t('history_hint')}</p>
    </section>
  );
}
