// SPDX-License-Identifier: Apache-2.0
import { as_error } from '../../api/client';
import { useState } from 'preact/hooks';
import type { ApiError } from '../../api/client';
import { why_read_only } from '../../api/session';
import type { CompensationOptions } from '../../api/types';
import { Dialog } from '../../components/dialog';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { go } from '../../router';
import { actor } from '../../settings';
import { form_of, keep_table } from './asked';
import { t } from './texts';

interface Props { test: number; version: number; options: CompensationOptions; existing: File | null; serious: number }

/** Keeps the table with the test, and leads to it. `ready`: what is shown is what would be kept. */
export function KeepTable({ ready, ...sent }: Props & { ready: boolean }) {
  const [open, set_open] = useState(false);
  return (
    <>
      <button type="button" class="primary" disabled={!ready || why_read_only() !== null} onClick={() => set_open(true)}>{t('keep')}</button>
      {open && <KeepDialog {...sent} on_close={() => set_open(false)} />}
    </>
  );
}

function KeepDialog({ test, version, options, existing, serious, on_close }: Props & { on_close: () => void }) {
  const [notes, set_notes] = useState('');
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const is_kept = error?.kind === 'kept';   // though it cannot be shown: another time would be another one
  const submit = async () => {
    if (busy || is_kept) return;
    set_busy(true);
    set_error(null);
    try {
      const kept = await keep_table(test, version, form_of(options, existing, notes));
      go(`/compensations/${kept.id}`);
    } catch (thrown) {
      set_error(as_error(thrown));
      set_busy(false);
    }
  };
  return (
    <Dialog
      title={t('keep_title')} on_close={on_close} on_submit={() => void submit()}
      actions={
        <>
          <button type="button" onClick={on_close}>{t(is_kept ? 'close' : 'cancel')}</button>
          <button type="submit" class="primary" disabled={busy || is_kept}>{t('do_keep')}</button>
        </>
      }
    >
      <div class="stack">
        <p class="hint">{t('keep_how')}</p>
        {serious > 0 && <p class="notice bad">{t('keep_serious', { n: serious })}</p>}
        <Field label={t('notes')}>
          {(ids) => <textarea {...ids} data-first rows={3} class="whole-width" value={notes} onInput={(event) => set_notes(event.currentTarget.value)} />}
        </Field>
        <Field label={t('actor')} hint={t('actor_hint')}>
          {(ids) => <input {...ids} type="text" autoComplete="name" maxLength={80} placeholder="workbench" value={actor.value} onInput={(event) => { actor.value = event.currentTarget.value; }} />}
        </Field>
        {error && <FailureNotice error={error} />}
      </div>
    </Dialog>
  );
}
