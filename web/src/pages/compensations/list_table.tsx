// SPDX-License-Identifier: Apache-2.0
import type { CompensationHead, CompensationTest } from '../../api/types';
import { DataTable, type Column } from '../../components/table';
import { date_or_none } from '../../components/test_date';
import { absent, when } from '../../numbers';
import { effect_line } from './lines';
import { StandingTags } from './standing';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** Rows of tables that were kept: in the list of all, and of an axis. */
export function CompensationTable({ rows, with_axis = true }: { rows: readonly CompensationHead[]; with_axis?: boolean }) {
  const columns: Column<CompensationHead>[] = [
    { key: 'table', head: t('the_table'), row_head: true, cell: (row) => <Name row={row} with_axis={with_axis} /> },
    ...(with_axis ? [{ key: 'axis', head: t('machine_axis'), class: 'wide-only', cell: (row: CompensationHead) => <Place row={row} /> }] : []),
    { key: 'test', head: t('measured'), class: 'wide-only', cell: (row) => <TestLink test={row.test} /> },
    { key: 'effect', head: t('effect_head'), class: 'effect', cell: (row) => <>{effect_line(row)}{row.serious > 0 && <> <span class="tag bad">{t('serious', { n: row.serious })}</span></>}
      {row.retest && <span class="only-narrow small">{t('retest')}{colon()} <TestLink test={row.retest} /></span>}</> },
    { key: 'retest', head: t('retest'), class: 'wide-only', cell: (row) => (row.retest ? <TestLink test={row.retest} /> : <span class="quiet">{t('open')}</span>) },
    { key: 'made', head: t('made_at'), class: 'number-text wide-only', cell: (row) => when(row.made_at) },
  ];
  return <DataTable<CompensationHead> caption={t('title')} columns={columns} rows={rows} row_key={({ id }) => id} row_class={({ withdrawn }) => (withdrawn ? 'withdrawn' : '')} />;
}

function Name({ row, with_axis }: { row: CompensationHead; with_axis: boolean }) {
  return (
    <>
      <a href={`/compensations/${row.id}`}>{t('heading', { id: row.id, control: row.control.title })}</a>{row.withdrawn && <> <span class="tag">{t('withdrawn')}</span></>}
      {with_axis && <span class="only-narrow small"><Place row={row} /></span>}
      <span class="only-narrow small"><TestLink test={row.test} /></span>
    </>
  );
}

function Place({ row: { machine, axis } }: { row: CompensationHead }) {
  return <>{machine ? <a href={`/machines/${machine.id}`}>{machine.name}</a> : absent}{axis && <>, <a href={`/axes/${axis.id}`}>{axis.name}</a></>}</>;
}

export function TestLink({ test }: { test: CompensationTest }) {
  return <><a href={`/tests/${test.id}`}>{test.title}</a> <span class="quiet small number">{date_or_none(test.measured_on)}</span><StandingTags test={test} /></>;
}
