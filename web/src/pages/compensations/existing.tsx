// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { bytes_of } from '../../api/client';
import type { CompensatedControl, CompensationHead } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { FileDrop } from '../../components/file_drop';
import { bytes } from '../../numbers';
import type { Answered } from './asked';
import { t } from './texts';

/** The table that was active while the test was measured: from the archive, where that knows it. */
export interface Existing { file: File; of: number | null }

/** The API takes a form of at most 1 MiB, its head with it. */
export const largest_table = (1 << 20) - 4096;

/** The file of a kept table, as it went into the control. */
export async function file_of({ id, file_name }: CompensationHead): Promise<File> {
  return new File([await bytes_of(`/api/compensations/${id}/files/table`)], file_name);
}

export function ExistingPanel({ existing, set, read, loaded, is_proved, control, take_loaded, children }: {
  existing: Existing | null; set: (existing: Existing | null) => void; read: Answered<unknown>; control: CompensatedControl;
  loaded: CompensationHead | null;        // the table that was active, or may have been
  is_proved: boolean;                     // it was: this test is its re-test
  take_loaded: () => void;
  children: ComponentChildren;            // how it is meant
}) {
  const too_large = existing !== null && existing.file.size > largest_table;
  return (
    <div class="stack tight">
      <p class="small quiet">{t('existing_how')}</p>
      {loaded !== null && existing === null && (
        <p class={`notice ${is_proved ? 'caution' : ''}`}>
          {t(is_proved ? 'was_active' : 'maybe_active', { id: loaded.id })}{' '}
          {loaded.control.id !== control.id ? t('other_control', { control: loaded.control.title }) : <button type="button" class="link" onClick={take_loaded}>{t('take_loaded', { id: loaded.id })}</button>}
        </p>
      )}
      {existing !== null && (
        <div class="row spread existing-file">
          <span><strong class="file-name">{existing.file.name}</strong> <span class="quiet small number">{bytes(existing.file.size)}</span>
            {existing.of !== null && <span class="small quiet"> · <a href={`/compensations/${existing.of}`}>{t('table_n', { id: existing.of })}</a></span>}</span>
          <button type="button" class="small no-print" onClick={() => set(null)}>{t('without_existing')}</button>
        </div>
      )}
      {existing !== null && children}
      {too_large && <p class="notice bad" role="alert">{t('too_large', { size: bytes(existing.file.size), limit: bytes(largest_table) })}</p>}
      {read.error && !too_large && <FailureNotice error={read.error} {...(read.error.kind === 'bad_input' ? {} : { retry: read.again })} />}
      <FileDrop label={t(existing === null ? 'choose_existing' : 'choose_other')} hint={t('drop_existing')} of_page take={(file) => set({ file, of: null })} />
    </div>
  );
}
