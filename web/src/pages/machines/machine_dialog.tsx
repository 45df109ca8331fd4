// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Machine } from '../../api/types';
import { EntityDialog } from '../../components/entity_dialog';
import { TextFields } from '../../components/text_fields';
import { t } from './texts';

const keys = ['name', 'manufacturer', 'type', 'serial_number', 'controller', 'location', 'notes'] as const;
type Key = (typeof keys)[number];

const values_of = (machine: Machine | null): Record<Key, string> =>
  Object.fromEntries(keys.map((key) => [key, machine?.[key] ?? ''])) as Record<Key, string>;

interface Props { machine: Machine | null; on_saved: (machine: Machine) => void; on_close: () => void }

export function MachineDialog({ machine, on_saved, on_close }: Props) {
  const [values, set_values] = useState(values_of(machine));
  const [tried, set_tried] = useState(false);
  const nameless = values.name.trim() === '';
  return (
    <EntityDialog<Machine>
      title={machine ? t('edit_title', { name: machine.name }) : t('add_title')} path="/api/machines" entity={machine}
      collect={() => { set_tried(true); return nameless ? null : values; }}
      on_saved={on_saved} on_theirs={on_saved} on_close={on_close}
    >
      <TextFields
        fields={keys.map((key) => ({
          key, label: t(key), ...(key === 'notes' ? { type: 'area' as const } : {}),
          ...(key === 'name' ? { first: true, fault: tried && nameless ? t('name_missing') : null } : {}),
        }))}
        values={values} on_change={(key, value) => set_values({ ...values, [key]: value })}
      />
    </EntityDialog>
  );
}
