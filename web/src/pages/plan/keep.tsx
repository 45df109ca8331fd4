// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import { type ApiError, as_error, download_made, get, query, send } from '../../api/client';
import type { Plan, PlanRequest } from '../../api/types';
import { ConflictDialog } from '../../components/conflict';
import { FailureNotice } from '../../components/failure';
import { when } from '../../numbers';
import { go, unsaved } from '../../router';
import { decimal, language } from '../../settings';
import type { PlanForm } from './form';
import { t } from './texts';

/** The version that is to be followed by another. */
type Base = Pick<Plan, 'id' | 'version'>;

interface Props {
  form: PlanForm;
  title: string; // typed, or the usual one
  request: PlanRequest | null;
  kept: Plan | null;
  touched: boolean;
  rename: (title: string) => void;
  done: (plan: Plan) => void; // saved as shown
  replace: (plan: Plan) => void; // another version to be shown
}

/** The head of the page: the plan's name, and what can be done with the whole of it. */
export function Keep({ form, title, request, kept, touched, rename, done, replace }: Props) {
  const [error, set_error] = useState<ApiError | null>(null);
  const [newer, set_newer] = useState<Plan | null>(null);
  const [busy, set_busy] = useState(false);
  const [said, set_said] = useState('');
  const [receipt, set_receipt] = useState<{ of: string; plan: Base | null } | null>(null); // of what was kept and cannot be shown
  const shown_body = JSON.stringify({ title, axis: form.axis, request });
  const is_kept = receipt?.of === shown_body;
  const base = receipt?.plan ?? kept;
  useEffect(() => {
    unsaved.value = touched && !is_kept ? t('leave') : null;
  }, [touched, is_kept, language.value]);
  useEffect(() => () => { unsaved.value = null; }, []);

  const failed = async (failure: unknown) => {
    const found = as_error(failure);
    if (found.kind === 'conflict' && base) set_newer(await get<Plan>(`/api/plans/${base.id}`).catch(() => null));
    if (found.kind === 'kept') {
      const { id, version } = found.receipt ?? { id: null, version: null };
      set_receipt({ of: shown_body, plan: id === null || version === null ? null : { id, version } });
      set_newer(null);
    }
    set_error(found);
  };
  const save = async (onto: Base | null) => {
    if (request === null || busy) return;
    set_busy(true);
    set_error(null);
    const body = { title, axis: form.axis, request };
    try {
      const plan = onto === null
        ? await send<Plan>('POST', '/api/plans', body)
        : await send<Plan>('PUT', `/api/plans/${onto.id}`, { ...body, base_version: onto.version, reason: '' });
      unsaved.value = null;
      set_newer(null);
      set_receipt(null);
      done(plan);
      set_said(t('saved', { n: plan.version }));
      if (plan.id !== kept?.id) go(`/plans/${plan.id}`, 'replace');
    } catch (failure) {
      await failed(failure);
    } finally {
      set_busy(false);
    }
  };
  const sheet = (extension: string) =>
    download_made(`/api/plans/draft/sheet.${extension}${query({ language: language.value, decimal: decimal.value })}`, { request }, `${title}.${extension}`).catch(failed);

  return (
    <>
      <header class="plan-head">
        <h1 tabIndex={-1}>{kept ? kept.title : t('new_plan')}{!kept && <span class="only-print">: {title}</span>}</h1>
        <label class="title no-print">
          <span class="quiet small">{t('title')}</span>
          <input value={form.title} placeholder={title} autocomplete="off" onInput={(event) => rename(event.currentTarget.value)} />
        </label>
        <div class="row no-print">
          <button type="button" class="primary" disabled={request === null || busy || is_kept || (base !== null && !touched)} onClick={() => save(base)}>
            {base ? t('save_version', { n: base.version + 1 }) : t('save')}
          </button>
          {kept && <button type="button" disabled={request === null || busy || is_kept} onClick={() => save(null)}>{t('save_copy')}</button>}
          {['pdf', 'html'].map((extension) => (
            <button type="button" key={extension} disabled={request === null} onClick={() => sheet(extension)}>
              {t('sheet')} {extension.toUpperCase()}
            </button>
          ))}
          {kept && <PlanFile id={kept.id} />}
          {kept && <a class="button" href={`/captures/new${query({ plan: kept.id })}`}>{t('capture_with')}</a>}
        </div>
      </header>
      {kept && (
        <p class="quiet small">
          {t('version')} {kept.version} · {when(kept.change.at)}{kept.change.actor !== '' && ` · ${t('by')} ${kept.change.actor}`}
        </p>
      )}
      <p class="visually-hidden" role="status">{said}</p>
      {error && newer === null && <FailureNotice error={error} />}
      {newer && (
        <ConflictDialog
          latest={{ ...newer.change, version: newer.version }} busy={busy}
          on_close={() => set_newer(null)} on_mine={() => void save(newer)}
          on_theirs={() => { set_error(null); set_newer(null); set_receipt(null); replace(newer); }}
        />
      )}
    </>
  );
}

/** The plan as it is kept, for `axiometry plan`, `capture` and other archives. */
export function PlanFile({ id }: { id: number }) {
  return <a class="button" href={`/api/plans/${id}/plan.json`} download>{t('plan_file')}</a>;
}
