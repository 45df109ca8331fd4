// SPDX-License-Identifier: Apache-2.0
import type { ApiError } from '../api/client';
import { texts } from '../i18n/texts';

const t = texts({
  offline: 'The workbench does not answer. Is the program still running? The connection is tried again every two seconds.',
  conflict: 'Somebody else was first',
  read_only: 'This store can be read, not written',
  full: 'No room: nothing of this was kept',
  not_found: 'Not found',
  kept: 'Kept, but not shown',
  line: 'line {place}',
  again: 'Try again',
});

/** These are answered the same however often they are asked; and of refusals a wrong method, a body too large, a wrong type. */
const lasting_kinds: readonly ApiError['kind'][] = ['bad_input', 'not_found', 'damaged', 'read_only'];
const lasting_statuses: readonly number[] = [405, 413, 415];
const may_pass = ({ kind, status }: ApiError): boolean =>
  !lasting_kinds.includes(kind) && !(kind === 'refused' && lasting_statuses.includes(status));

/** What went wrong, in words, and a way on. */
export function FailureNotice({ error, message = error.message, retry }: { error: ApiError; message?: string; retry?: () => void }) {
  const heading =
    error.kind === 'conflict' || error.kind === 'read_only' || error.kind === 'full' || error.kind === 'not_found' || error.kind === 'kept' ? t(error.kind) : null;
  return (
    <div class={`notice ${error.kind === 'kept' ? 'caution' : 'bad'} ${error.kind === 'offline' ? 'offline' : ''}`} role="alert">
      {heading && <p class="heading">{heading}</p>}
      <p>
        {error.kind === 'offline' ? t('offline') : message}
        {error.place !== '' && <span class="quiet"> ({t('line', { place: error.place })})</span>}
      </p>
      {retry && may_pass(error) && <button type="button" onClick={retry}>{t('again')}</button>}
    </div>
  );
}
