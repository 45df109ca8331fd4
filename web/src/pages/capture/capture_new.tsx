// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import { use_get } from '../../api/use';
import type { Capture, Plan, PlanList, SourceList } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { position_unit, shortest } from '../../numbers';
import { go, place } from '../../router';
import { MotionFields, motion_options, size_unit_of, stops_of, without_motion } from './motion_fields';
import { t as t_motion } from './motion_texts';
import { sent, SourceChoice, SourceOptions, type SourceForm } from './source_fields';
import { t } from './texts';
import { is_of_positions, lasting } from '../plan/outcome';
import './capture.css';

interface Form extends SourceForm { plan: string }

/** Everything a capture needs to begin: a plan to wait for, a stream to listen to. */
export function NewCapturePage() {
  const plans = use_get<PlanList>('/api/plans');
  const sources = use_get<SourceList>('/api/sources');
  const [form, set_form] = useState<Form>({
    plan: place.value.query.get('plan') ?? '', source: '', layout: '', options: { speed: '10', preset: 'good', seed: '1' },
  });
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const chosen = form.plan || String(plans.data?.plans[0]?.id ?? '');
  const plan = use_get<Plan>(chosen === '' ? null : `/api/plans/${chosen}`);
  const motion = plan.data && !is_of_positions(plan.data.plan) ? plan.data.plan : null;
  const possible = sources.data?.sources ?? [];
  const source = possible.find(({ id }) => id === form.source) ?? possible[0];
  const simulated = source?.kind === 'simulator';
  const option = (key: string, text: string) => set_form({ ...form, options: { ...form.options, [key]: text } });

  const start = () => {
    if (!source || !plan.data || busy) return;
    set_busy(true);
    set_error(null);
    send<Capture>('POST', '/api/captures', {
      plan: Number(chosen), source: source.id, layout: form.layout,
      options: sent(motion ? motion_options(motion, form.options, simulated) : { ...without_motion(form.options), part: part_of(plan.data, form.options) },
        source, motion ? 'motion' : 'positions'),
    }).then(
      (capture) => go(`/captures/${capture.id}`),
      (failure: unknown) => {
        set_error(as_error(failure));
        set_busy(false);
      },
    );
  };
  if (plans.data?.plans.length === 0)
    return (
      <>
        <h1 tabIndex={-1}>{t('new_capture')}</h1>
        <p>{t('no_plans')}</p>
        <p><a class="button primary" href="/plans/new">{t('make_plan')}</a></p>
      </>
    );
  return (
    <>
      <h1 tabIndex={-1}>{t('new_capture')}</h1>
      {plans.error && <FailureNotice error={plans.error} retry={plans.reload} />}
      {sources.error && <FailureNotice error={sources.error} retry={sources.reload} />}
      <form class="panel new-capture" onSubmit={(event) => { event.preventDefault(); start(); }}>
        <Field label={t('plan')} hint={plan.data && summary(plan.data)}>
          {(ids) => (
            <select {...ids} value={chosen} onChange={(event) => set_form({ ...form, plan: event.currentTarget.value })}>
              {plans.data?.plans.map(({ id, title }) => <option key={id} value={String(id)}>{title}</option>)}
            </select>
          )}
        </Field>
        <Parts plan={motion ? null : plan.data} option={option} value={part_of(plan.data, form.options)} />
        {motion && <MotionFields plan={motion} options={form.options} option={option} simulated={simulated} />}
        <SourceChoice sources={possible} source={source} choose={(id) => set_form({ ...form, source: id })} />
        {motion && simulated && <p class="notice">{t_motion('will_be_simulated')}</p>}
        {source && (
          <SourceOptions source={source} form={form} change={(part) => set_form({ ...form, ...part })} unit={unit_of(plan.data)}
            {...(motion ? { of_motion: stops_of(form.options), size_unit: size_unit_of(motion, form.options) } : {})} />
        )}
        {error && <FailureNotice error={error} />}
        <div class="row">
          <button type="submit" class="primary" disabled={busy || !source || !plan.data}>{t(busy ? 'starting' : 'start')}</button>
        </div>
      </form>
    </>
  );
}

const unit_of = (plan: Plan | null) => position_unit(plan?.plan.axis.kind ?? 'linear');

function summary(plan: Plan): string {
  const [first, last] = [plan.targets[0], plan.targets[plan.targets.length - 1]];
  return `${plan.targets.length} × ${plan.plan.runs} · ${shortest(first)} … ${shortest(last)} ${unit_of(plan)} · ${lasting(plan.duration_s)}`;
}

/** Another plan may not have the part that was chosen of the one before. */
function part_of(plan: Plan | null, options: Readonly<Record<string, string>>): string {
  const chosen = options['part'] ?? '1';
  return Number(chosen) <= (plan?.plan.further?.length ?? 0) + 1 ? chosen : '1';
}

function Parts({ plan, option, value }: { plan: Plan | null; option: (key: string, text: string) => void; value: string }) {
  const further = plan?.plan.further ?? [];
  if (further.length === 0) return null;
  return (
    <Field label={t('part')}>
      {(ids) => (
        <select {...ids} value={value} onChange={(event) => option('part', event.currentTarget.value)}>
          <option value="1">1</option>
          {further.map((one, i) => <option key={i} value={String(i + 2)}>{`${i + 2} ${one.title ?? ''}`}</option>)}
        </select>
      )}
    </Field>
  );
}
