// SPDX-License-Identifier: Apache-2.0
import type { CalibrationPage, MachineList } from '../../api/types';
import { query } from '../../api/client';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { place, set_query } from '../../router';
import './calibrations.css';
import { CalibrationTable } from './table';
import { t } from './texts';

const page_size = 50;
const filter_keys = ['text', 'kind', 'machine', 'from', 'to', 'withdrawn'] as const;
const asked_keys = [...filter_keys, 'order', 'descending', 'offset'] as const;

/** Any change leads to the first page again. */
const set = (parts: Record<string, string | null>) => set_query({ ...parts, offset: null });

/** Every calibration that is kept; what the list is narrowed to stands in the address. */
export function CalibrationsPage() {
  const asked = place.value.query;
  const page = use_get<CalibrationPage>(`/api/calibrations${query({ ...Object.fromEntries(asked_keys.map((key) => [key, asked.get(key)])), limit: page_size })}`);
  const found = page.data;
  const narrowed = filter_keys.some((key) => asked.has(key));
  const order = { by: asked.get('order') ?? 'received', descending: asked.get('descending') !== '0' };
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <a class="button no-print" href="/motions">{t('to_motions')}</a>
      </div>
      <Filters />
      {page.error && <FailureNotice error={page.error} retry={page.reload} />}
      {found?.total === 0 && <p class="panel quiet">{t(narrowed ? 'none_found' : 'none')}</p>}
      {found && found.total > 0 && (
        <section class="panel flush list-page">
          <CalibrationTable rows={found.calibrations} order={order} on_order={({ by, descending }) => set({ order: by, descending: descending ? null : '0' })} />
          <Pages total={found.total} shown={found.calibrations.length} />
        </section>
      )}
    </>
  );
}

function Filters() {
  const asked = place.value.query;
  const machines = use_get<MachineList>('/api/machines');
  return (
    <form class="calibration-filters no-print" role="search" onSubmit={(event) => event.preventDefault()}>
      <Field label={t('search')}>
        {(ids) => <input {...ids} type="search" value={asked.get('text') ?? ''} onInput={(event) => set({ text: event.currentTarget.value || null })} />}
      </Field>
      <Field label={t('kind')}>
        {(ids) => (
          <select {...ids} value={asked.get('kind') ?? ''} onChange={(event) => set({ kind: event.currentTarget.value || null })}>
            <option value="">{t('all')}</option>
            {(['lines', 'volumetric', 'straightness', 'angles', 'squareness'] as const).map((kind) => <option key={kind} value={kind}>{t(kind)}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('machine')}>
        {(ids) => (
          <select {...ids} value={asked.get('machine') ?? ''} onChange={(event) => set({ machine: event.currentTarget.value || null })}>
            <option value="">{t('all')}</option>
            {machines.data?.machines.map((one) => <option key={one.id} value={one.id}>{one.name}</option>)}
          </select>
        )}
      </Field>
      {(['from', 'to'] as const).map((key) => (
        <Field key={key} label={t(key)}>
          {(ids) => <input {...ids} type="date" value={asked.get(key) ?? ''} onChange={(event) => set({ [key]: event.currentTarget.value || null })} />}
        </Field>
      ))}
      <label class="check"><input type="checkbox" checked={asked.get('withdrawn') === '1'} onChange={(event) => set({ withdrawn: event.currentTarget.checked ? '1' : null })} />{t('with_withdrawn')}</label>
    </form>
  );
}

function Pages({ total, shown }: { total: number; shown: number }) {
  const offset = Number(place.value.query.get('offset') ?? 0);
  if (total <= page_size) return null;
  const to = (first: number) => set_query({ offset: first > 0 ? String(first) : null });
  return (
    <div class="row calibration-pages no-print">
      <button type="button" disabled={offset === 0} onClick={() => to(Math.max(0, offset - page_size))}>{t('later')}</button>
      <span class="quiet small">{t('counted', { n: `${offset + 1}–${offset + shown}`, total })}</span>
      <button type="button" disabled={offset + shown >= total} onClick={() => to(offset + page_size)}>{t('earlier')}</button>
    </div>
  );
}
