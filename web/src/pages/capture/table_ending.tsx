// SPDX-License-Identifier: Apache-2.0
// What came of a capture that became a table, of lengths or of an error motion: its files, and whether it stays listed.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import type { Capture, CapturedTable } from '../../api/types';
import { Dialog } from '../../components/dialog';
import { FailureNotice } from '../../components/failure';
import { sentence } from '../../components/findings';
import { go } from '../../router';
import { t } from './texts';

export type FileRole = CapturedTable['files'][number];
export const table_role = (capture: Capture): FileRole => (capture.motion ? 'readings' : 'lengths');
export const table_of = (capture: Capture): CapturedTable | null => (capture.motion ?? capture.lengths)?.end ?? null;
export const has_table = (capture: Capture): boolean => table_of(capture)?.files.includes(table_role(capture)) ?? false;

interface Props {
  capture: Capture;
  kept: string; only_raw: string; table: string; discard_what: string; // texts
  again: () => void;
  children?: ComponentChildren; // where it leads
}

export function TableEnding({ capture, kept, only_raw, table, discard_what, again, children }: Props) {
  const [error, set_error] = useState<ApiError | null>(null);
  const [asking, set_asking] = useState(false);
  const failed = (failure: unknown) => set_error(as_error(failure));
  const after = (request: Promise<Capture>) => void request.then(again, failed);
  const end = table_of(capture);
  const has = (role: FileRole) => end?.files.includes(role) ?? false;
  const whole = capture.state === 'complete' && has_table(capture) && end?.found === capture.approaches;
  const tone = capture.state === 'failed' ? 'bad' : whole ? 'good' : 'caution';
  const told = capture.state === 'interrupted' ? t('broken_off') : has_table(capture) ? kept : has('raw') ? only_raw : t('nothing_came');
  const discard = () => {
    set_asking(false);
    send<Capture>('POST', `/api/captures/${capture.id}/discard`, {}).then(() => go('/captures'), failed);
  };
  const file = (role: FileRole, text: string) => has(role) && <a class="button" href={`/api/captures/${capture.id}/files/${role}`} download>{text}</a>;
  return (
    <div class={`notice ${tone} ending`} role="status">
      <div>
        <h2>{t(capture.state)}</h2>
        {capture.error !== null && <p>{sentence(capture.error)}</p>}
        <p>{told}</p>
        {end && end.notes.length > 0 && (
          <details open={end.notes.length > 1}>
            <summary>{t('what_is_noted')}</summary>
            <ul>{end.notes.map((note, k) => <li key={k}>{sentence(note)}</li>)}</ul>
          </details>
        )}
        {error && <FailureNotice error={error} />}
      </div>
      <div class="row">
        {capture.state === 'interrupted' ? (
          <>
            <button type="button" onClick={() => after(send<Capture>('POST', `/api/captures/${capture.id}/stop`, {}))}>{t('keep_so_far')}</button>
            <button type="button" class="primary" onClick={() => after(send<Capture>('POST', '/api/captures', { resume: capture.id }))}>{t('resume')}</button>
          </>
        ) : (
          <>
            {children}
            {file(table_role(capture), table)}
            {file('raw', t('raw_file'))}
            {file('times', t('times_file'))}
            {file('keys', t('keys_file'))}
            {has('raw') && <button type="button" onClick={() => set_asking(true)}>{t('discard')}</button>}
          </>
        )}
      </div>
      {asking && (
        <Dialog title={t('discard_ask')} on_close={() => set_asking(false)} actions={(
          <>
            <button type="button" data-first onClick={() => set_asking(false)}>{t('keep_it')}</button>
            <button type="button" class="stop" onClick={discard}>{t('discard')}</button>
          </>
        )}>
          <p>{discard_what}</p>
        </Dialog>
      )}
    </div>
  );
}
