// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { ApiError } from '../../api/client';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { texts } from '../../i18n/texts';
import { failure_of } from './state';

const t = texts({
  reason: ['Reason', 'Grund'],
  hint: ['Stands in the audit trail with name and time.', 'Steht mit Name und Zeit im Prüfpfad.'],
  cancel: ['Cancel', 'Abbrechen'],
});

/** A native modal: focus stays inside, Escape closes, focus returns. */
export function Modal({ title, close, children }: { title: string; close: () => void; children: ComponentChildren }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useId();
  useEffect(() => {
    if (dialog.current && !dialog.current.open) dialog.current.showModal();
  }, []);
  return (
    <dialog ref={dialog} aria-labelledby={heading} onClose={close} class="stack">
      <h2 id={heading}>{title}</h2>
      {children}
    </dialog>
  );
}

interface Props {
  title: string;
  action: string;
  required?: boolean;
  disabled?: boolean;
  close: () => void;
  act: (reason: string) => Promise<void>;
  /** What to do with a failure instead of showing it here; true when it was dealt with. */
  caught?: (failure: ApiError) => boolean;
  children?: ComponentChildren;
}

/** Asks why, then does it; a failure stays here with all that was typed. */
export function ReasonDialog({ title, action, required = true, disabled = false, close, act, caught, children }: Props) {
  const [reason, set_reason] = useState('');
  const [failure, set_failure] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const submit = async (event: Event) => {
    event.preventDefault();
    set_busy(true);
    try {
      await act(reason.trim());
      close();
    } catch (error) {
      const found = failure_of(error);
      if (!caught?.(found)) set_failure(found);
      set_busy(false);
    }
  };
  return (
    <Modal title={title} close={close}>
      <form class="stack" onSubmit={submit}>
        {children}
        <Field label={t('reason')} hint={t('hint')}>
          {(ids) => <textarea {...ids} rows={3} cols={60} required={required} value={reason} onInput={(event) => set_reason(event.currentTarget.value)} />}
        </Field>
        {failure && <FailureNotice error={failure} />}
        <div class="row">
          <button type="submit" class="primary" disabled={busy || disabled || (required && reason.trim() === '')}>{action}</button>
          <button type="button" onClick={close}>{t('cancel')}</button>
        </div>
      </form>
    </Modal>
  );
}
