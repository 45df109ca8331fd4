// SPDX-License-Identifier: Apache-2.0
import type { CompensationHead } from '../../api/types';
import type { Loaded } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { CompensationTable } from './list_table';
import { t } from './texts';

/** The tables of an axis; nothing where it has none. */
export function TablesOfAxis({ list }: { list: Loaded<{ compensations: CompensationHead[] }> }) {
  if (list.error) return <FailureNotice error={list.error} retry={list.reload} />;
  const rows = list.data?.compensations ?? [];
  if (rows.length === 0) return null;
  return (
    <section class="panel flush">
      <header><h2>{t('title')}</h2></header>
      <CompensationTable rows={rows} with_axis={false} />
    </section>
  );
}
