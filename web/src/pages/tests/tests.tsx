// SPDX-License-Identifier: Apache-2.0
import { useRef, useState } from 'preact/hooks';
import './tests.css';
import { FormatsHelp } from './formats_help';
import { add_files } from './incoming';
import { TestList } from './list';
import { Previews } from './previews';
import { t } from './texts';

/** Where one begins: files come in, and everything that was kept is found. */
export function TestsPage() {
  const [help, set_help] = useState(false);
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <div class="row intake no-print">
          <span class="quiet small">{t('drop_here')}</span>
          <button type="button" class="primary" onClick={() => input.current?.click()}>{t('choose')}</button>
          <button type="button" onClick={() => set_help(true)}>{t('formats')}</button>
          <input
            ref={input} type="file" multiple hidden aria-label={t('choose')}
            onChange={(event) => {
              add_files([...(event.currentTarget.files ?? [])]);
              event.currentTarget.value = '';  // the same file again is a new choice
            }}
          />
        </div>
      </div>
      <Previews on_formats={() => set_help(true)} />
      <TestList on_choose={() => input.current?.click()} />
      {help && <FormatsHelp on_close={() => set_help(false)} />}
    </>
  );
}
