// SPDX-License-Identifier: Apache-2.0
import { as_error } from '../../api/client';
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import type { ApiError } from '../../api/client';
import { Dialog } from '../../components/dialog';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { texts } from '../../i18n/texts';
import { actor } from '../../settings';

const t = texts({
  reason: 'Reason (required)',
  name: 'Name for the audit trail',
  hint: 'Without a name, “workbench” stands there.',
  cancel: 'Cancel',
});

interface Props {
  title: string;
  action: string;
  disabled?: boolean;
  close: () => void;
  act: (reason: string) => Promise<void>;
  /** What to do with a failure instead of showing it here; true when it was dealt with. */
  caught?: (failure: ApiError) => boolean;
  children?: ComponentChildren;
}

/** Asks why, then does it; a failure stays here with all that was typed. */
export function ReasonDialog({ title, action, disabled = false, close, act, caught, children }: Props) {
  const [reason, set_reason] = useState('');
  const [failure, set_failure] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const ready = !busy && !disabled && reason.trim() !== '';
  const submit = async () => {
    if (!ready) return;
    set_busy(true);
    try {
      await act(reason.trim());
      close();
    } catch (error) {
      const found = as_error(error);
      if (!caught?.(found)) set_failure(found);
      set_busy(false);
    }
  };
  return (
    <Dialog
      title={title} on_close={close} on_submit={() => void submit()}
      actions={
        <>
          <button type="button" onClick={close}>{t('cancel')}</button>
          <button type="submit" class="primary" disabled={!ready}>{action}</button>
        </>
      }
    >
      <div class="stack">
        {children}
        <Field label={t('reason')}>
          {(ids) => <textarea {...ids} data-first rows={3} required value={reason} onInput={(event) => set_reason(event.currentTarget.value)} />}
        </Field>
        <Field label={t('name')} hint={t('hint')}>
          {(ids) => (
            <input {...ids} type="text" autoComplete="name" maxLength={80} placeholder="workbench" value={actor.value}
                   onInput={(event) => { actor.value = event.currentTarget.value; }} />
          )}
        </Field>
        {failure && <FailureNotice error={failure} />}
      </div>
    </Dialog>
  );
}
