// SPDX-License-Identifier: Apache-2.0
// What people say of a calibration: the same fields when it is kept and when it is edited.
import type { InstrumentList, MachineList } from '../api/types';
import { use_get } from '../api/use';
import { texts } from '../i18n/texts';
import { name_of } from '../pages/instruments/instrument_dialog';
import { Field } from './field';

const t = texts({
  title: 'Title',
  machine: 'Machine',
  instrument: ['Instrument', 'asset'],
  measured_on: 'Measured on',
  notes: 'Notes',
  none: 'not stated',
});

export interface CalibrationWords { title: string; machine: number | null; instrument: number | null; measured_on: string; notes: string }

export const empty_words: CalibrationWords = { title: '', machine: null, instrument: null, measured_on: '', notes: '' };

const number_of = (text: string): number | null => (text === '' ? null : Number(text));

export function CalibrationFields({ words, on_change }: { words: CalibrationWords; on_change: (words: CalibrationWords) => void }) {
  const machines = use_get<MachineList>('/api/machines');
  const instruments = use_get<InstrumentList>('/api/instruments');
  return (
    <>
      <Field label={t('title')}>
        {(ids) => <input {...ids} data-first class="whole-width" maxLength={500} value={words.title} onInput={(event) => on_change({ ...words, title: event.currentTarget.value })} />}
      </Field>
      <Field label={t('machine')}>
        {(ids) => (
          <select {...ids} value={words.machine ?? ''} onChange={(event) => on_change({ ...words, machine: number_of(event.currentTarget.value) })}>
            <option value="">{t('none')}</option>
            {machines.data?.machines.map((one) => <option key={one.id} value={one.id}>{one.name}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('instrument')}>
        {(ids) => (
          <select {...ids} value={words.instrument ?? ''} onChange={(event) => on_change({ ...words, instrument: number_of(event.currentTarget.value) })}>
            <option value="">{t('none')}</option>
            {instruments.data?.instruments.map((one) => <option key={one.id} value={one.id}>{name_of(one)}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('measured_on')}>
        {(ids) => <input {...ids} type="date" value={words.measured_on} onChange={(event) => on_change({ ...words, measured_on: event.currentTarget.value })} />}
      </Field>
      <Field label={t('notes')}>
        {(ids) => <textarea {...ids} rows={3} value={words.notes} onInput={(event) => on_change({ ...words, notes: event.currentTarget.value })} />}
      </Field>
    </>
  );
}
