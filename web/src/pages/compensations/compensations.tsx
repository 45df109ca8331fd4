// SPDX-License-Identifier: Apache-2.0
import type { CompensationList } from '../../api/types';
import { query } from '../../api/client';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { place, set_query } from '../../router';
import './compensations.css';
import { CompensationTable } from './list_table';
import { t } from './texts';

const most = 1000;

/** Every table that is kept, the newest first. */
export function CompensationsPage() {
  const withdrawn = place.value.query.get('withdrawn') === 'true';
  const list = use_get<CompensationList>(`/api/compensations${query({ withdrawn: withdrawn || null, limit: most })}`);
  const rows = list.data?.compensations;
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <div class="row no-print">
          <label class="check"><input type="checkbox" checked={withdrawn} onChange={(event) => set_query({ withdrawn: event.currentTarget.checked ? 'true' : null })} />{t('with_withdrawn')}</label>
          <a class="button" href="/tables">{t('look')}</a>
        </div>
      </div>
      {list.error && <FailureNotice error={list.error} retry={list.reload} />}
      {rows?.length === 0 && <p class="panel quiet">{t('none')} <a href="/">{t('to_tests')}</a></p>}
      {rows && rows.length > 0 && (
        <section class="panel flush list-page">
          <CompensationTable rows={rows} />
          {rows.length === most && <p class="small quiet foot">{t('newest', { n: most })}</p>}
        </section>
      )}
    </>
  );
}
