// SPDX-License-Identifier: Apache-2.0
// Editing what is kept by versions (machines, axes, instruments): a form in a dialog, with the reason, and what happens
// when somebody else was first.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { type ApiError, as_error, get, send } from '../api/client';
import { returned, why_read_only } from '../api/session';
import type { Entity } from '../api/types';
import { texts } from '../i18n/texts';
import { ConflictDialog } from './conflict';
import { Dialog } from './dialog';
import { FailureNotice } from './failure';
import { Field } from './field';
import { merged_body } from './merged_edit';

const t = texts({
  reason: 'Reason for the change',
  reason_hint: 'stands in the history',
  cancel: 'Cancel',
  close: 'Close',
  save: 'Save as version {n}',
  add: 'Add',
  read_only: 'Nothing can be kept in this store{why}.',
});

interface Props<T extends Entity> {
  title: string;
  path: string;                       // "/api/machines"
  entity: T | null;                   // null: a new one
  collect: () => object | null;       // what is to be kept; null when a field is wrong, which it then says itself
  on_saved: (saved: T) => void;
  on_theirs: (latest: T) => void;     // the user gave up their own changes for these
  on_close: () => void;
  children: ComponentChildren;
  wide?: boolean;
}

export function EntityDialog<T extends Entity>({ title, path, entity, collect, on_saved, on_theirs, on_close, children, wide }: Props<T>) {
  const [reason, set_reason] = useState('');
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const [theirs, set_theirs] = useState<T | null>(null);
  const base = theirs?.version ?? entity?.version ?? 0;
  const why = why_read_only();
  const is_kept = error?.kind === 'kept';   // though it cannot be shown
  const close = () => {
    on_close();
    if (is_kept) returned.value += 1;   // what is behind this is asked for again
  };

  /** Onto the version that the form began with, or onto one of somebody else, whose changes stay where nothing was typed. */
  const save = async (onto: T | null) => {
    const typed = collect();
    if (typed === null) return;
    const body = entity !== null && onto !== null && onto.version !== entity.version ? merged_body(entity, typed, onto) : typed;
    set_busy(true);
    set_error(null);
    try {
      on_saved(entity === null
        ? await send<T>('POST', path, { ...body, reason })
        : await send<T>('PUT', `${path}/${entity.id}`, { ...body, base_version: onto?.version ?? entity.version, reason }));
    } catch (failure) {
      await explain(failure);
    }
    set_busy(false);
  };
  const explain = async (failure: unknown) => {
    const told = as_error(failure);
    set_theirs(null);
    if (told.kind === 'conflict' && entity !== null) {
      const latest = await get<T>(`${path}/${entity.id}`).catch(() => null);
      if (latest && latest.version > (entity.version)) { set_theirs(latest); return; }
    }
    set_error(told);
  };
  return (
    <>
      <Dialog
        title={title} on_close={close} on_submit={() => { if (!is_kept) void save(theirs ?? entity); }} wide={wide ?? false}
        actions={
          <>
            <button type="button" onClick={close}>{t(is_kept ? 'close' : 'cancel')}</button>
            <button type="submit" class="primary" disabled={busy || is_kept || why !== null}>{entity === null ? t('add') : t('save', { n: base + 1 })}</button>
          </>
        }
      >
        <div class="stack">
          {children}
          {entity !== null && (
            <Field label={t('reason')} hint={t('reason_hint')}>
              {(ids) => <input {...ids} class="whole-width" value={reason} onInput={(event) => set_reason(event.currentTarget.value)} />}
            </Field>
          )}
          {why !== null && <p class="notice caution">{t('read_only', { why: why === '' ? '' : ` (${why})` })}</p>}
          {error && <FailureNotice error={error} />}
        </div>
      </Dialog>
      {theirs && (
        <ConflictDialog
          latest={{ ...theirs.change, version: theirs.version }} busy={busy}
          on_theirs={() => on_theirs(theirs)} on_mine={() => void save(theirs)} merges on_close={() => set_theirs(null)}
        />
      )}
    </>
  );
}
