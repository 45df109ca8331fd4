// SPDX-License-Identifier: Apache-2.0
import type { ResolvedInput } from '../../api/types';
import { Formula } from '../../components/formula';
import { DataTable, type Column } from '../../components/table';
import { texts } from '../../i18n/texts';
import { shortest } from '../../numbers';

const t = texts({
  title: 'Inputs as resolved',
  symbol: 'Symbol',
  input: 'Input',
  value: 'Value',
  origin: 'Origin',
  use: 'Used by',
});

const value_text = ({ value, unit }: ResolvedInput): string =>
  typeof value === 'number' ? `${shortest(value, 7)} ${unit}`.trim() : value;

const columns: readonly Column<ResolvedInput>[] = [
  { key: 'symbol', head: t('symbol'), row_head: true, cell: (row) => <Formula text={row.symbol} /> },
  { key: 'input', head: t('input'), cell: (row) => row.title ?? row.key },
  { key: 'value', head: t('value'), number: true, cell: (row) => <Formula text={value_text(row)} /> },
  { key: 'origin', head: t('origin'), cell: (row) => row.origin_title ?? row.origin },
  { key: 'use', head: t('use'), cell: (row) => <span class={row.use === 'none' ? 'quiet' : ''}>{row.use_title ?? row.use}</span> },
];

/** What was stated about the uncertainty, which of it counts, and where it comes from. */
export function ResolvedInputs({ inputs }: { inputs: readonly ResolvedInput[] | undefined }) {
  if (!inputs || inputs.length === 0) return null;
  return (
    <details class="small resolved-inputs">
      <summary>{t('title')}</summary>
      <DataTable caption={t('title')} columns={columns} rows={inputs} row_key={(row) => `${row.key} ${row.origin}`} />
    </details>
  );
}
