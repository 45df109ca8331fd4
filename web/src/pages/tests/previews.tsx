// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error } from '../../api/client';
import { why_read_only } from '../../api/session';
import { FailureNotice } from '../../components/failure';
import { sentence } from '../../components/findings';
import { VerdictMark } from '../../components/verdict';
import { bytes } from '../../numbers';
import { go } from '../../router';
import { largest_table } from '../compensations/existing';
import { held_table } from '../compensations/held';
import { held_recording } from '../dynamic/held';
import { t as dynamic_words } from '../dynamic/texts';
import { held_motions } from '../motions/held';
import { t as motion_words } from '../motions/texts';
import { keep_plan } from '../plan/import';
import { keep_focus } from '../../focus';
import { HowRead } from './asked_columns';
import { Contents } from './contents';
import { can_be_kept, incoming, is_asked, is_new, keep, keep_all, may_retry, remove, remove_all, retry, type Incoming } from './incoming';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** The chosen files, each with what is in it or why it is refused. */
export function Previews({ on_formats }: { on_formats: () => void }) {
  const files = incoming.value;
  if (files.length === 0) return null;
  const ready = files.filter((one) => can_be_kept(one) && is_new(one)).length;
  const why = why_read_only();
  return (
    <section class="panel flush previews" aria-label={t('files')}>
      <header>
        <h2>{t('files')} <span class="quiet small">{hint(files)}</span></h2>
        <div class="row">
          {ready > 1 && <button type="button" class="primary" disabled={why !== null} onClick={() => void keep_all().then(keep_focus)}>{t('keep_all', { n: ready })}</button>}
          <button type="button" onClick={() => { remove_all(); keep_focus(); }}>{t('clear')}</button>
        </div>
      </header>
      <ul aria-live="polite">
        {files.map((one) => <FileEntry key={one.key} one={one} why={why} alone={files.length === 1} on_formats={on_formats} />)}
      </ul>
    </section>
  );
}

/** How many of the files are where. */
function hint(files: readonly Incoming[]): string {
  const kept = files.filter((one) => one.state === 'kept').length;
  const asked = files.filter(is_asked).length;
  const elsewhere = files.filter((one) => one.preview?.instead).length;
  const refused = files.filter((one) => one.preview?.refused || (one.error && one.state !== 'kept' && !may_retry(one))).length - asked - elsewhere;
  const waiting = files.length - kept - refused - asked - elsewhere;
  return [
    kept > 0 && t('files_kept', { n: kept }), waiting > 0 && t('files_waiting', { n: waiting }), asked > 0 && t('files_asked', { n: asked }),
    elsewhere > 0 && t('files_elsewhere', { n: elsewhere }), refused > 0 && t('files_refused', { n: refused }),
  ].filter(Boolean).join(', ');
}

function FileEntry({ one, why, alone, on_formats }: { one: Incoming; why: string | null; alone: boolean; on_formats: () => void }) {
  const preview = one.preview;
  const keep_this = async () => {
    const received = await keep(one.key);
    // Another kept the same while this was looked at: then it is said before one goes on.
    const news = is_new(one) && received?.tests.some((test) => test.same_content.length > 0);
    if (received && alone && received.tests.length <= 1 && !news) { remove(one.key); go(`/tests/${received.id}`); }
  };
  return (
    <li>
      <div class="line">
        <div class="what">
          <strong class="name">{one.file.name}</strong>
          <span class="quiet small number">{bytes(one.file.size)}</span>
          {preview?.format && one.profile === null && <span class="quiet small">{preview.format.title}</span>}
        </div>
        <div class="row">
          <State one={one} />
          {can_be_kept(one) && (
            <button type="button" class={is_new(one) ? 'primary' : ''} disabled={why !== null} title={why === null ? undefined : t('cannot_keep')} onClick={() => void keep_this()}>
              {t(is_new(one) ? 'keep' : 'keep_again')}
            </button>
          )}
          <button type="button" class="plain" aria-label={t('take_away', { name: one.file.name })} onClick={() => remove(one.key)}>
            <svg width="12" height="12" viewBox="0 0 14 14" aria-hidden="true"><path d="M2 2l10 10M12 2L2 12" stroke="currentColor" stroke-width="1.6" /></svg>
          </button>
        </div>
      </div>
      {one.error && (one.error.kind === 'bad_input'
        ? <Refusal one={one} message={one.error.message} place={one.error.place} on_formats={on_formats} />
        : <FailureNotice error={one.error} {...(may_retry(one) ? { retry: () => retry(one.key) } : {})} />)}
      {preview?.refused && (preview.instead === 'plan' ? <PlanFound one={one} why={why} /> : preview.instead === 'error-motion' ? <MotionFound one={one} />
        : preview.instead === 'recording' ? <RecordingFound one={one} />
        : preview.instead === 'temperatures' ? <p class="notice">{t('is_temperatures')}</p> : !is_asked(one) && (
        <Refusal one={one} message={preview.refused.message} place={place_of(preview.refused)} on_formats={on_formats} />
      ))}
      {preview?.table && one.state !== 'kept' && <HowRead one={one} table={preview.table} />}
      {one.received
        ? <p class="links"><VerdictMark verdict="conforms" short /> {t('kept')}{colon()} {one.received.tests.map((test, i) => (
            <span key={test.id}>
              {i > 0 && ', '}<a href={`/tests/${test.id}`}>{test.title || t('test_number', { id: test.id })}</a>
              {test.same_content.length > 0 && <span class="quiet"> ({t('same_bytes_as')} <TestLinks ids={test.same_content} />)</span>}
            </span>
          ))}</p>
        : one.state !== 'kept' && preview && preview.same_content.length > 0 && (
            <p class="notice caution">{t('same')} <TestLinks ids={preview.same_content} /></p>
          )}
      {one.received?.tests.flatMap((test) => test.remarks).map((remark) => <p key={remark} class="notice caution">{sentence(remark)}</p>)}
      {one.error?.receipt?.id && <p class="links"><VerdictMark verdict="conforms" short /> {t('kept')}{colon()} <TestLinks ids={[one.error.receipt.id]} /></p>}
      {preview && preview.tests.length > 0 && one.state !== 'kept' && <Contents preview={preview} />}
    </li>
  );
}

