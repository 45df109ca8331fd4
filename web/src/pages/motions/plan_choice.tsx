// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, bytes_of } from '../../api/client';
import { use_get } from '../../api/use';
import type { PlanList } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { t } from './texts';

/** One of the archive's plans, as its file; nothing where there are none. */
export function PlanChoice({ take }: { take: (plan: File) => void }) {
  const plans = use_get<PlanList>('/api/plans');
  const [error, set_error] = useState<ApiError | null>(null);
  if (plans.error) return <FailureNotice error={plans.error} retry={plans.reload} />;
  const all = plans.data?.plans ?? [];
  if (all.length === 0) return null;
  const choose = (id: string) => {
    const plan = all.find((one) => String(one.id) === id);
    if (!plan) return;
    set_error(null);
    bytes_of(`/api/plans/${plan.id}/plan.json`)
      .then((bytes) => take(new File([bytes], `${plan.title}.plan.json`)))
      .catch((failure: unknown) => set_error(as_error(failure)));
  };
  return (
    <>
      <Field label={t('plan_of_archive')} hint={t('plan_hint')}>
        {(ids) => (
          <select {...ids} value="" onChange={(event) => { choose(event.currentTarget.value); event.currentTarget.value = ''; }}>
            <option value="">{t('no_plan')}</option>
            {all.map((plan) => <option key={plan.id} value={String(plan.id)}>{plan.title}</option>)}
          </select>
        )}
      </Field>
      {error && <FailureNotice error={error} />}
    </>
  );
}
