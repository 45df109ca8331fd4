// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import type { Evaluated, Method, Parameter } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Formula } from '../../components/formula';
import { all_methods, method_title } from '../../components/uncertainty';
import { texts } from '../../i18n/texts';
import { decimals_of, fixed, shortest } from '../../numbers';
import { Bars, type Bar } from './bars';
import { distribution_words } from './distribution_words';
import { all_parameters, plain_symbol, shown_of } from './figures_text';
import { Histogram } from './histogram';
import { record_method } from './record_choice';
import { ResolvedInputs } from './resolved_inputs';
import type { TestState } from './state';
import { colon } from '../../i18n/colon';

const t = texts({
  title: 'Uncertainty budget',
  method: 'Method',
  of: 'Budget of',
  contributor: 'Contributor',
  input: 'Input',
  expanded: 'U / {unit}',
  standard: '|c| u / {unit}',
  share: 'Share of u²',
  nothing: 'No uncertainty can be stated: nothing was given of the measuring device, the temperatures or the alignment.',
  give: 'Give the inputs',
  improve: 'Improve first: {title}. Without it U({symbol}) would be {less} instead of {now} {unit}.',
  improve_annex: 'The largest contribution: {title}, {value} {unit}.',
  not_acting: 'Not given or not acting:',
  notes: ['Notes', 'findings'],
  stale: 'Without the unsaved changes: Monte Carlo has not been run for them.',
  run: 'Run Monte Carlo',
  compared: 'For comparison: of record is {method}.',
  running: 'Drawing trials …',
});

const existing = (evaluated: Evaluated): Method[] =>
  all_methods.filter((method) => !!evaluated.result.uncertainty?.[method]);

/** Where the uncertainty comes from, and what to improve first. */
export function Budget({ state }: { state: TestState }) {
  const evaluated = state.evaluated.value;
  const methods = existing(evaluated);
  const record = record_method(evaluated);
  const [wanted, set_wanted] = useState<Method | null>(null);
  const [parameter, set_parameter] = useState<Parameter>('A');
  const method = [wanted, record].find((one) => one !== null && methods.includes(one)) ?? methods[0];
  const present = all_parameters.filter((one) => typeof evaluated.result.parameters[one] === 'number');
  const shown = present.includes(parameter) ? parameter : present[0];
  return (
    <section class="panel budget-panel">
      <header>
        <h2>{t('title')}</h2>
        {methods.length > 0 && (
          <div class="row no-print">
            <div class="segments" role="group" aria-label={t('method')}>
              {methods.map((one) => (
                <button key={one} type="button" class="small" aria-pressed={one === method} onClick={() => set_wanted(one)}>{method_title(one)}</button>
              ))}
            </div>
            {method !== 'annex_a' && (
              <label class="small">{t('of')}
                <select value={shown} onChange={(event) => set_parameter(event.currentTarget.value as Parameter)}>
                  {present.map((one) => <option key={one} value={one}>{plain_symbol(one)}</option>)}
                </select>
              </label>
            )}
          </div>
        )}
      </header>
      {record !== null && method !== undefined && method !== record && <p class="small quiet">{t('compared', { method: method_title(record) })}</p>}
      {methods.length === 0 && <Nothing state={state} />}
      {method === 'annex_a' && <AnnexA evaluated={evaluated} />}
      {method === 'gum' && shown && <Gum evaluated={evaluated} parameter={shown} />}
      {method === 'monte_carlo' && shown && <MonteCarlo evaluated={evaluated} parameter={shown} />}
      <ResolvedInputs inputs={evaluated.result.uncertainty?.inputs} />
      <Sampling state={state} />
    </section>
  );
}

function Nothing({ state }: { state: TestState }) {
  const editable = state.test.value.version === state.test.value.latest;
  return (
    <>
      <p>{t('nothing')}</p>
      {editable && <button type="button" class="no-print" onClick={() => state.edit('uncertainty.device_calibration_um_per_m')}>{t('give')}</button>}
    </>
  );
}

/** Monte Carlo takes seconds and runs only when asked. */
function Sampling({ state }: { state: TestState }) {
  const running = state.busy.value === 'sampling';
  if (!state.lacks_sampling.value && !running) return null;
  return (
    <div class="row no-print sampling">
      <button type="button" disabled={running} onClick={() => state.run_monte_carlo()}>{running ? t('running') : t('run')}</button>
      <span class="small quiet">{t('stale')}</span>
      {state.failure.value && <FailureNotice error={state.failure.value} />}
    </div>
  );
}

