// SPDX-License-Identifier: Apache-2.0
// The positioning chart of a test in terms of the drawing: runs, means, bands, limits.
import type { ChartBand, ChartLine, ChartModel, ChartSeries, Values } from '../../components/chart/chart';
import type { Evaluated, Parameter, PositionResult, Verdict } from '../../api/types';
import { texts } from '../../i18n/texts';
import { position_unit, shortest, unit_sign } from '../../numbers';
import { plain_symbol } from './figures_text';
import { record_method } from './record_choice';

export const t = texts({
  position: 'Position',
  deviation: 'Deviation',
  run: 'run {run} {arrow}',
  measured: 'as measured, run {run} {arrow}',
  mean_up: 'mean ↑',
  mean_down: 'mean ↓',
  mean: 'mean of both',
  limit: 'limit of {symbol}: {value} {unit} in all',
});

export type Way = 'up' | 'down';
export const arrow = (way: Way): string => (way === 'up' ? '↑' : '↓');
export const run_key = (way: Way, run: number): string => `${way}:${run}`;

/** Parts of the chart that a user switches. */
export type Part = 'runs' | 'mean_up' | 'mean_down' | 'mean' | 'bands' | 'uncertainty' | 'limits' | 'measured';

export interface ChartChoice {
  hidden: ReadonlySet<Part>;
  hidden_runs: ReadonlySet<string>;
  limit: Parameter | null;
}

/** U of the means at the targets by one method. */
export interface MeanUncertainties {
  method: 'annex_a' | 'gum';
  too_small: boolean;
  positions: readonly Record<'up' | 'down' | 'mean', { U: number } | null>[];
}

/** By the GUM, else composed of the contributors of Annex A, or by these where Annex A is of record. */
export function position_uncertainties(evaluated: Evaluated): MeanUncertainties | null {
  const { annex_a_budget, gum_budget } = evaluated.result.uncertainty ?? {};
  const whole = (positions: MeanUncertainties['positions'] | undefined) =>
    positions?.length === evaluated.result.positions.length ? positions : null;
  const propagated = whole(gum_budget?.positions), composed = whole(annex_a_budget?.positions);
  if (annex_a_budget && composed && (!propagated || record_method(evaluated) === 'annex_a'))
    return { method: 'annex_a', too_small: annex_a_budget.missing.length > 0, positions: composed };
  return propagated && { method: 'gum', too_small: false, positions: propagated };
}

/** Of both directions together where both were measured, else of the one. */
function mean_way({ result: { positions } }: Evaluated): 'mean' | 'mean_up' | 'mean_down' {
  if (positions.some((p) => p.mean !== null)) return 'mean';
  return positions.some((p) => p.mean_up !== null) ? 'mean_up' : 'mean_down';
}

const of_way = { mean: 'mean', mean_up: 'up', mean_down: 'down' } as const;

/** U of the mean that its band is drawn about, at one target. */
export const mean_uncertainty = (evaluated: Evaluated, target: number): number | null =>
  position_uncertainties(evaluated)?.positions[target]?.[of_way[mean_way(evaluated)]]?.U ?? null;

/** Ranges that a limit bounds in the chart: the lowest and the highest of what the parameter is made of. */
function bounded(positions: readonly PositionResult[], parameter: Parameter): [number, number] | null {
  const ends: number[] = [];
  const take = (mean: number | null, s: number | null) => {
    if (mean === null) return;
    const reach = parameter.startsWith('A') ? s : 0;
    if (reach !== null) ends.push(mean - 2 * reach, mean + 2 * reach);
  };
  for (const position of positions) {
    if (parameter === 'M') take(position.mean, 0);
    else {
      if (!parameter.endsWith('_down')) take(position.mean_up, position.s_up);
      if (!parameter.endsWith('_up')) take(position.mean_down, position.s_down);
    }
  }
  return ends.length === 0 ? null : [Math.min(...ends), Math.max(...ends)];
}

/** Parameters with a limit that can be drawn: those that are a range of deviations. */
export function drawable_limits(evaluated: Evaluated): Parameter[] {
  return evaluated.shown.filter((row) => row.limit !== null && /^[AEM]/.test(row.parameter)).map((row) => row.parameter);
}

export const limit_colour = (verdict: Verdict | null): string =>
  verdict === 'does not conform' ? '--bad' : verdict === 'undecided' ? '--caution' : '--good';

/** A limit bounds a range, not a place: its two lines stand about the middle of that range. */
function limit_lines(evaluated: Evaluated, choice: ChartChoice): ChartLine[] {
  const row = evaluated.shown.find((shown) => shown.parameter === choice.limit);
  const range = choice.limit === null ? null : bounded(evaluated.result.positions, choice.limit);
  if (!row || row.limit === null || range === null) return [];
  const middle = (range[0] + range[1]) / 2;
  const colour = limit_colour(row.verdict);
  const hidden = choice.hidden.has('limits');
  const label = t('limit', { symbol: plain_symbol(row.parameter), value: shortest(row.limit), unit: row.unit });
  return [
    { value: middle + row.limit / 2, colour, label, hidden },
    { value: middle - row.limit / 2, colour, label: '', hidden },
  ];
}

