// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import type { CompensationResult, CompensationTest, KeptCompensation, Parameter, ParameterNumbers, Shown } from '../../api/types';
import { ParameterSymbol } from '../../components/symbol';
import { date_or_none } from '../../components/test_date';
import { fixed, unit_sign, when } from '../../numbers';
import { decimals_in } from './figures';
import { shown_parameters } from './result';
import { StandingTags } from './standing';
import { t } from './texts';

interface Props { found: KeptCompensation; result: CompensationResult; shown: readonly Shown[]; is_fixed: boolean; choose: () => void; unlink: () => void }

/** What a step is known by: A and E as far as there are. */
const headline = (values: ParameterNumbers): Parameter[] => shown_parameters(values).filter((parameter) => /^[AE]/.test(parameter));

/** Measured, corrected, measured again: each with its date, its figures and the way to it. */
export function Chain({ found, result, shown, is_fixed, choose, unlink }: Props) {
  const values = (of: ParameterNumbers, most?: ParameterNumbers): ComponentChildren => (
    <ul class="step-figures">
      {headline(result.before).map((parameter) => {
        const decimals = decimals_in(result.before, parameter, shown);
        return (
          <li key={parameter} class="number">
            <ParameterSymbol parameter={parameter} /> <strong>{fixed(of[parameter], decimals)}</strong> {unit_sign(result.unit)}
            {typeof most?.[parameter] === 'number' && <span class="small quiet"> {t('or_less', { value: fixed(most[parameter], decimals) })}</span>}
          </li>
        );
      })}
    </ul>
  );
  return (
    <ol class="compensation-chain" aria-label={t('chain')}>
      <li class="panel">
        <h2>{t('step_measured')}</h2>
        <TestLine test={found.test} />
        {values(result.before)}
      </li>
      <li class="panel">
        <h2>{t('step_table')}</h2>
        <p><a href={`/api/compensations/${found.id}/files/table`} download={found.file_name} class="file-name">{found.file_name}</a> <span class="quiet number">{when(found.made_at)}</span></p>
        {values(result.predicted, result.expected_retest?.percent_95)}
        <p class="small quiet">{t('step_predicted')}</p>
      </li>
      <li class={`panel ${found.retest ? '' : 'open-step'}`}>
        <h2>{t('step_retest')}</h2>
        {found.retest ? (
          <>
            <TestLine test={found.retest} />
            {result.retest ? values(result.retest.parameters) : <p class="quiet">{t('counts_not')}</p>}
            {typeof result.retest?.share === 'number' && typeof result.retest.u === 'number' && (
              <p class="small quiet">{t('share', { share: fixed(100 * result.retest.share, 0), u: fixed(200 * result.retest.u, 0) })}</p>
            )}
          </>
        ) : <p class="quiet">{t('no_retest')}</p>}
        <div class="row no-print">
          <button type="button" class={found.retest ? 'small' : 'primary'} disabled={is_fixed} onClick={choose}>{t(found.retest ? 'other_retest' : 'choose_retest')}</button>
          {found.retest && <button type="button" class="small" disabled={is_fixed} onClick={unlink}>{t('unlink')}</button>}
        </div>
      </li>
    </ol>
  );
}

function TestLine({ test }: { test: CompensationTest }) {
  return <p><a href={`/tests/${test.id}?version=${test.version}`}>{test.title}</a> <span class="quiet number">{date_or_none(test.measured_on)}</span><StandingTags test={test} /></p>;
}