function Notes({ notes }: { notes: readonly string[] }) {
  if (notes.length === 0) return null;
  return <details class="small"><summary>{t('notes')}</summary><ul>{notes.map((note) => <li key={note}>{note}</li>)}</ul></details>;
}

const unit_of = (evaluated: Evaluated): string => evaluated.shown[0]?.unit ?? '';
const by_size = (a: Bar, b: Bar): number => (b.size ?? 0) - (a.size ?? 0);

function AnnexA({ evaluated }: { evaluated: Evaluated }) {
  const budget = evaluated.result.uncertainty?.annex_a_budget;
  if (!budget) return null;
  const bars = budget.contributors.map((one): Bar => ({
    key: one.key, title: one.title, size: one.U, value: fixed(one.U, 2), share: null,
    detail: <Formula text={`${one.symbol} (${one.formula})${colon()} ${one.inputs.map((input) => `${input.symbol} = ${shortest(input.value, 6)} ${input.unit}`.trim()).join(', ')}`} />,
  })).sort(by_size);
  const first = bars[0];
  return (
    <>
      <Bars absent={t('not_acting')} head={{ what: t('contributor'), value: t('expanded', { unit: unit_of(evaluated) }), share: null }} bars={bars} />
      {first?.size ? <p class="improve">{t('improve_annex', { title: first.title, value: first.value, unit: unit_of(evaluated) })}</p> : null}
      <Notes notes={budget.notes} />
    </>
  );
}

/** Contributions to one parameter as bars with their shares of the sum of squares. */
function contribution_bars(rows: readonly { key: string; title: string; detail: ComponentChildren; u: number | null }[]): Bar[] {
  const sum = rows.reduce((total, row) => total + (row.u ?? 0) ** 2, 0);
  return rows.map((row): Bar => ({
    key: row.key, title: row.title, detail: row.detail, size: row.u, value: fixed(row.u, 3),
    share: sum > 0 && row.u !== null ? `${fixed((100 * row.u ** 2) / sum, 0)} %` : '',
  })).sort(by_size);
}

function Gum({ evaluated, parameter }: { evaluated: Evaluated; parameter: Parameter }) {
  const uncertainty = evaluated.result.uncertainty;
  const budget = uncertainty?.gum_budget;
  if (!budget) return null;
  const of_key = new Map(budget.contributions.map((row) => [row.key, row.u[parameter]]));
  const bars = contribution_bars(budget.sources.map((source) => ({
    key: source.key, title: source.title, u: of_key.get(source.key) ?? null,
    detail: <Formula text={[source.symbol, `u = ${shortest(source.u, 5)} ${source.unit}`.trim(), distribution_words(source.distribution), source.source && `(${source.source})`]
      .filter((part) => part).join(' · ')} />,
  })));
  const total = uncertainty?.gum?.[parameter];
  const decimals = decimals_of(shown_of(evaluated, parameter)?.value ?? '');
  const first = bars[0];
  const less = total && first?.size ? total.k * Math.sqrt(Math.max(0, total.u ** 2 - first.size ** 2)) : null;
  return (
    <>
      <Bars absent={t('not_acting')} head={{ what: t('input'), value: t('standard', { unit: unit_of(evaluated) }), share: t('share') }} bars={bars} />
      {total && first && less !== null && (
        <p class="improve">{t('improve', { title: first.title, symbol: plain_symbol(parameter), less: fixed(less, decimals), now: fixed(total.U, decimals), unit: unit_of(evaluated) })}</p>
      )}
      <Notes notes={budget.notes} />
    </>
  );
}

function MonteCarlo({ evaluated, parameter }: { evaluated: Evaluated; parameter: Parameter }) {
  const uncertainty = evaluated.result.uncertainty;
  const output = uncertainty?.monte_carlo?.[parameter];
  const run = uncertainty?.monte_carlo_run;
  if (!output) return null;
  const bars = contribution_bars((run?.contributions ?? []).map((row) => ({ key: row.key, title: row.title, detail: '', u: row.u[parameter] })));
  return (
    <>
      <Histogram output={output} run={run ?? null} decimals={decimals_of(shown_of(evaluated, parameter)?.value ?? '')} unit={unit_of(evaluated)} symbol={plain_symbol(parameter)} />
      {bars.length > 0 && <Bars absent={t('not_acting')} head={{ what: t('input'), value: t('standard', { unit: unit_of(evaluated) }), share: t('share') }} bars={bars} />}
      <Notes notes={run?.notes ?? []} />
    </>
  );
}