function TestLinks({ ids }: { ids: readonly number[] }) {
  return <>{ids.map((id, i) => <span key={id}>{i > 0 && ', '}<a href={`/tests/${id}`}>{t('test_number', { id })}</a></span>)}</>;
}

function State({ one }: { one: Incoming }) {
  if (one.state !== 'reading' && one.state !== 'keeping') {
    return one.state === 'waiting' && !one.error ? <span class="quiet small">{t('waiting')}</span> : null;
  }
  const word = t(one.state === 'reading' ? 'reading' : 'keeping');
  return (
    <span class="quiet small row">
      {one.file.size > 500_000 && <progress max={1} value={one.part} aria-label={word} />}
      {word}
    </span>
  );
}

/** No test, but a plan: it has a place of its own. */
function PlanFound({ one, why }: { one: Incoming; why: string | null }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const is_kept = error?.kind === 'kept';
  const keep_it = () => void keep_plan(one.file).then(
    (plan) => { remove(one.key); go(`/plans/${plan.id}`); },
    (failure: unknown) => set_error(as_error(failure)),
  );
  return (
    <>
      <p class="notice">{t('is_plan')} <button type="button" class="link" disabled={why !== null || is_kept} onClick={keep_it}>{t('keep_plan')}</button></p>
      {error && <FailureNotice error={error} {...(is_kept ? {} : { retry: keep_it })} />}
    </>
  );
}

/** No test of positions, but straightness or an angle, with all others of that sort that wait here. */
function MotionFound({ one }: { one: Incoming }) {
  const look = () => {
    const others = incoming.value.filter((other) => other !== one && other.preview?.instead === 'error-motion');
    held_motions.value = [one, ...others].map(({ file }) => file);
    for (const { key } of [one, ...others]) remove(key);
    go('/motions');
  };
  return <p class="notice">{motion_words('is_one')} <button type="button" class="link" onClick={look}>{motion_words('look')}</button></p>;
}

/** No test, but a continuous recording: its motion can be looked at. */
function RecordingFound({ one }: { one: Incoming }) {
  const look = () => {
    held_recording.value = one.file;
    remove(one.key);
    go('/dynamic');
  };
  return <p class="notice">{dynamic_words('is_one')} <button type="button" class="link" onClick={look}>{dynamic_words('look')}</button></p>;
}

function place_of({ line, column }: { line: number | null; column: number | null }): string {
  return line ? `${line}${column ? `:${column}` : ''}` : '';
}

/** What is refused as a test may be what a control corrects by, which has a page of its own. */
function look_at_table(file: File): void {
  held_table.value = file;
  go('/tables');
}

function Refusal({ one, message, place, on_formats }: { one: Incoming; message: string; place: string; on_formats: () => void }) {
  return (
    <div class="notice bad" role="alert">
      <p>
        <strong>{t('refused')}</strong>{place !== '' && <span class="number"> ({t('refused_at', { place })})</span>}: {message}
      </p>
      <button type="button" class="plain link" onClick={on_formats}>{t('formats')}</button>
      {one.file.size > 0 && one.file.size <= largest_table && <> · <button type="button" class="plain link" onClick={() => look_at_table(one.file)}>{t('as_table')}</button></>}
    </div>
  );
}
