// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';

export interface Column<Row> {
  key: string;
  head: ComponentChildren;
  cell: (row: Row) => ComponentChildren;
  number?: boolean;             // right-aligned figures
  order?: string | undefined;   // sorts by this name when the head is pressed
  falling?: boolean;            // the first press sorts from the largest, the latest
  row_head?: boolean;           // names the row
  class?: string;
}

export interface Order { by: string; descending: boolean }

interface Props<Row> {
  caption: string;              // for those who do not see the heading above
  columns: readonly Column<Row>[];
  rows: readonly Row[];
  row_key: (row: Row) => string | number;
  order?: Order | undefined;
  on_order?: (order: Order) => void;
  row_class?: (row: Row) => string;
}

/** A table that sorts where its heads are buttons, and scrolls in its own frame when it is too wide. */
export function DataTable<Row>({ caption, columns, rows, row_key, order, on_order, row_class }: Props<Row>) {
  const turn = (column: Column<Row>) => {
    const by = column.order as string;
    on_order?.({ by, descending: order?.by === by ? !order.descending : (column.falling ?? false) });
  };
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={caption}>
      <table>
        <thead>
          <tr>
            {columns.map((column) => (
              <th
                key={column.key} scope="col" class={`${column.number ? 'number' : ''} ${column.class ?? ''}`}
                aria-sort={!column.order || order?.by !== column.order ? undefined : order.descending ? 'descending' : 'ascending'}
              >
                {column.order && on_order
                  ? <button type="button" onClick={() => turn(column)}>{column.head}<Arrow order={order} by={column.order} /></button>
                  : column.head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row_key(row)} class={row_class?.(row)}>
              {columns.map((column) =>
                column.row_head
                  ? <th key={column.key} scope="row" class={column.class}>{column.cell(row)}</th>
                  : <td key={column.key} class={`${column.number ? 'number' : ''} ${column.class ?? ''}`}>{column.cell(row)}</td>)}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Arrow({ order, by }: { order: Order | undefined; by: string }) {
  const on = order?.by === by;
  return (
    <svg class={`sort-arrow ${on ? 'on' : ''}`} width="8" height="8" viewBox="0 0 8 8" aria-hidden="true">
      <path d={on && order?.descending ? 'M1 2h6l-3 4z' : 'M1 6h6l-3-4z'} fill="currentColor" />
    </svg>
  );
}
