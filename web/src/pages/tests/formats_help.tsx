// SPDX-License-Identifier: Apache-2.0
import type { Vocabulary } from '../../api/types';
import { use_get } from '../../api/use';
import { Drawer } from '../../components/dialog';
import { FailureNotice } from '../../components/failure';
import { Markdown } from '../../components/markdown';
import { t } from './texts';

/** Every format that can be read, with its manual. */
export function FormatsHelp({ on_close }: { on_close: () => void }) {
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  return (
    <Drawer title={t('formats_title')} on_close={on_close}>
      <p class="quiet">{t('formats_more')}</p>
      {vocabulary.error && <FailureNotice error={vocabulary.error} retry={vocabulary.reload} />}
      <div class="formats">
        {vocabulary.data?.formats.map((format) => (
          <details key={format.id}>
            <summary>{format.title} <span class="quiet mono small">{format.extensions}</span></summary>
            <Markdown source={format.manual} />
          </details>
        ))}
      </div>
    </Drawer>
  );
}
