// SPDX-License-Identifier: Apache-2.0
import type { Evaluated, Method, Parameter, Vocabulary } from '../../api/types';
import { Aligned, most_decimals } from '../../components/aligned';
import { ParameterSymbol } from '../../components/symbol';
import { all_methods, coverage_words, method_title, stated_interval } from '../../components/uncertainty';
import { VerdictMark } from '../../components/verdict';
import { texts } from '../../i18n/texts';
import { absent, decimals_of, fixed, shortest } from '../../numbers';
import { main_parameters, replaced_words, shown_of, source_word, tone_of, uncertainty_words, withheld_of, type Shown } from './figures_text';
import { Stored } from './headline';
import { Information } from './information';
import { LimitBar } from './limit_bar';
import { record_method } from './record_choice';
import type { TestState } from './state';

const t = texts({
  title: 'Parameters',
  parameter: 'Parameter',
  name: 'Name',
  value: 'Value',
  limit: 'Limit',
  against: 'Value against limit',
  verdict: 'Verdict',
  no_uncertainty: 'no uncertainty stated',
  interval: ['Interval', 'coverage'],
  of_record: 'of record',
  compared: 'for comparison',
  units: 'Values in {unit}.',
  units_U: 'Values in {unit}. U: expanded uncertainty, about 95 % ({coverage}). Of record is {method}, which decides.',
  units_interval: 'Values in {unit}. Of record is the interval by {method}, which decides.',
});

/** What stands beside the uncertainty of record, and decides nothing. */
const compared_methods = (evaluated: Evaluated): Method[] =>
  all_methods.filter((method) => method !== record_method(evaluated) && !!evaluated.result.uncertainty?.[method]);

/** Of a method that is not of record, with the decimals of its row. */
function compared_text(evaluated: Evaluated, method: Method, parameter: Parameter, decimals: number): string {
  const { annex_a, gum, monte_carlo } = evaluated.result.uncertainty;
  if (method === 'annex_a') return fixed(annex_a?.[parameter], decimals);
  if (method === 'gum') return fixed(gum?.[parameter]?.U, decimals);
  const output = monte_carlo?.[parameter];
  const interval = output ? stated_interval(output) : null;
  return interval ? interval.map((end) => fixed(end, decimals)).join(' … ') : absent;
}

const head_of = (method: Method): string => (method === 'monte_carlo' ? t('interval') : 'U');

function foot_text(evaluated: Evaluated, method: Method | null): string {
  const unit = evaluated.shown[0]?.unit ?? '';
  if (method === null) return t('units', { unit });
  return t(method === 'monte_carlo' ? 'units_interval' : 'units_U', { unit, method: method_title(method), coverage: coverage_words(evaluated, method) });
}

