// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { query } from '../../api/client';
import type { TestPage, TestRow } from '../../api/types';
import { use_get } from '../../api/use';
import { day_seconds } from '../../components/dates';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { date_or_none } from '../../components/test_date';
import { figure_line } from './lines';
import { ReasonDialog } from '../test/reason_dialog';
import type { DialogProps } from './dialogs';
import { revise } from './revise';
import { t } from './texts';

/** Links the test that was measured with the table active, or takes the link away. */
export function RetestDialog({ found, on_done, on_close, unlink }: DialogProps & { unlink: boolean }) {
  const [chosen, set_chosen] = useState<number | null>(null);
  const retest = unlink ? null : chosen;
  return (
    <ReasonDialog title={t(unlink ? 'unlink_title' : 'retest_title')} action={t('save', { n: found.version + 1 })} close={on_close} disabled={!unlink && chosen === null}
      act={async (reason) => on_done(await revise(found, { retest, reason }))}>
      {unlink ? <p class="hint">{t('unlink_how')}</p> : <Choice {...{ found, chosen, set_chosen }} />}
    </ReasonDialog>
  );
}

/** Those that were measured on the day of the test or later come first, the nearest of them before the others. */
function ordered(tests: readonly TestRow[], after: string): { later: TestRow[]; others: TestRow[] } {
  const day = (row: TestRow) => day_seconds(row.measured_on) ?? -Infinity;
  const from = day_seconds(after) ?? Infinity;
  const by_day = [...tests].sort((a, b) => (day(a) === day(b) ? a.id - b.id : day(a) - day(b)));
  return { later: by_day.filter((row) => day(row) >= from), others: by_day.filter((row) => day(row) < from).reverse() };
}

function Choice({ found, chosen, set_chosen }: Pick<DialogProps, 'found'> & { chosen: number | null; set_chosen: (id: number) => void }) {
  const [text, set_text] = useState('');
  const page = use_get<TestPage>(`/api/tests${query({ axis: found.axis?.id, text: text.trim(), order: 'measured', limit: 200 })}`);
  const rows = (page.data?.tests ?? []).filter(({ id }) => id !== found.test.id);
  const { later, others } = ordered(rows, found.test.measured_on);
  const list = (title: string, tests: readonly TestRow[]) => tests.length > 0 && (
    <fieldset class="retest-list">
      <legend class="small quiet">{title}</legend>
      {tests.map((row) => (
        <label key={row.id}>
          <input type="radio" name="retest" checked={chosen === row.id} onChange={() => set_chosen(row.id)} />
          <span><span class="number">{date_or_none(row.measured_on)}</span> <strong>{row.title}</strong> <span class="small quiet">{figure_line(row)}</span></span>
        </label>
      ))}
    </fieldset>
  );
  return (
    <div class="stack tight">
      <p class="hint">{t('retest_how')}</p>
      {(rows.length > 8 || text !== '') && (
        <Field label={t('search')}>{(ids) => <input {...ids} type="search" value={text} onInput={(event) => set_text(event.currentTarget.value)} />}</Field>
      )}
      {page.error && <FailureNotice error={page.error} retry={page.reload} />}
      {page.data && rows.length === 0 && <p class="notice">{t(found.axis ? 'no_other_test' : 'no_other_test_at_all')}</p>}
      <div class="retest-lists">
        {list(t('later_tests'), later)}
        {list(t('other_tests'), others)}
      </div>
    </div>
  );
}
