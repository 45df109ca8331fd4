// SPDX-License-Identifier: Apache-2.0
import type { CalibrationRow } from '../../api/types';
import { DataTable, type Column, type Order } from '../../components/table';
import { VerdictMark } from '../../components/verdict';
import { absent, when } from '../../numbers';
import { headline } from './figures';
import { t } from './texts';

/** Rows of calibrations, in a list of all and on a machine's page. */
export function CalibrationTable({ rows, with_machine = true, order, on_order }: {
  rows: readonly CalibrationRow[]; with_machine?: boolean; order?: Order; on_order?: (order: Order) => void;
}) {
  const judged = rows.some(({ verdict }) => verdict !== null);
  const columns: Column<CalibrationRow>[] = [
    { key: 'title', head: t('name'), order: 'title', row_head: true, cell: (row) => <Name row={row} with_machine={with_machine} /> },
    { key: 'kind', head: t('kind'), class: 'wide-only', cell: (row) => t(row.kind) },
    ...(with_machine ? [{ key: 'machine', head: t('machine'), class: 'wide-only', cell: (row: CalibrationRow) => <MachineLink row={row} /> }] : []),
    { key: 'measured', head: t('measured'), order: 'measured', falling: true, class: 'number-text wide-only', cell: (row) => row.measured_on || absent },
    { key: 'received', head: t('received'), order: 'received', falling: true, class: 'number-text wide-only', cell: (row) => when(row.received_at) },
    { key: 'headline', head: t('headline'), class: 'effect', cell: (row) => <>{headline(row)}{row.serious > 0 && <> <span class="tag bad">{t('serious', { n: row.serious })}</span></>}</> },
    ...(judged ? [{ key: 'verdict', head: t('verdict'), cell: ({ kind, verdict }: CalibrationRow) => (kind === 'lines' ? <VerdictMark verdict={verdict} /> : absent) }] : []),
  ];
  return <DataTable<CalibrationRow> caption={t('title')} columns={columns} rows={rows} row_key={(row) => row.id} order={order} {...(on_order ? { on_order } : {})} />;
}

/** With what stands in columns of its own where there is room for them. */
function Name({ row, with_machine }: { row: CalibrationRow; with_machine: boolean }) {
  return (
    <>
      <a href={`/calibrations/${row.id}`}>{row.title}</a>{row.withdrawn && <> <span class="tag">{t('withdrawn')}</span></>}
      <span class="only-narrow small">{t(row.kind)}</span>
      {with_machine && row.machine && <span class="only-narrow small"><MachineLink row={row} /></span>}
      <span class="only-narrow small number">{row.measured_on || when(row.received_at)}</span>
    </>
  );
}

function MachineLink({ row: { machine } }: { row: CalibrationRow }) {
  return machine ? <a href={`/machines/${machine.id}`}>{machine.name}</a> : <>{t('unstated')}</>;
}
