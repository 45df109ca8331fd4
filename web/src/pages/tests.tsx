// SPDX-License-Identifier: Apache-2.0
import { use_get } from '../api/use';
import type { TestPage } from '../api/types';
import { FailureNotice } from '../components/failure';
import { VerdictMark } from '../components/verdict';
import { texts } from '../i18n/texts';

const t = texts({ title: ['Tests', 'Prüfungen'] });

export function TestsPage() {
  const tests = use_get<TestPage>('/api/tests');
  return (
    <>
      <h1 tabIndex={-1}>{t('title')}</h1>
      {tests.error && <FailureNotice error={tests.error} retry={tests.reload} />}
      <ul>
        {tests.data?.tests.map((test) => (
          <li key={test.id}><a href={`/tests/${test.id}`}>{test.title}</a> <VerdictMark verdict={test.verdict} /></li>
        ))}
      </ul>
    </>
  );
}
