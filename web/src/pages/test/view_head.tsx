// SPDX-License-Identifier: Apache-2.0
// The head of a page that looks at a kept test in another way than its own page: back to it, and what can be taken along.
import { query } from '../../api/client';
import type { Test } from '../../api/types';
import { test_date } from '../../components/test_date';
import { Withdrawn } from '../../components/withdrawn';
import { texts } from '../../i18n/texts';

const t = texts({ report: 'Report', older: 'Of version {n}; the latest is {latest}.', to_latest: 'to the latest' });

/** `view` is the last part of its path, `report` where a document of it is; null while there is none. */
export function ViewHead({ test, title, view, report }:
  { test: Test; title: string; view: string; report: ((extension: string, download: number | null) => string) | null }) {
  const version = test.version === test.latest ? null : test.version;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href={`/tests/${test.id}${query({ version })}`}>{test.title}</a> · {test_date(test)} <Withdrawn test={test} /></p>
          <h1 tabIndex={-1}>{title}</h1>
        </div>
        {report && (
          <div class="row no-print">
            <a class="button primary" href={report('html', null)} target="_blank" rel="noopener">{t('report')}</a>
            {['pdf', 'csv', 'json'].map((one) => <a key={one} class="button" href={report(one, 1)} download>{one.toUpperCase()}</a>)}
          </div>
        )}
      </div>
      {version !== null && <p class="notice caution">{t('older', { n: test.version, latest: test.latest })} <a href={`/tests/${test.id}/${view}`}>{t('to_latest')}</a></p>}
    </>
  );
}