/** All twelve parameters: the uncertainty of record first, what other methods say behind it. */
export function Parameters({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const evaluated = state.evaluated.value;
  const method = record_method(evaluated);
  const others = compared_methods(evaluated);
  const decimals = most_decimals(evaluated.shown.map((row) => row.value));
  const limit_decimals = most_decimals(evaluated.shown.map((row) => shortest(row.limit)));
  const any_limit = evaluated.shown.some((row) => row.limit !== null);
  const rows = others.length > 0 ? 2 : 1;
  return (
    <section class="panel flush parameters-panel">
      <header><h2>{t('title')}</h2>{method === null && others.length === 0 && <span class="small quiet">{t('no_uncertainty')}</span>}</header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
        <table class={`parameters ${any_limit ? 'judged' : ''} ${evaluated.result.uncertainty?.monte_carlo ? 'sampled' : ''}`}>
          <thead>
            <tr>
              <th scope="col" rowSpan={rows}><span class="visually-hidden">{t('parameter')}</span></th>
              <th scope="col" rowSpan={rows} class="name">{t('name')}</th>
              <th scope="col" rowSpan={rows} class="number">{t('value')}</th>
              {method !== null && (
                <th scope="col" rowSpan={rows} class="number of-record">{head_of(method)} <span class="method">{method_title(method)}</span><span class="line">{t('of_record')}</span></th>
              )}
              {any_limit && <th scope="colgroup" colSpan={2} rowSpan={rows}>{t('limit')}</th>}
              {any_limit && <th scope="col" rowSpan={rows}><span class="visually-hidden">{t('verdict')}</span></th>}
              {any_limit && <th scope="col" rowSpan={rows} class="bar-cell"><span class="visually-hidden">{t('against')}</span></th>}
              {others.length > 0 && <th scope="colgroup" colSpan={others.length} class="compared">{t('compared')}</th>}
            </tr>
            {others.length > 0 && (
              <tr>{others.map((one) => <th key={one} scope="col" class="number compared">{head_of(one)} <span class="method">{method_title(one)}</span></th>)}</tr>
            )}
          </thead>
          <tbody>
            {evaluated.shown.map((row) => (
              <Row key={row.parameter} row={row} kept={shown_of(state.test.value, row.parameter)} evaluated={evaluated} method={method} others={others}
                   column={decimals} limit_column={limit_decimals} any_limit={any_limit} title={vocabulary?.parameters.find((p) => p.key === row.parameter)?.title ?? ''} />
            ))}
          </tbody>
        </table>
      </div>
      <p class="small quiet foot">{foot_text(evaluated, method)}</p>
      <Information evaluated={evaluated} />
    </section>
  );
}

function Row({ row, kept, evaluated, method, others, column, limit_column, any_limit, title }: {
  row: Shown; kept: Shown | undefined; evaluated: Evaluated; method: Method | null; others: readonly Method[]; any_limit: boolean; title: string;
  column: number; limit_column: number;   // decimals of what stands above and below
}) {
  const value = evaluated.result.parameters[row.parameter];
  const decimals = decimals_of(row.value);
  const stated = row.U !== '' ? <Aligned text={row.U} decimals={column} /> : row.interval !== '' ? row.interval : absent;
  return (
    <tr class={main_parameters(evaluated.result).includes(row.parameter) ? 'main' : ''}>
      <th scope="row" title={title}><ParameterSymbol parameter={row.parameter} /></th>
      <td class="name">{title}</td>
      <td class="number"><Stored now={row} kept={kept} /> {value === null ? absent : <Aligned text={row.value} decimals={column} />}</td>
      {method !== null && <td class="number of-record" title={uncertainty_words(row) === '' ? undefined : method_title(method)}>{stated}</td>}
      {any_limit && <Limit row={row} decimals={limit_column} />}
      {any_limit && <td class="verdict-cell" title={withheld_of(evaluated, row) ?? undefined}>{row.limit !== null && <VerdictMark verdict={row.verdict} short />}</td>}
      {any_limit && (
        <td class="bar-cell">
          {row.limit !== null && value !== null && <LimitBar value={value} low={row.low} high={row.high} limit={row.limit} tone={tone_of(row.verdict)} />}
        </td>
      )}
      {others.map((one) => <td key={one} class="number compared"><Aligned text={compared_text(evaluated, one, row.parameter, decimals)} decimals={one === 'monte_carlo' ? 0 : column} /></td>)}
    </tr>
  );
}

/** A limit, who stated it, and which it has taken the place of. */
function Limit({ row, decimals }: { row: Shown; decimals: number }) {
  if (row.limit === null) return <><td /><td /></>;
  const replaced = replaced_words(row);
  return (
    <>
      <td class="number limit-cell"><Aligned text={shortest(row.limit)} decimals={decimals} /></td>
      <td class="origin small quiet" title={replaced === '' ? undefined : replaced}>
        {row.source !== null && source_word(row.source)}{replaced !== '' && <span class="replaced">{replaced}</span>}
      </td>
    </>
  );
}
