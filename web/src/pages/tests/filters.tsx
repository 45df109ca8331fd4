// SPDX-License-Identifier: Apache-2.0
// What the list is narrowed to; all of it stands in the address, so that a view can be kept and sent.
import { useEffect, useRef, useState } from 'preact/hooks';
import type { InstrumentList, MachineList } from '../../api/types';
import { use_get } from '../../api/use';
import { Field } from '../../components/field';
import { place, set_query } from '../../router';
import { name_of } from '../instruments/instrument_dialog';
import { t } from './texts';

export const filter_keys = ['text', 'machine', 'axis', 'instrument', 'verdict', 'from', 'to', 'withdrawn'] as const;

const narrowed = (): boolean => filter_keys.some((key) => place.value.query.has(key));

/** Any change leads to the first page again. */
const set = (parts: Record<string, string | null>) => set_query({ ...parts, offset: null });

export function Filters() {
  const query = place.value.query;
  const [open, set_open] = useState(false);  // on a phone only
  const machines = use_get<MachineList>('/api/machines');
  const chosen = machines.data?.machines.find((machine) => String(machine.id) === query.get('machine'));
  return (
    <form class={`filters no-print ${open ? 'open' : ''}`} role="search" onSubmit={(event) => event.preventDefault()}>
      <SearchBox />
      <button type="button" class="more" aria-expanded={open} onClick={() => set_open(!open)}>{t('more_filters')}{narrowed() ? ' •' : ''}</button>
      <Field label={t('machine')}>
        {(ids) => (
          <select {...ids} value={query.get('machine') ?? ''} onChange={(event) => set({ machine: event.currentTarget.value, axis: null })}>
            <option value="">{t('all')}</option>
            {machines.data?.machines.map((machine) => <option key={machine.id} value={machine.id}>{machine.name}</option>)}
          </select>
        )}
      </Field>
      {chosen && chosen.axes.length > 0 && (
        <Field label={t('axis')}>
          {(ids) => (
            <select {...ids} value={query.get('axis') ?? ''} onChange={(event) => set({ axis: event.currentTarget.value })}>
              <option value="">{t('all')}</option>
              {chosen.axes.map((axis) => <option key={axis.id} value={axis.id}>{axis.name}</option>)}
            </select>
          )}
        </Field>
      )}
      {query.has('instrument') && <InstrumentChoice chosen={query.get('instrument') ?? ''} />}
      <Field label={t('verdict')}>
        {(ids) => (
          <select {...ids} value={query.get('verdict') ?? ''} onChange={(event) => set({ verdict: event.currentTarget.value })}>
            <option value="">{t('all')}</option>
            <option value="conforms">{t('conforms')}</option>
            <option value="does not conform">{t('does_not')}</option>
            <option value="undecided">{t('undecided')}</option>
          </select>
        )}
      </Field>
      <DateBox edge="from" />
      <DateBox edge="to" />
      <label class="switch">
        <input type="checkbox" checked={query.get('withdrawn') === '1'} onChange={(event) => set({ withdrawn: event.currentTarget.checked ? '1' : null })} />
        {t('withdrawn')}
      </label>
      {narrowed() && (
        <button type="button" class="plain" onClick={() => set(Object.fromEntries(filter_keys.map((key) => [key, null])))}>{t('reset')}</button>
      )}
    </form>
  );
}

/** Only where a link from an instrument led here. */
function InstrumentChoice({ chosen }: { chosen: string }) {
  const all = use_get<InstrumentList>('/api/instruments').data?.instruments ?? [];
  return (
    <Field label={t('instrument')}>
      {(ids) => (
        <select {...ids} value={chosen} onChange={(event) => set({ instrument: event.currentTarget.value })}>
          <option value="">{t('all')}</option>
          {all.map((one) => <option key={one.id} value={one.id}>{name_of(one)}</option>)}
        </select>
      )}
    </Field>
  );
}

/** A whole date of a year, a month or a day: "2026" begins with its first day and ends with its last. */
export function whole_date(text: string, edge: 'from' | 'to'): string | null {
  const parts = /^(\d{4})(?:-(\d{1,2}))?(?:-(\d{1,2}))?$/.exec(text.trim());
  if (!parts) return null;
  const [year, month, day] = [Number(parts[1]), parts[2], parts[3]];
  const in_month = Number(month ?? (edge === 'from' ? 1 : 12));
  const last = new Date(Date.UTC(year, in_month, 0)).getUTCDate();
  const in_day = Number(day ?? (edge === 'from' ? 1 : last));
  if (in_month < 1 || in_month > 12 || in_day < 1 || in_day > last) return null;
  return `${parts[1]}-${String(in_month).padStart(2, '0')}-${String(in_day).padStart(2, '0')}`;
}

function DateBox({ edge }: { edge: 'from' | 'to' }) {
  const asked = place.value.query.get(edge) ?? '';
  const [typed, set_typed] = useState(asked);
  useEffect(() => { if ((whole_date(typed, edge) ?? '') !== asked) set_typed(asked); }, [asked]);
  const wrong = typed.trim() !== '' && whole_date(typed, edge) === null;
  return (
    <Field label={t(edge)}>
      {(ids) => (
        <input
          {...ids} class="date" inputMode="numeric" placeholder={t('date')} value={typed} aria-invalid={wrong ? 'true' : undefined}
          onInput={(event) => {
            const text = event.currentTarget.value;
            set_typed(text);
            const date = whole_date(text, edge);
            if (text.trim() === '' || date !== null) set({ [edge]: date });
          }}
        />
      )}
    </Field>
  );
}

/** Asks while one types: what is in the box is the browser's, the address follows a moment later. */
function SearchBox() {
  const asked = place.value.query.get('text') ?? '';
  const [typed, set_typed] = useState(asked);
  const sent = useRef(asked);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const end = new AbortController();
    document.addEventListener('keydown', (event) => {
      if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.target instanceof Element && event.target.closest('input, select, textarea, dialog')) return;
      event.preventDefault();
      box.current?.querySelector('input')?.focus();
    }, { signal: end.signal });
    return () => end.abort();
  }, []);
  useEffect(() => {
    if (asked !== sent.current) { sent.current = asked; set_typed(asked); }  // changed from elsewhere: a link, "back"
  }, [asked]);
  useEffect(() => {
    if (typed === sent.current) return;
    const timer = setTimeout(() => { sent.current = typed; set({ text: typed }); }, 50);
    return () => clearTimeout(timer);
  }, [typed]);
  return (
    <div class="search" ref={box}>
      <Field label={t('search')}>
        {(ids) => (
          <input {...ids} type="search" placeholder={t('search_hint')} value={typed} onInput={(event) => set_typed(event.currentTarget.value)} />
        )}
      </Field>
    </div>
  );
}
