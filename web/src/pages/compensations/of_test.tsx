// SPDX-License-Identifier: Apache-2.0
import type { CompensationHead, CompensationList } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { when } from '../../numbers';
import { effect_line } from './lines';
import { StandingTags } from './standing';
import { t } from './texts';

/** The tables that were made of a test, and those that it proves; nothing where there are none. */
export function TablesOfTest({ test }: { test: number }) {
  const list = use_get<CompensationList>(`/api/compensations?test=${test}`);
  if (list.error) return <FailureNotice error={list.error} retry={list.reload} />;
  const all = list.data?.compensations ?? [];
  if (all.length === 0) return null;
  const made = all.filter((row) => row.test.id === test);
  const proved = all.filter((row) => row.retest?.id === test);
  return (
    <section class="panel archive-panel tables-of-test" aria-labelledby="tables-of-test">
      <header><h2 id="tables-of-test">{t('title')}</h2></header>
      {made.length > 0 && <List title={t('made_of_it')} rows={made} other={({ retest }) => retest} word={t('retest')} />}
      {proved.length > 0 && <List title={t('proved_by_it')} rows={proved} other={(row) => row.test} word={t('step_measured')} />}
    </section>
  );
}

function List({ title, rows, other, word }: { title: string; rows: readonly CompensationHead[]; other: (row: CompensationHead) => CompensationHead['retest']; word: string }) {
  return (
    <>
      <h3>{title}</h3>
      <ul>
        {rows.map((row) => {
          const test = other(row);
          return (
            <li key={row.id}>
              <a href={`/compensations/${row.id}`}>{t('heading', { id: row.id, control: row.control.title })}</a>
              {row.serious > 0 && <> <span class="tag bad">{t('serious', { n: row.serious })}</span></>}
              <span class="small quiet number-text"> {when(row.made_at)}</span>
              <br /><span class="small number-text">{effect_line(row)}</span>
              {test && <span class="small quiet"> · {word}: <a href={`/tests/${test.id}`}>{test.title}</a> {test.measured_on}<StandingTags test={test} /></span>}
            </li>
          );
        })}
      </ul>
    </>
  );
}
