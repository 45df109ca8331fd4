// SPDX-License-Identifier: Apache-2.0
// What may be done with a kept table beside its re-test: each makes a version, with its reason.
import { useState } from 'preact/hooks';
import { send } from '../../api/client';
import type { KeptCompensation } from '../../api/types';
import { Field } from '../../components/field';
import { ReasonDialog } from '../test/reason_dialog';
import { revise } from './revise';
import { t } from './texts';

export interface DialogProps { found: KeptCompensation; on_done: (found: KeptCompensation) => void; on_close: () => void }

export function EditNotes({ found, on_done, on_close }: DialogProps) {
  const [notes, set_notes] = useState(found.notes);
  return (
    <ReasonDialog title={t('notes_title')} action={t('save', { n: found.version + 1 })} close={on_close} disabled={notes.trim() === found.notes}
      act={async (reason) => on_done(await revise(found, { notes: notes.trim(), reason }))}>
      <Field label={t('notes')}>
        {(ids) => <textarea {...ids} rows={4} class="whole-width" value={notes} onInput={(event) => set_notes(event.currentTarget.value)} />}
      </Field>
    </ReasonDialog>
  );
}

export function WithdrawTable({ found, on_done, on_close }: DialogProps) {
  const to = found.withdrawn ? 'reinstate' : 'withdraw';
  return (
    <ReasonDialog title={t(`${to}_title`)} action={t(to)} close={on_close}
      act={async (reason) => on_done(await send<KeptCompensation>('POST', `/api/compensations/${found.id}/${to}`, { reason }))}>
      <p class="hint">{t(`${to}_how`)}</p>
    </ReasonDialog>
  );
}
