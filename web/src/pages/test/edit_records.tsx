// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import type { Field } from '../../api/types';
import { texts } from '../../i18n/texts';
import { marked, parsed } from '../../numbers';
import { records_of, records_text } from './field_value';
import { colon } from '../../i18n/colon';

const t = texts({
  add: 'Add a row',
  remove: 'Remove row {row}',
  row: '{title}, row {row}',
});

interface Props {
  ids: { id: string; 'aria-describedby': string | undefined; 'aria-invalid': 'true' | undefined };
  field: Field;
  text: string;
  change: (text: string) => void;
}

/** A list of records, each in a frame; rows in which nothing stands yet are only on the screen. */
export function EditRecords({ ids, field, text, change }: Props) {
  const shown = (rows: string[][]) => rows.map((row) => row.map((cell, i) => (field.columns[i]?.type === 'number' && parsed(cell) !== null ? marked(cell) : cell)));
  const [rows, set_rows] = useState(shown(records_of(field, text)));
  useEffect(() => {
    if (records_text(field, rows) !== records_text(field, records_of(field, text))) set_rows(shown(records_of(field, text)));
  }, [text]);
  const put = (next: string[][]) => {
    set_rows(next);
    change(records_text(field, next));
  };
  return (
    <div class="records">
      {rows.map((row, r) => (
        <div key={r} class="record" role="group" aria-label={t('row', { title: field.title, row: r + 1 })}>
          {field.columns.map((column, c) => (
            <label key={column.key}>
              <span class="quiet small">{column.title}{column.unit !== '' && `, ${column.unit}`}</span>
              <input type="text" value={row[c]} autoComplete="off" aria-invalid={ids['aria-invalid']}
                     onInput={(event) => {
                       const next = event.currentTarget.value;
                       put(rows.map((other, i) => (i === r ? other.map((cell, k) => (k === c ? next : cell)) : other)));
                     }} />
            </label>
          ))}
          <button type="button" class="plain" aria-label={t('remove', { row: r + 1 })} onClick={() => put(rows.filter((_, i) => i !== r))}>×</button>
        </div>
      ))}
      <button {...ids} type="button" class="small" aria-label={`${t('add')}${colon()} ${field.title}`} onClick={() => set_rows([...rows, field.columns.map(() => '')])}>{t('add')}</button>
    </div>
  );
}
