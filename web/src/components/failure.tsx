// SPDX-License-Identifier: Apache-2.0
import type { ApiError } from '../api/client';
import { texts } from '../i18n/texts';
import { page_words } from './page_words';

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

/** What went wrong, in words, and a way on. What was asked wrongly is answered the same however often it is asked. */
export function FailureNotice({ error, message = error.message, retry }: { error: ApiError; message?: string; retry?: () => void }) {
  const heading =
    error.kind === 'conflict' || error.kind === 'read_only' || error.kind === 'full' || error.kind === 'not_found' || error.kind === 'kept' ? t(error.kind) : null;
  return (
    <div class={`notice ${error.kind === 'kept' ? 'caution' : 'bad'} ${error.kind === 'offline' ? 'offline' : ''}`} role="alert">
      {heading && <p class="heading">{heading}</p>}
      <p>
        {error.kind === 'offline' ? t('offline') : page_words(message)}
        {error.place !== '' && <span class="quiet"> ({t('line', { place: error.place })})</span>}
      </p>
      {retry && error.kind !== 'bad_input' && <button type="button" onClick={retry}>{t('again')}</button>}
    </div>
  );
}
