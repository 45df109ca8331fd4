// SPDX-License-Identifier: Apache-2.0
// The parts of a plan of lengths: which have been captured, and what begins the next one.
import { useEffect, useState } from 'preact/hooks';
import { type ApiError, as_error, query, send } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { Capture, LengthPart, LengthParts, LengthSubject, SourceList } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { DataTable } from '../../components/table';
import { count } from '../../numbers';
import { go } from '../../router';
import { decimal } from '../../settings';
import './capture.css';
import { t } from './length_texts';
import { is_over } from './live';
import { sent, SourceChoice, SourceOptions, type SourceForm } from './source_fields';
import { has_table } from './table_ending';
import { t as t_capture } from './texts';
import { colon } from '../../i18n/colon';

const often_ms = 1500;

/** All parts are measured with one instrument: what was said of it once is said of the next part too. */
let said_last: SourceForm = { source: '', layout: '', options: { speed: '10', preset: 'good' } };

/** Of a part: the latest that is complete, else the one with most lengths. */
function used_of(captures: readonly Capture[]): Capture | null {
  const all = captures.filter(has_table);
  const most = (a: Capture, b: Capture) => ((b.lengths?.end?.found ?? 0) > (a.lengths?.end?.found ?? 0) ? b : a);
  return all.find(({ state }) => state === 'complete') ?? (all.length === 0 ? null : all.reduce(most));
}

/** Captures whose lengths are taken, the oldest first; where several hold one line the server takes the latest. */
function used_captures({ parts, captures }: LengthParts): Capture[] {
  const used = parts.map(({ part }) => used_of(captures.filter((capture) => capture.part === part)));
  return used.filter((capture) => capture !== null).sort((a, b) => a.id - b.id);
}

interface Props {
  subject: Pick<LengthSubject, 'kind' | 'plan'> | null;
  step?: string;
  own?: Capture;      // that is shown above; its end changes what is here
}

/** The first part that can be asked about. */
function some_part({ kind, plan }: Pick<LengthSubject, 'kind' | 'plan'>): number {
  if (kind === 'lines') return 0;
  const { runs } = plan as { runs: { stops: unknown[] }[] };
  return Math.max(0, runs.findIndex(({ stops }) => stops.length > 0)) + 1;
}

export function LengthPartsPanel({ subject, step, own }: Props) {
  const asked = use_posted<LengthParts>(`/api/captures/parts${query({ decimal: decimal.value })}`, subject && { ...subject, part: some_part(subject) }, as_json);
  const sources = use_get<SourceList>('/api/sources');
  const [form, set_form] = useState(said_last);
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const parts = subject === null ? null : asked.data;
  const running = parts?.captures.some((capture) => !is_over(capture)) ?? false;
  useEffect(() => { if (own) asked.again(); }, [own?.id, own?.state]);
  useEffect(() => {
    if (!running) return;
    const timer = window.setInterval(asked.again, often_ms);
    return () => window.clearInterval(timer);
  }, [running]);
  const source = sources.data?.sources.find(({ id }) => id === form.source) ?? sources.data?.sources[0];
  const change = (part: Partial<SourceForm>) => {
    const next = { ...form, ...part };
    set_form(next);
    said_last = next;
  };
  const begin = (part: number) => {
    if (!source || !subject || busy) return;
    set_busy(true);
    set_error(null);
    send<Capture>('POST', '/api/captures', { lengths: { ...subject, part }, source: source.id, layout: form.layout, options: sent(form.options, source, 'lengths') }).then(
      (capture) => { set_busy(false); go(`/captures/${capture.id}`); },
      (failure: unknown) => {
        set_error(as_error(failure));
        set_busy(false);
      },
    );
  };
  return (
    <section class="panel no-print length-parts" aria-labelledby="length-parts">
      <header><h2 id="length-parts">{step && <span class="step">{step}</span>}{t('capture_lengths')}</h2></header>
      <div class="new-capture">
        {!own && <p class="hint">{t('how')}</p>}
        {!subject && <p class="quiet">{t('no_plan')}</p>}
        {subject && (
          <>
            <SourceChoice sources={sources.data?.sources ?? []} source={source} choose={(id) => change({ source: id })} />
            {source && <SourceOptions source={source} form={form} change={change} unit="mm" of_lengths />}
          </>
        )}
      </div>
      {sources.error && <FailureNotice error={sources.error} retry={sources.reload} />}
      {asked.error && subject && <FailureNotice error={asked.error} retry={asked.again} />}
      {error && <FailureNotice error={error} />}
      {parts && <PartsTable parts={parts} busy={busy || !source} begin={begin} own={own} />}
    </section>
  );
}

