// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import type { TestVersion } from '../api/types';
import { texts } from '../i18n/texts';
import { when } from '../numbers';
import { DataTable } from './table';

const t = texts({
  title: 'Versions',
  version: 'Version',
  at: 'When',
  actor: 'Who',
  reason: 'Why',
  none: 'no reason given',
});

/** Who changed it, when and why; the newest first. `cell` makes of a version's number what leads to it. */
export function VersionList({ versions, cell }: { versions: readonly TestVersion[]; cell?: (version: number) => ComponentChildren }) {
  return (
    <DataTable<TestVersion>
      caption={t('title')}
      rows={[...versions].sort((a, b) => b.version - a.version)}
      row_key={(row) => row.version}
      columns={[
        { key: 'version', head: t('version'), cell: (row) => (cell ? cell(row.version) : row.version), class: 'number-text' },
        { key: 'at', head: t('at'), cell: (row) => <span class="number">{when(row.at)}</span> },
        { key: 'actor', head: t('actor'), cell: (row) => row.actor },
        { key: 'reason', head: t('reason'), cell: (row) => row.reason || <span class="quiet">{t('none')}</span> },
      ]}
    />
  );
}
