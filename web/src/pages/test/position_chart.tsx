// SPDX-License-Identifier: Apache-2.0
import { useMemo, useState } from 'preact/hooks';
import type { Evaluated, Parameter } from '../../api/types';
import { Chart, ChartLegend, type ChartPlace } from '../../components/chart/chart';
import { texts } from '../../i18n/texts';
import { fixed, position_unit, shortest, unit_sign } from '../../numbers';
import { decimal, language } from '../../settings';
import { arrow, chart_model, drawable_limits, limit_colour, mean_uncertainty, position_uncertainties, run_key, type Part, type Way } from './chart_model';
import { plain_symbol, position_decimals, type Quantity } from './figures_text';
import { record_method } from './record_choice';
import type { TestState } from './state';
import { colon } from '../../i18n/colon';

const t = texts({
  title: 'Deviations',
  name: 'Deviations over position: single runs, means, bands and limits',
  legend: 'What the chart shows',
  runs: 'single readings',
  mean_up: 'x̄↑',
  mean_down: 'x̄↓',
  mean: 'x̄',
  bands: 'x̄ ± 2s',
  uncertainty: 'x̄ ± U (GUM)',
  compared: 'x̄ ± U (GUM, for comparison)',
  composed: 'x̄ ± U (contributors of Annex A)',
  composed_compared: 'x̄ ± U (contributors of Annex A, for comparison)',
  composed_small: 'x̄ ± U (contributors of Annex A, too small: not all given)',
  limits: 'limit',
  measured: 'as measured',
  of: 'limit of',
  broken: 'Limit not kept, not drawn here: {symbols}',
  each_run: 'Runs',
  all_runs: 'all',
  one_run: 'Run {run} {arrow}',
  target: 'Target {target} {unit}',
  run_here: 'run {run} {arrow} {value}',
  spoken: '{target}: mean up {up}, mean down {down}, reversal {reversal} {unit}',
});

const looks = {
  runs: { colour: '--series-mean', width: 1, shape: 'circle' },
  mean_up: { colour: '--series-up', width: 2, shape: 'up' },
  mean_down: { colour: '--series-down', width: 2, dash: [5, 2], shape: 'down' },
  mean: { colour: '--series-mean', width: 1.5, dash: [2, 3], shape: null },
  bands: { colour: '--series-up', shape: null, area: ['--series-up', '--series-down'] },
  uncertainty: { colour: '--series-mean', shape: null, area: ['--series-mean'] },
  limits: { colour: '--good', width: 1.5, dash: [5, 3], shape: null },
  measured: { colour: '--series-mean', width: 1, dash: [1, 3], shape: 'ring' },
} as const;

function present_parts(evaluated: Evaluated, limits: readonly Parameter[]): Part[] {
  const { positions } = evaluated.result;
  const some = (key: 'mean_up' | 'mean_down' | 'mean' | 's_up' | 's_down') => positions.some((p) => p[key] !== null);
  const parts: [Part, boolean][] = [
    ['runs', true], ['mean_up', some('mean_up')], ['mean_down', some('mean_down')], ['mean', some('mean')],
    ['bands', some('s_up') || some('s_down')], ['uncertainty', position_uncertainties(evaluated) !== null],
    ['limits', limits.length > 0], ['measured', evaluated.readings.as_measured !== null],
  ];
  return parts.filter(([, there]) => there).map(([part]) => part);
}

/** Whose U it is, and whether it is that of record. */
function uncertainty_label(evaluated: Evaluated) {
  const known = position_uncertainties(evaluated);
  const of_record = record_method(evaluated) === known?.method;
  if (known?.method !== 'annex_a') return of_record ? 'uncertainty' : 'compared';
  if (known.too_small) return 'composed_small';
  return of_record ? 'composed' : 'composed_compared';
}

function toggled<T>(set: ReadonlySet<T>, item: T): Set<T> {
  const next = new Set(set);
  if (!next.delete(item)) next.add(item);
  return next;
}

const fails = (evaluated: Evaluated, parameter: Parameter): boolean =>
  evaluated.shown.some((row) => row.parameter === parameter && row.verdict === 'does not conform');

