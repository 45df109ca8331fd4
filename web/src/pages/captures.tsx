// SPDX-License-Identifier: Apache-2.0
import { use_get } from '../api/use';
import type { Capture } from '../api/types';
import { FailureNotice } from '../components/failure';
import { absent, when } from '../numbers';
import { t } from './capture/texts';
import './capture.css';

export function CapturesPage() {
  const captures = use_get<{ captures: Capture[] }>('/api/captures');
  const plans = use_get<{ plans: { id: number; title: string }[] }>('/api/plans');
  const title = (id: number) => plans.data?.plans.find((plan) => plan.id === id)?.title ?? `${t('plan')} ${id}`;
  const rows = captures.data?.captures ?? [];
  return (
    <>
      <header class="row spread">
        <h1 tabIndex={-1}>{t('captures')}</h1>
        <a class="button primary" href="/captures/new">{t('new_capture')}</a>
      </header>
      {captures.error && <FailureNotice error={captures.error} retry={captures.reload} />}
      {captures.data && rows.length === 0 && <p class="quiet">{t('none_yet')}</p>}
      {rows.length > 0 && (
        <section class="panel flush">
          <div class="table-frame" role="region" aria-label={t('captures')} tabIndex={0}>
            <table>
              <thead>
                <tr>
                  <th scope="col">{t('started')}</th>
                  <th scope="col">{t('plan')}</th>
                  <th scope="col">{t('source')}</th>
                  <th scope="col">{t('state')}</th>
                  <th scope="col">{t('test')}</th>
                </tr>
              </thead>
              <tbody>
                {rows.map((capture) => (
                  <tr key={capture.id}>
                    <th scope="row" class="number"><a href={`/captures/${capture.id}`}>{when(capture.started)}</a></th>
                    <td>{title(capture.plan)}</td>
                    <td>{capture.source.title}</td>
                    <td>{t(capture.state)}</td>
                    <td>{capture.test === null ? absent : <a href={`/tests/${capture.test}`}>{t('to_test')}</a>}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </section>
      )}
    </>
  );
}
