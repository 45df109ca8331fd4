// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { query, send } from '../../api/client';
import type { Claim, Test } from '../../api/types';
import { test_date } from '../../components/test_date';
import { Mark, VerdictMark } from '../../components/verdict';
import { Withdrawn } from '../../components/withdrawn';
import { texts } from '../../i18n/texts';
import { bytes } from '../../numbers';
import { ReasonDialog } from './reason_dialog';
import { test_path, type TestState } from './state';

const t = texts({
  machine: 'Machine',
  axis: 'Axis',
  date: 'Date',
  standard: 'Standard',
  file: 'File',
  instruments: 'Instruments',
  on_the_word: 'on the word of who tested',
  simulated: 'simulated',
  not_claimed: 'not claimed: {title}',
  not_a_result: 'not a result of this standard',
  report: 'Report',
  compare: 'Compare',
  correct: 'Correct the axis',
  rules: 'By other rules',
  periodic: 'Periodic error',
  raw: 'Raw file',
  edit: 'Edit',
  close: 'Close the editor',
  withdraw: 'Withdraw',
  reinstate: 'Reinstate',
  withdraw_title: 'Withdraw this test',
  withdraw_text: 'It stays in the archive with all its data, but no longer counts in lists and trends.',
  reinstate_title: 'Reinstate this test',
  reinstate_text: 'It counts again in lists and trends.',
  set_limits: 'Set tolerances',
  due: 'calibration due {date}',
  unnamed: 'not named',
});

function Fact({ label, children }: { label: string; children: ComponentChildren }) {
  return <div><dt>{label}</dt><dd>{children}</dd></div>;
}

function Facts({ state }: { state: TestState }) {
  const test = state.test.value;
  const result = state.evaluated.value.result;
  return (
    <dl class="test-facts">
      <Fact label={t('machine')}>{test.machine ? <a href={`/machines/${test.machine.id}`}>{test.machine.name || t('unnamed')}</a> : t('unnamed')}</Fact>
      <Fact label={t('axis')}>{test.axis ? <a href={`/axes/${test.axis.id}`}>{test.axis.name || t('unnamed')}</a> : result.axis.name || t('unnamed')}</Fact>
      <Fact label={t('date')}>{test_date(test)}</Fact>
      <Fact label={t('standard')}>
        {result.standard}{' '}
        {result.claims ? <Claimed claims={result.claims} /> : !result.conforming && <span class="mark bad">{t('not_a_result')}</span>}
        {result.label && <span class="label-words">{!result.claims && result.conforming ? '' : ' – '}{result.label}</span>}
      </Fact>
      {test.instruments.length > 0 && (
        <Fact label={t('instruments')}>
          {test.instruments.map((instrument, i) => (
            <span key={instrument.id}>{i > 0 && ', '}
              <a href={`/instruments/${instrument.id}`} title={instrument.calibration_due ? t('due', { date: instrument.calibration_due }) : undefined}>{instrument.name}</a>
            </span>
          ))}
        </Fact>
      )}
      <Fact label={t('file')}>
        <span class="file-name">{test.file.name}{test.file.name_in_file !== '' && ` · ${test.file.name_in_file}`}</span>{' '}
        <span class="quiet number">{bytes(test.file.size)} · <span class="mono" title={`SHA-256 ${test.file.sha256}`}>{test.file.sha256.slice(0, 8)}</span></span>
      </Fact>
    </dl>
  );
}

/** Whether the test was made as the standard wants it; all that may be claimed stands with the findings. */
function Claimed({ claims }: { claims: readonly Claim[] }) {
  const tested = claims.find(({ key }) => key === 'tested');
  if (!tested) return null;
  const said = tested.holds && tested.remark !== undefined && <span class="small quiet"> {t('on_the_word')}</span>;
  return <span class="claimed"><Mark tone={tested.holds ? 'good' : 'caution'} word={tested.holds ? tested.title : t('not_claimed', { title: tested.title })} />{said}</span>;
}

/** The verdict; where there is none to be had, the way to the limits that would give one. */
function Judgement({ state }: { state: TestState }) {
  const { verdict, shown } = state.evaluated.value;
  const mark = <VerdictMark verdict={verdict} />;
  const first = shown[0]?.parameter;
  if (verdict !== null || first === undefined || state.test.value.version !== state.test.value.latest) return mark;
  return <button type="button" class="set-limits" title={t('set_limits')} onClick={() => state.edit(`tolerance.${first}`)}>{mark}</button>;
}

/** What test this is, and what can be done with it. */
export function Head({ state }: { state: TestState }) {
  const test = state.test.value;
  const [asking, set_asking] = useState(false);
  const version = test.version === test.latest ? null : test.version;
  const is_line = (test.result.metadata.axis?.line_direction ?? []).filter((part) => part !== 0).length > 1;  // other rules know no diagonals
  const turn = test.withdrawn ? 'reinstate' : 'withdraw';
  return (
    <header class="test-head">
      <div class="row spread">
        <div class="row title-row">
          <h1 tabIndex={-1}>{test.title}</h1>
          <Judgement state={state} />
          <Withdrawn test={test} />
          {test.result.metadata.test?.purpose?.toLowerCase() === 'simulation' && <span class="mark caution">{t('simulated')}</span>}
        </div>
        <div class="row no-print">
          <button type="button" aria-expanded={state.editing.value} aria-controls="edit-panel" disabled={version !== null}
                  onClick={() => (state.editing.value ? (state.editing.value = false) : state.edit())}>
            {state.editing.value ? t('close') : t('edit')}
          </button>
          <a class="button primary" href={`/tests/${test.id}/report${query({ version })}`}>{t('report')}</a>
          <a class="button" href={`/compare?tests=${test.id}`}>{t('compare')}</a>
          <a class="button" href={`/tests/${test.id}/table${query({ version })}`}>{t('correct')}</a>
          {!is_line && <a class="button" href={`/tests/${test.id}/rules${query({ version })}`}>{t('rules')}</a>}
          <a class="button" href={`/tests/${test.id}/periodic${query({ version })}`}>{t('periodic')}</a>
          <a class="button" href={`/api/tests/${test.id}/raw`} download={test.file.name}>{t('raw')}</a>
          <button type="button" onClick={() => set_asking(true)}>{t(turn)}</button>
        </div>
      </div>
      <Facts state={state} />
      {asking && (
        <ReasonDialog title={t(`${turn}_title`)} action={t(turn)} close={() => set_asking(false)}
          act={async (reason) => state.refresh(await send<Test>('POST', test_path(test.id, `/${turn}`), { reason }))}>
          <p>{t(`${turn}_text`)}</p>
        </ReasonDialog>
      )}
    </header>
  );
}