/** Indices of the targets in ascending order, as the chart wants them. */
export function chart_order(evaluated: Evaluated): number[] {
  const { targets } = evaluated.readings;
  return targets.map((_, i) => i).sort((a, b) => (targets[a] as number) - (targets[b] as number));
}

function run_series(evaluated: Evaluated, order: readonly number[], choice: ChartChoice): ChartSeries[] {
  const { readings } = evaluated;
  const made: ChartSeries[] = [];
  const add = (table: (number | null)[][], way: Way, measured: boolean) => {
    for (let run = 0; run < (table[0]?.length ?? 0); run += 1) {
      const values = order.map((i) => table[i]?.[run] ?? null);
      if (values.every((value) => value === null)) continue;
      made.push({
        key: `${measured ? 'measured' : 'run'}:${run_key(way, run)}`, values, colour: `--series-${way}`,
        label: t(measured ? 'measured' : 'run', { run: run + 1, arrow: arrow(way) }),
        width: 1, opacity: measured ? 0.45 : 0.5, shape: measured ? 'ring' : 'circle', size: 3.5,
        ...(measured ? { dash: [1, 3] } : {}),
        hidden: choice.hidden.has(measured ? 'measured' : 'runs') || choice.hidden_runs.has(run_key(way, run)),
      });
    }
  };
  add(readings.up, 'up', false);
  add(readings.down, 'down', false);
  if (readings.as_measured) {
    add(readings.as_measured.up, 'up', true);
    add(readings.as_measured.down, 'down', true);
  }
  return made;
}

function mean_series(positions: readonly PositionResult[], choice: ChartChoice): ChartSeries[] {
  const all: ChartSeries[] = [
    { key: 'mean', label: t('mean'), values: positions.map((p) => p.mean), colour: '--series-mean', width: 1.5, dash: [2, 3], shape: null, hidden: choice.hidden.has('mean') },
    { key: 'mean_up', label: t('mean_up'), values: positions.map((p) => p.mean_up), colour: '--series-up', width: 2, shape: 'up', size: 8, hidden: choice.hidden.has('mean_up') },
    { key: 'mean_down', label: t('mean_down'), values: positions.map((p) => p.mean_down), colour: '--series-down', width: 2, dash: [7, 3], shape: 'down', size: 8, hidden: choice.hidden.has('mean_down') },
  ];
  return all.filter((series) => series.values.some((value) => value !== null));
}

const shifted = (means: Values, reach: Values, sign: 1 | -1): Values =>
  means.map((mean, i) => (mean === null || reach[i] === null || reach[i] === undefined ? null : mean + sign * (reach[i] as number)));

function band(key: string, means: Values, reach: Values, colour: string, opacity: number, hidden: boolean): ChartBand {
  return { key, upper: shifted(means, reach, 1), lower: shifted(means, reach, -1), colour, opacity, hidden };
}

export function chart_model(evaluated: Evaluated, choice: ChartChoice): ChartModel & { order: number[] } {
  const order = chart_order(evaluated);
  const positions = order.map((i) => evaluated.result.positions[i]).filter((p): p is PositionResult => p !== undefined);
  const known = position_uncertainties(evaluated);
  const { kind } = evaluated.result.axis;
  const twice = (s: number | null): number | null => (s === null ? null : 2 * s);
  const bands: ChartBand[] = [
    band('up', positions.map((p) => p.mean_up), positions.map((p) => twice(p.s_up)), '--series-up', 0.13, choice.hidden.has('bands')),
    band('down', positions.map((p) => p.mean_down), positions.map((p) => twice(p.s_down)), '--series-down', 0.13, choice.hidden.has('bands')),
  ];
  const help: ChartSeries[] = [];
  if (known) {
    const way = mean_way(evaluated);
    const means = positions.map((p) => p[way]);
    const reach = order.map((i) => mean_uncertainty(evaluated, i));
    const hidden = choice.hidden.has('uncertainty');
    const made = band('uncertainty', means, reach, '--series-mean', 0.12, hidden);
    bands.push(made);
    const edge = { colour: '--series-mean', width: 1, opacity: 0.5, shape: null, quiet: true, hidden };
    help.push({ key: 'upper', label: '', values: made.upper, ...edge }, { key: 'lower', label: '', values: made.lower, ...edge });
  }
  return {
    order, x: order.map((i) => evaluated.readings.targets[i] as number),
    x_kind: kind === 'rotary' ? 'angle' : 'number', x_label: `${t('position')} / ${position_unit(kind)}`,
    y_label: `${t('deviation')} / ${unit_sign(evaluated.result.unit)}`,
    series: [...run_series(evaluated, order, choice), ...help, ...mean_series(positions, choice)],
    bands, lines: limit_lines(evaluated, choice),
  };
}
