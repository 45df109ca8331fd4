// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Instrument } from '../../api/types';
import { day_seconds } from '../../components/dates';
import { EntityDialog } from '../../components/entity_dialog';
import { TextFields } from '../../components/text_fields';
import { changes_of, InputsEditor, rows_of, use_inputs, wrong_input } from './inputs';
import { t } from './texts';

const keys = ['role', 'manufacturer', 'type', 'serial_number', 'certificate', 'calibrated_on', 'calibration_due', 'notes'] as const;
type Key = (typeof keys)[number];
const dates: readonly Key[] = ['calibrated_on', 'calibration_due'];

interface Props { instrument: Instrument | null; on_saved: (instrument: Instrument) => void; on_close: () => void }

export function InstrumentDialog({ instrument, on_saved, on_close }: Props) {
  const [values, set_values] = useState(Object.fromEntries(keys.map((key) => [key, instrument?.[key] ?? ''])) as Record<Key, string>);
  const [rows, set_rows] = useState(rows_of(instrument?.inputs ?? {}));
  const [tried, set_tried] = useState(false);
  const known = use_inputs();
  const fault = (key: Key): string | null => {
    const text = values[key].trim();
    if (key === 'role' && text === '') return t('role_missing');
    // A date that was there before, and that only a person understands, is left alone.
    const old = instrument?.[key] ?? '';
    return dates.includes(key) && text !== '' && text !== old && day_seconds(text) === null ? t('date_fault', { text }) : null;
  };
  const collect = () => {
    set_tried(true);
    if (keys.some((key) => fault(key) !== null) || rows.some((row) => row.text !== '' && wrong_input(row, known))) return null;
    return { ...values, inputs: changes_of(rows, known) };
  };
  return (
    <EntityDialog<Instrument>
      title={instrument ? t('edit_title', { name: name_of(instrument) }) : t('add_title')} path="/api/instruments" entity={instrument}
      collect={collect} on_saved={on_saved} on_theirs={on_saved} on_close={on_close} wide
    >
      <TextFields
        fields={keys.map((key) => ({
          key, label: t(key === 'role' ? 'role_field' : key), fault: tried ? fault(key) : null, first: key === 'role',
          type: key === 'notes' ? 'area' : dates.includes(key) ? 'date' : 'text',
        }))}
        values={values} on_change={(key, value) => set_values({ ...values, [key]: value })}
      />
      <InputsEditor rows={rows} known={known} tried={tried} on_change={set_rows} />
    </EntityDialog>
  );
}

/** As people call it: "Laser interferometer 4711". */
export const name_of = (instrument: Instrument): string =>
  [instrument.role || [instrument.manufacturer, instrument.type].filter((part) => part !== '').join(' '), instrument.serial_number].filter((part) => part !== '').join(' ');
