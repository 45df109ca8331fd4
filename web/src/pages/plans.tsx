// SPDX-License-Identifier: Apache-2.0
import { useMemo } from 'preact/hooks';
import { use_get } from '../api/use';
import type { Change, Machine } from '../api/types';
import { FailureNotice } from '../components/failure';
import { absent, when } from '../numbers';
import { t } from './plan/texts';
import './plan.css';

interface PlanRow { id: number; version: number; title: string; axis: number | null; change: Change }

export function PlansPage() {
  const plans = use_get<{ plans: PlanRow[] }>('/api/plans');
  const machines = use_get<{ machines: Machine[] }>('/api/machines');
  const names = useMemo(() => {
    const all = (machines.data?.machines ?? []).flatMap((machine) => machine.axes.map((axis) => [axis.id, `${machine.name} · ${axis.name}`] as const));
    return new Map(all);
  }, [machines.data]);
  return (
    <>
      <header class="row spread">
        <h1 tabIndex={-1}>{t('plans')}</h1>
        <a class="button primary" href="/plans/new">{t('new_plan')}</a>
      </header>
      {plans.error && <FailureNotice error={plans.error} retry={plans.reload} />}
      {plans.data?.plans.length === 0 && <p class="quiet">{t('none_yet')}</p>}
      {plans.data && plans.data.plans.length > 0 && (
        <section class="panel flush">
          <div class="table-frame" role="region" aria-label={t('plans')} tabIndex={0}>
            <table>
              <thead>
                <tr>
                  <th scope="col">{t('title')}</th>
                  <th scope="col">{t('axis')}</th>
                  <th scope="col" class="number">{t('version')}</th>
                  <th scope="col">{t('changed')}</th>
                  <th scope="col"><span class="visually-hidden">{t('capture_with')}</span></th>
                </tr>
              </thead>
              <tbody>
                {plans.data.plans.map((plan) => (
                  <tr key={plan.id}>
                    <th scope="row"><a href={`/plans/${plan.id}`}>{plan.title}</a></th>
                    <td>{(plan.axis !== null && names.get(plan.axis)) || absent}</td>
                    <td class="number">{plan.version}</td>
                    <td>{when(plan.change.at)}{plan.change.actor !== '' && <span class="quiet"> · {plan.change.actor}</span>}</td>
                    <td><a href={`/captures/new?plan=${plan.id}`}>{t('capture_with')}</a></td>
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
