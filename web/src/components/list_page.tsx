// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import type { Loaded } from '../api/use';
import { FailureNotice } from './failure';
import { DataTable, type Column } from './table';

interface Props<Row> {
  title: string;
  actions: ComponentChildren;   // beside the heading; the main one last
  asked: Pick<Loaded<unknown>, 'error' | 'reload'>;
  rows: readonly Row[] | undefined;   // undefined until they are there
  none: ComponentChildren;
  columns: readonly Column<Row>[];
  row_key: (row: Row) => string | number;
  children?: ComponentChildren;  // above the rows
}

/** A page that is one list: its heading with what makes a new entry, what went wrong, and the rows. */
export function ListPage<Row>({ title, actions, asked, rows, none, columns, row_key, children }: Props<Row>) {
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{title}</h1>
        <div class="row no-print">{actions}</div>
      </div>
      {asked.error && <FailureNotice error={asked.error} retry={asked.reload} />}
      {children}
      {rows?.length === 0 && <p class="panel quiet">{none}</p>}
      {rows !== undefined && rows.length > 0 && (
        <section class="panel flush list-page">
          <DataTable<Row> caption={title} columns={columns} rows={rows} row_key={row_key} />
        </section>
      )}
    </>
  );
}