function PartsTable({ parts, busy, begin, own }: { parts: LengthParts; busy: boolean; begin: (part: number) => void; own: Capture | undefined }) {
  const used = used_captures(parts);
  const of = ({ part }: LengthPart) => parts.captures.filter((capture) => capture.part === part);
  const wanted = parts.parts.filter(({ part, stops }) => stops > 0 && (parts.kind === 'volume' || part > 0));
  const whole = used.some(({ part }) => part === 0);
  const done = wanted.filter(({ part }) => (whole && parts.kind === 'lines') || used.some((capture) => capture.part === part)).length;
  const next = whole && parts.kind === 'lines' ? undefined : parts.parts.find((one) => one.stops > 0 && of(one).length === 0);
  return (
    <>
      <DataTable caption={t('parts')} rows={parts.parts} row_key={({ part }) => part} row_class={({ part }) => (part === own?.part ? 'is-shown' : '')} columns={[
        { key: 'part', head: t('part'), row_head: true, cell: ({ title }) => title },
        { key: 'points', head: t('points'), number: true, cell: ({ stops }) => count(stops) },
        { key: 'captured', head: t('captured'), cell: (one) => <Captured captures={of(one)} used={used} /> },
        { key: 'begin', head: <span class="visually-hidden">{t('begin')}</span>, cell: (one) => <Begin part={one} captures={of(one)} busy={busy} begin={begin} is_next={one === next} /> },
      ]} />
      <div class="row spread">
        <span role="status">{t('parts_done', { n: done, all: wanted.length })}</span>
        {used.length > 0 && (
          <a class={`button ${done === wanted.length ? 'primary' : ''}`} href={`${parts.kind === 'volume' ? '/volume' : '/tracking'}?captures=${used.map(({ id }) => id).join(',')}`}>
            {t(parts.kind === 'volume' ? 'identify' : 'evaluate')}
          </a>
        )}
      </div>
    </>
  );
}

function Captured({ captures, used }: { captures: readonly Capture[]; used: readonly Capture[] }) {
  if (captures.length === 0) return <span class="quiet">{t('not_yet')}</span>;
  return (
    <ul class="of-part">
      {captures.map((capture) => {
        const end = capture.lengths?.end;
        const is_used = used.some(({ id }) => id === capture.id);
        return (
          <li key={capture.id} class={end && !is_used ? 'quiet' : ''}>
            <a href={`/captures/${capture.id}`}>{t_capture(capture.state)}</a>{' '}
            <span class="number">{end && !has_table(capture) ? t('nothing') : t('found_of', { n: end?.found ?? capture.taken, all: capture.approaches })}</span>
            {has_table(capture) && !is_used && ` (${t('not_used')})`}
          </li>
        );
      })}
    </ul>
  );
}

interface BeginProps { part: LengthPart; captures: readonly Capture[]; busy: boolean; begin: (part: number) => void; is_next: boolean }

function Begin({ part, captures, busy, begin, is_next }: BeginProps) {
  const live = captures.find((capture) => !is_over(capture));
  if (live) return <a class="button" href={`/captures/${live.id}`}>{t('watch')}</a>;
  if (part.stops === 0) return null;
  return (
    <button type="button" class={is_next ? 'primary' : ''} disabled={busy} aria-label={`${t(captures.length > 0 ? 'begin_again' : 'begin')}${colon()} ${part.title}`} onClick={() => begin(part.part)}>
      {t(captures.length > 0 ? 'begin_again' : 'begin')}
    </button>
  );
}
