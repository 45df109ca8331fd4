// SPDX-License-Identifier: Apache-2.0
import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { query as query_text } from '../../api/client';
import { health } from '../../api/session';
import type { Parameter, TestPage, TestRow } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { DataTable, type Column, type Order } from '../../components/table';
import { VerdictMark } from '../../components/verdict';
import { absent, count, unit_sign, when } from '../../numbers';
import { place, set_query } from '../../router';
import { at_hand, column_decimals, FigureCell, ParameterHead, shown_of, some_interval, some_U } from '../../components/figure_cell';
import { differ, method_of, named_method, record_note } from '../../components/uncertainty';
import { filter_keys, Filters } from './filters';
import { incoming, kept_count } from './incoming';
import { t } from './texts';
import { Welcome } from './welcome';

const page_size = 50;
const most_compared = 8;

/** Chosen for a comparison; stays while one pages, searches, or looks at a test. */
const chosen = signal<readonly number[]>([]);
const choose = (id: number, on: boolean) => { chosen.value = on ? [...chosen.value, id] : chosen.value.filter((other) => other !== id); };

function asked(): { path: string; order: Order; offset: number } {
  const query = place.value.query;
  const order = { by: query.get('order') ?? 'received', descending: (query.get('descending') ?? '1') === '1' };
  const offset = Math.max(0, Number(query.get('offset') ?? 0) || 0);
  const filters = Object.fromEntries(filter_keys.map((key) => [key, query.get(key)]));
  return { order, offset, path: `/api/tests${query_text({ ...filters, order: order.by, descending: order.descending ? 1 : 0, offset, limit: page_size })}` };
}

export function TestList({ on_choose }: { on_choose: () => void }) {
  const { path, order, offset } = asked();
  const page = use_get<TestPage>(path);
  const kept = kept_count.value;
  useEffect(() => { if (kept > 0) page.reload(); }, [kept]);
  const filtered = filter_keys.some((key) => place.value.query.has(key));
  if (page.data?.total === 0 && !filtered && offset === 0 && (health.value?.store.counts.tests ?? 0) === 0) return incoming.value.length > 0 ? null : <Welcome on_choose={on_choose} />;
  return (
    <section class={`panel flush test-list ${some_interval(page.data?.tests.map((row) => row.figures) ?? []) ? 'with-intervals' : ''}`} aria-busy={page.loading}>
      <header><h2>{t('list')}</h2><Comparison /></header>
      <Filters />
      {page.error && <FailureNotice error={page.error} retry={page.reload} />}
      {page.data && page.data.tests.length > 0 && (
        <DataTable<TestRow>
          caption={t('list')} columns={columns(page.data.tests)} rows={page.data.tests} row_key={(row) => row.id} order={order}
          on_order={(to) => set_query({ order: to.by, descending: to.descending ? '1' : '0', offset: null })}
          row_class={(row) => (row.withdrawn ? 'withdrawn' : '')}
        />
      )}
      {page.data && <p class="record-note quiet small">{record_note(page.data.tests.map((row) => row.figures))}</p>}
      {page.data && <Pager total={page.data.total} offset={offset} on_page={page.data.tests.length} />}
    </section>
  );
}

function columns(rows: readonly TestRow[]): Column<TestRow>[] {
  const full = chosen.value.length >= most_compared;
  const figures = rows.map((row) => row.figures);
  const named = differ(figures);
  const figure = (parameter: Parameter, decimals = column_decimals(figures, parameter)): Column<TestRow> => ({
    key: parameter, head: <ParameterHead parameter={parameter} with_U={some_U(figures)} />, number: true, order: parameter, falling: true,
    cell: (row) => {
      const own = at_hand(row.figures, parameter);
      return <FigureCell shown={shown_of(row.figures, own)} decimals={decimals} named={own === parameter ? undefined : own} />;
    },
  });
  return [
    { key: 'choose', head: <span class="visually-hidden">{t('compare')}</span>, class: 'tick', cell: (row) => {
      const on = chosen.value.includes(row.id);
      return (
        <label>
          <input
            type="checkbox" checked={on} disabled={!on && full} aria-label={t('choose_test', { title: row.title })}
            onChange={(event) => choose(row.id, event.currentTarget.checked)}
          />
        </label>
      );
    } },
    { key: 'title', head: t('test'), order: 'title', row_head: true, class: 'title', cell: (row) => (
      <>
        <a href={`/tests/${row.id}`} title={row.title || row.file_name}>{row.title || row.file_name}</a>
        {row.withdrawn && <> <span class="tag">{t('withdrawn_tag')}</span></>}
        <span class="only-narrow quiet small">
          {[row.machine?.name, row.axis?.name].filter(Boolean).join(', ')}
          {' '}<span class="number-text">{row.measured_on}</span> ({unit_sign(row.unit)})
        </span>
        {named && method_of(row.figures) !== null && <span class="by-method quiet small">{t('by_method', { method: named_method(method_of(row.figures)) })}</span>}
        {row.label !== '' && <> <span class="tag" title={row.label}>{t('not_for_acceptance')}</span></>}
      </>
    ) },
    { key: 'machine', head: t('machine'), order: 'machine', class: 'wide-only machine', cell: (row) => (row.machine ? <a class="quiet-link" href={`/machines/${row.machine.id}`}>{row.machine.name}</a> : absent) },
    { key: 'axis', head: t('axis'), class: 'wide-only', cell: (row) => (row.axis ? <a class="quiet-link" href={`/axes/${row.axis.id}`}>{row.axis.name}</a> : absent) },
    { key: 'measured', head: t('measured'), order: 'measured', falling: true, class: 'number-text wide-only', cell: (row) => row.measured_on || absent },
    figure('A'), figure('E'), figure('R'), figure('B'),
    { key: 'unit', head: t('unit'), class: 'quiet wide-only', cell: (row) => unit_sign(row.unit) },
    { key: 'verdict', head: <span class="verdict-head">{t('verdict')}</span>, cell: (row) => <VerdictMark verdict={row.verdict} /> },
    { key: 'received', head: t('received'), order: 'received', falling: true, class: 'number-text quiet wide-only', cell: (row) => when(row.received_at).slice(0, 10) },
  ];
}

function Comparison() {
  const ids = chosen.value;
  if (ids.length === 0) return null;
  return (
    <div class="row" aria-live="polite">
      <span class="quiet small">{ids.length === 1 ? t('chosen_one') : t('chosen', { n: ids.length })}</span>
      <button type="button" class="plain" onClick={() => { chosen.value = []; }}>{t('unchoose')}</button>
      {ids.length > 1 && <a class="button primary" href={`/compare?tests=${ids.join(',')}`}>{t('compare')}</a>}
    </div>
  );
}

function Pager({ total, offset, on_page }: { total: number; offset: number; on_page: number }) {
  if (total === 0) return <p class="quiet nothing">{t('none')}</p>;
  const to = (next: number) => set_query({ offset: next > 0 ? String(next) : null });
  return (
    <nav class="pager" aria-label={t('list')}>
      <span class="quiet small number" aria-live="polite">
        {t('found', { first: count(Math.min(offset + 1, total)), last: count(offset + on_page), total: count(total) })}
      </span>
      {(offset > 0 || offset + on_page < total) && (
        <div class="row">
          <button type="button" disabled={offset === 0} onClick={() => to(offset - page_size)}>{t('before')}</button>
          <button type="button" disabled={offset + on_page >= total} onClick={() => to(offset + page_size)}>{t('after')}</button>
        </div>
      )}
    </nav>
  );
}
