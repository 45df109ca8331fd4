// SPDX-License-Identifier: Apache-2.0
import type { Vocabulary } from '../../api/types';
import { ParameterSymbol } from '../../components/symbol';
import { method_title } from '../../components/uncertainty';
import { VerdictMark } from '../../components/verdict';
import { texts } from '../../i18n/texts';
import { shortest } from '../../numbers';
import { main_parameters, replaced_words, shown_of, source_word, tone_of, uncertainty_words, withheld_of, type Shown } from './figures_text';
import { LimitBar } from './limit_bar';
import { RecordLine } from './record_choice';
import type { TestState } from './state';
import { Withheld } from './withheld';

const t = texts({
  glance: 'At a glance',
  kept: ['kept', 'archive'],
  of_limit: 'limit {limit}',
  not_decided: 'an effect is not corrected',
  A: 'positioning error',
  E: 'systematic error',
  R: 'repeatability',
  B: 'reversal error',
  M: 'mean error',
});

/** What the kept version says, where the draft says something else. */
export function Stored({ now, kept }: { now: Shown; kept: Shown | undefined }) {
  if (kept === undefined || (kept.value === now.value && uncertainty_words(kept) === uncertainty_words(now) && kept.method === now.method)) return null;
  const method = kept.method !== null && kept.method !== now.method ? ` (${method_title(kept.method)})` : '';
  return <span class="was small number">{t('kept')} {kept.value} {uncertainty_words(kept)}{method}</span>;
}

type Letter = 'A' | 'E' | 'R' | 'B' | 'M';

/** The five figures that say how the axis is, large, each with the uncertainty of record, which decides. */
export function Headline({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const evaluated = state.evaluated.value;
  const main = main_parameters(evaluated.result);
  // Bars without a limit stand on one scale, so that they can be compared with each other.
  const reach = Math.max(...main.map((parameter) => {
    const row = shown_of(evaluated, parameter);
    return Math.max(Math.abs(evaluated.result.parameters[parameter] ?? 0), Math.abs(row?.low ?? 0), Math.abs(row?.high ?? 0));
  }));
  return (
    <section class="panel glances" aria-label={t('glance')}>
      <div class="headline">
        {main.map((parameter) => {
          const row = shown_of(evaluated, parameter);
          const value = evaluated.result.parameters[parameter];
          if (row === undefined || value === null) return null;
          return <Glance key={parameter} row={row} withheld={withheld_of(evaluated, row)} value={value} kept={shown_of(state.test.value, parameter)} reach={reach}
                         title={vocabulary?.parameters.find((one) => one.key === parameter)?.title} />;
        })}
      </div>
      <Withheld state={state} vocabulary={vocabulary} />
      <RecordLine state={state} vocabulary={vocabulary} />
    </section>
  );
}

function Glance({ row, withheld, value, kept, reach, title }: {
  row: Shown; withheld: string | null; value: number; kept: Shown | undefined; reach: number; title: string | undefined;
}) {
  const limited = row.limit !== null;
  const replaced = replaced_words(row);
  const unit = <span class="quiet"> {row.unit}</span>;
  return (
    <div class={`glance ${limited ? tone_of(row.verdict) : ''}`}>
      <div class="row spread">
        <span class="glance-symbol"><ParameterSymbol parameter={row.parameter} /></span>
        {limited && <VerdictMark verdict={row.verdict} short={withheld === null} />}
      </div>
      <div class="small quiet" title={title}>{t(row.parameter.charAt(0) as Letter)}</div>
      <div class="number figure">
        <span><span class="glance-value">{row.value}</span>{row.U === '' && unit}</span>{' '}
        {row.U !== '' && <span><span class="glance-u">± {row.U}</span>{unit}</span>}
        {row.U === '' && row.interval !== '' && <span class="glance-interval">({row.interval})</span>}
      </div>
      {row.method !== null && <div class="small quiet method">{method_title(row.method)}</div>}
      <LimitBar value={value} low={row.low} high={row.high} limit={row.limit} tone={tone_of(row.verdict)} reach={reach} />
      <div class="small quiet number below">
        {row.limit !== null && (
          <span class="glance-limit" title={replaced === '' ? undefined : replaced}>
            {t('of_limit', { limit: shortest(row.limit) })}{row.source !== null && ` (${source_word(row.source)})`}
          </span>
        )}{' '}
        <Stored now={row} kept={kept} />
      </div>
      {withheld !== null && <div class="small withheld" title={withheld}>{t('not_decided')}</div>}
    </div>
  );
}
