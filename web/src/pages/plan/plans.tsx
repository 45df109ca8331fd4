// SPDX-License-Identifier: Apache-2.0
import { useMemo, useState } from 'preact/hooks';
import { use_get } from '../../api/use';
import type { MachineList, PlanList, PlanRow } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { ListPage } from '../../components/list_page';
import { absent, when } from '../../numbers';
import { ImportPlans, type Refused } from './import';
import { t } from './texts';
import './plan.css';
import { colon } from '../../i18n/colon';

export function PlansPage() {
  const plans = use_get<PlanList>('/api/plans');
  const machines = use_get<MachineList>('/api/machines');
  const [refused, set_refused] = useState<Refused[]>([]);
  const names = useMemo(() => {
    const all = (machines.data?.machines ?? []).flatMap((machine) => machine.axes.map((axis) => [axis.id, `${machine.name} · ${axis.name}`] as const));
    return new Map(all);
  }, [machines.data]);
  const axis_of = (plan: PlanRow) => (plan.axis === null ? undefined : names.get(plan.axis));
  return (
    <ListPage<PlanRow>
      title={t('plans')} asked={plans} rows={plans.data?.plans} none={t('none_yet')} row_key={(plan) => plan.id}
      actions={
        <>
          <ImportPlans refused={set_refused} done={plans.reload} />
          <a class="button primary" href="/plans/new">{t('new_plan')}</a>
        </>
      }
      columns={[
        { key: 'title', head: t('title'), row_head: true, cell: (plan) => (
          <>
            <a href={`/plans/${plan.id}`}>{plan.title}</a>
            <span class="only-narrow quiet small">{[axis_of(plan), `${t('version')} ${plan.version}`, when(plan.change.at)].filter(Boolean).join(' · ')}</span>
          </>
        ) },
        { key: 'axis', head: t('axis'), class: 'wide-only', cell: (plan) => axis_of(plan) ?? absent },
        { key: 'version', head: t('version'), number: true, class: 'wide-only', cell: (plan) => plan.version },
        { key: 'changed', head: t('changed'), class: 'wide-only', cell: (plan) => (
          <><span class="number-text">{when(plan.change.at)}</span>{plan.change.actor !== '' && <span class="quiet"> · {plan.change.actor}</span>}</>
        ) },
        { key: 'capture', head: <span class="visually-hidden">{t('capture_with')}</span>, cell: (plan) => (
          <a href={`/captures/new?plan=${plan.id}`} aria-label={`${t('capture_with')}${colon()} ${plan.title}`}>{t('capture')}</a>
        ) },
      ]}
    >
      {refused.map(({ name, error }) => <div key={name}><h2 class="small">{name}</h2><FailureNotice error={error} /></div>)}
    </ListPage>
  );
}