/** The readings and what the standard makes of them; cursor and rows of the table are one. */
export function PositionChart({ state, height }: { state: TestState; height: number }) {
  const evaluated = state.evaluated.value;
  const [hidden, set_hidden] = useState<ReadonlySet<Part>>(new Set<Part>(['uncertainty', 'measured']));
  const [hidden_runs, set_hidden_runs] = useState<ReadonlySet<string>>(new Set<string>());
  const [wanted_limit, set_limit] = useState<Parameter | null>(null);
  const limits = drawable_limits(evaluated);
  const limit = wanted_limit !== null && limits.includes(wanted_limit) ? wanted_limit : (limits.find((one) => fails(evaluated, one)) ?? limits[0] ?? null);
  const broken = evaluated.shown.map((row) => row.parameter).filter((one) => fails(evaluated, one) && !limits.includes(one));
  const { readings, result } = evaluated;
  const judged = evaluated.shown.find((row) => row.parameter === limit);
  // Drawn again only for what is in the picture: most edits change uncertainties alone.
  const model = useMemo(() => chart_model(evaluated, { hidden, hidden_runs, limit }),
                        [readings, result.positions, result.axis, position_uncertainties(evaluated)?.positions, judged?.limit, judged?.verdict,
                         hidden, hidden_runs, limit, language.value, decimal.value]);
  const here = state.target.value;
  return (
    <section class="panel chart-panel">
      <header>
        <h2>{t('title')}</h2>
        <div class="row no-print">
          <ChartLegend label={t('legend')} on_toggle={(key) => set_hidden(toggled(hidden, key as Part))}
            items={present_parts(evaluated, limits).map((part) => ({ key: part, label: t(part === 'uncertainty' ? uncertainty_label(evaluated) : part), look: part === 'limits' ? { ...looks.limits, colour: limit_colour(judged?.verdict ?? null) } : looks[part], shown: !hidden.has(part) }))} />
          {limits.length > 1 && (
            <label class="small">{t('of')}
              <select value={limit ?? ''} onChange={(event) => set_limit(event.currentTarget.value as Parameter)}>
                {limits.map((parameter) => <option key={parameter} value={parameter}>{plain_symbol(parameter)}</option>)}
              </select>
            </label>
          )}
        </div>
      </header>
      {broken.length > 0 && <p class="small broken">{t('broken', { symbols: broken.map(plain_symbol).join(', ') })}</p>}
      <Chart {...model} name={t('name')} height={height} cursor={here === null ? null : model.order.indexOf(here)}
        on_cursor={(place) => { state.target.value = place === null ? null : (model.order[place.index] ?? null); }}
        tip={(place) => <Tip evaluated={evaluated} model={model} place={place} with_U={!hidden.has('uncertainty')} />}
        spoken={(place) => spoken(evaluated, model, place)} />
      <RunChips evaluated={evaluated} hidden={hidden_runs} set_hidden={set_hidden_runs} />
    </section>
  );
}

/** Single runs on and off, one button each. */
function RunChips({ evaluated, hidden, set_hidden }: {
  evaluated: Evaluated; hidden: ReadonlySet<string>; set_hidden: (hidden: ReadonlySet<string>) => void;
}) {
  const { readings } = evaluated;
  const rows = (['up', 'down'] as Way[]).filter((way) => readings[way].some((row) => row.some((value) => value !== null)));
  return (
    <div class="run-chips no-print" role="group" aria-label={t('each_run')}>
      <span class="small quiet">{t('each_run')}</span>
      {rows.map((way) => (
        <span key={way} class={`chip-row ${way}`}>
          <span aria-hidden="true">{arrow(way)}</span>
          {(readings[way][0] ?? []).map((_, run) => (
            <button key={run} type="button" aria-pressed={!hidden.has(run_key(way, run))} aria-label={t('one_run', { run: run + 1, arrow: arrow(way) })}
                    onClick={() => set_hidden(toggled(hidden, run_key(way, run)))}>{run + 1}</button>
          ))}
        </span>
      ))}
      {hidden.size > 0 && <button type="button" class="plain small" onClick={() => set_hidden(new Set())}>{t('all_runs')}</button>}
    </div>
  );
}

type Model = ReturnType<typeof chart_model>;

/** "run 3 ↑ −1.58" of the series that the pointer is at, where it is a single reading. */
function reading_here(model: Model, place: ChartPlace): string | null {
  const series = place.series === null ? undefined : model.series[place.series];
  const value = series?.values[place.index];
  return series === undefined || typeof value !== 'number' || series.key.startsWith('mean_') || series.key === 'mean' ? null
    : `${series.label}${colon()} ${fixed(value, 2)}`;
}

const told: readonly (readonly [string, Quantity])[] = [
  ['x̄↑', 'mean_up'], ['x̄↓', 'mean_down'], ['x̄', 'mean'], ['B', 'reversal'], ['s↑', 's_up'], ['s↓', 's_down'],
];

function Tip({ evaluated, model, place, with_U }: { evaluated: Evaluated; model: Model; place: ChartPlace; with_U: boolean }) {
  const position = evaluated.result.positions[model.order[place.index] ?? -1];
  if (!position) return null;
  const unit = unit_sign(evaluated.result.unit);
  const rows = told.map(([symbol, quantity]): [string, number | null, number] => [symbol, position[quantity], position_decimals(evaluated, quantity)]);
  const U = with_U ? mean_uncertainty(evaluated, model.order[place.index] ?? -1) : null;
  if (U !== null) rows.push(['U(x̄)', U, position_decimals(evaluated, 'mean')]);
  const reading = reading_here(model, place);
  return (
    <>
      <div class="head">{t('target', { target: shortest(position.target), unit: position_unit(evaluated.result.axis.kind) })}</div>
      {reading !== null && <div class="number"><strong>{reading} {unit}</strong></div>}
      <table><tbody>
        {rows.filter(([, value]) => value !== null).map(([symbol, value, decimals]) => (
          <tr key={symbol}><td>{symbol}</td><td class="number">{fixed(value, decimals)} {unit}</td></tr>
        ))}
      </tbody></table>
    </>
  );
}

function spoken(evaluated: Evaluated, model: Model, place: ChartPlace): string {
  const position = evaluated.result.positions[model.order[place.index] ?? -1];
  if (!position) return '';
  const target = t('target', { target: shortest(position.target), unit: position_unit(evaluated.result.axis.kind) });
  const reading = reading_here(model, place);
  if (reading !== null) return `${target}${colon()} ${reading}`;
  const number = (quantity: Quantity) => fixed(position[quantity], position_decimals(evaluated, quantity));
  return t('spoken', {
    target, up: number('mean_up'), down: number('mean_down'), reversal: number('reversal'),
    unit: unit_sign(evaluated.result.unit),
  });
}
