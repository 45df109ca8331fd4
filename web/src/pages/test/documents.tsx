// SPDX-License-Identifier: Apache-2.0
import { useRef, useState } from 'preact/hooks';
import { type ApiError, as_error, upload } from '../../api/client';
import type { Document } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { texts } from '../../i18n/texts';
import { bytes, when } from '../../numbers';
import { type TestState } from './state';

const t = texts({
  title: 'Documents',
  none: 'No issued report and no attachment yet.',
  attach: 'Attach files',
  attaching: 'Attaching …',
  name: 'Name',
  kind: 'Kind',
  report: 'issued report',
  attachment: 'attachment',
  version: 'Of version',
  size: 'Size',
  added: 'Added',
});

/** Issued reports and attachments: kept as they are for good. */
export function Documents({ state }: { state: TestState }) {
  const test = state.test.value;
  const input = useRef<HTMLInputElement>(null);
  const [busy, set_busy] = useState(false);
  const [failure, set_failure] = useState<ApiError | null>(null);
  const attach = async (files: FileList | null) => {
    if (files === null || files.length === 0) return;
    set_busy(true);
    set_failure(null);
    try {
      for (const file of Array.from(files)) {
        const document = await upload<Document>(`/api/tests/${test.id}/attachments`, file);
        state.test.value = { ...state.test.value, documents: [...state.test.value.documents, document] };
      }
    } catch (error) {
      set_failure(as_error(error));
    }
    if (input.current) input.current.value = '';
    set_busy(false);
  };
  return (
    <section class="panel flush archive-panel">
      <header>
        <h2>{t('title')}</h2>
        <input ref={input} type="file" multiple hidden aria-label={t('attach')} onChange={(event) => void attach(event.currentTarget.files)} />
        <button type="button" class="small no-print" disabled={busy} onClick={() => input.current?.click()}>{busy ? t('attaching') : t('attach')}</button>
      </header>
      {failure && <FailureNotice error={failure} />}
      {test.documents.length === 0 ? <p class="quiet foot">{t('none')}</p> : <List documents={test.documents} />}
    </section>
  );
}

function List({ documents }: { documents: readonly Document[] }) {
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
      <table>
        <thead>
          <tr>
            <th scope="col">{t('name')}</th><th scope="col">{t('kind')}</th><th scope="col" class="number">{t('version')}</th>
            <th scope="col" class="number">{t('size')}</th><th scope="col">{t('added')}</th>
          </tr>
        </thead>
        <tbody>
          {documents.map((document) => (
            <tr key={document.id}>
              <th scope="row"><a href={`/api/documents/${document.id}`} download={document.name} class="file-name">{document.name}</a></th>
              <td>{t(document.kind)}</td>
              <td class="number">{document.version}</td>
              <td class="number">{bytes(document.size)}</td>
              <td>{when(document.change.at)}{document.change.actor !== '' && ` · ${document.change.actor}`}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
