// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { query } from '../../api/client';
import { use_get } from '../../api/use';
import type { Test, TestPage } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { use_settled } from '../../components/settled';
import { texts } from '../../i18n/texts';

const t = texts({
  add: 'Add a test',
  search: 'Search by title, machine or file',
  same_axis: 'Tests of the same axis',
  recent: 'Recent tests',
  found: ['Found', 'search'],
  none: 'No other test fits.',
  full: 'Eight tests are the most that a chart keeps legible.',
});

const settle_ms = 120;

/** Finds tests to add; without a search those of the same axis, the usual thing to compare with. */
export function Picker({ chosen, first, add }: { chosen: readonly number[]; first: Test | null; add: (id: number) => void }) {
  const [typed, set_typed] = useState('');
  const text = use_settled(typed.trim(), settle_ms);
  const axis = text === '' ? (first?.axis?.id ?? null) : null;
  const page = use_get<TestPage>(`/api/tests${query({ text, axis, limit: 20 })}`);
  if (chosen.length >= 8) return <p class="small quiet full no-print">{t('full')}</p>;
  const rows = (page.data?.tests ?? []).filter((row) => !chosen.includes(row.id)).slice(0, 12);
  return (
    <section class="panel picker no-print" aria-label={t('add')}>
      <header><h2>{t('add')}</h2></header>
      <input type="search" aria-label={t('search')} placeholder={t('search')} value={typed} onInput={(event) => set_typed(event.currentTarget.value)} />
      {page.error && <FailureNotice error={page.error} retry={page.reload} />}
      <h3 class="small quiet">{t(text !== '' ? 'found' : axis !== null ? 'same_axis' : 'recent')}</h3>
      {page.data !== null && rows.length === 0 && <p class="quiet">{t('none')}</p>}
      <ul>
        {rows.map((row) => (
          <li key={row.id}>
            <button type="button" class="plain" onClick={() => add(row.id)}>
              <span>{row.title}</span>
              <span class="small quiet">{[row.machine?.name, row.axis?.name, row.measured_on].filter((part) => part).join(' · ')}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
