// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Instrument, InstrumentList } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { DataTable, type Order } from '../../components/table';
import { absent } from '../../numbers';
import { go } from '../../router';
import './instruments.css';
import { Due, overdue } from './due';
import { InstrumentDialog } from './instrument_dialog';
import { t } from './texts';

const make = (instrument: Instrument): string => [instrument.manufacturer, instrument.type].filter((part) => part !== '').join(' ');

const sorts: Record<string, (a: Instrument, b: Instrument) => number> = {
  role: (a, b) => a.role.localeCompare(b.role),
  make: (a, b) => make(a).localeCompare(make(b)),
  serial: (a, b) => a.serial_number.localeCompare(b.serial_number),
  due: (a, b) => (a.calibration_due || '9999').localeCompare(b.calibration_due || '9999'),
};

/** All instruments, the one whose calibration is due first at the top. */
export function InstrumentsPage() {
  const instruments = use_get<InstrumentList>('/api/instruments');
  const [order, set_order] = useState<Order>({ by: 'due', descending: false });
  const [adding, set_adding] = useState(false);
  const all = instruments.data?.instruments ?? [];
  const rows = [...all].sort((a, b) => (sorts[order.by]?.(a, b) ?? 0) * (order.descending ? -1 : 1));
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <div class="row">
          {all.length > 0 && <span class="quiet small">{t('count', { n: all.length, overdue: all.filter((one) => overdue(one.calibration_due)).length })}</span>}
          <button type="button" onClick={() => set_adding(true)}>{t('add')}</button>
        </div>
      </div>
      {instruments.error && <FailureNotice error={instruments.error} retry={instruments.reload} />}
      {instruments.data && all.length === 0 && <p class="panel">{t('none')}</p>}
      {all.length > 0 && (
        <section class="panel flush instruments">
          <DataTable<Instrument>
            caption={t('title')} rows={rows} row_key={(row) => row.id} order={order} on_order={set_order}
            columns={[
              { key: 'role', head: t('role'), order: 'role', row_head: true, cell: (row) => (
                <>
                  <a href={`/instruments/${row.id}`}>{row.role || make(row) || absent}</a>
                  <span class="only-narrow quiet small">{[make(row), row.serial_number].filter((part) => part !== '').join(', ')}</span>
                </>
              ) },
              { key: 'make', head: t('make'), order: 'make', class: 'wide-only', cell: (row) => make(row) || absent },
              { key: 'serial', head: t('serial_number'), order: 'serial', class: 'number-text wide-only', cell: (row) => row.serial_number || absent },
              { key: 'certificate', head: t('certificate'), class: 'wide-only', cell: (row) => row.certificate || absent },
              { key: 'calibrated', head: t('calibrated_on'), class: 'number-text wide-only', cell: (row) => row.calibrated_on || absent },
              { key: 'due', head: t('calibration_due'), order: 'due', cell: (row) => <Due due={row.calibration_due} /> },
              { key: 'tests', head: t('tests'), class: 'tests', cell: (row) => <a class="quiet-link" href={`/?instrument=${row.id}`}>{t('tests')}</a> },
            ]}
          />
        </section>
      )}
      {adding && <InstrumentDialog instrument={null} on_saved={(saved) => go(`/instruments/${saved.id}`)} on_close={() => set_adding(false)} />}
    </>
  );
}
