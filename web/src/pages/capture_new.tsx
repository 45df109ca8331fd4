// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { ApiError, send } from '../api/client';
import { use_get } from '../api/use';
import type { Capture, Plan, PlanList, Source, SourceList } from '../api/types';
import { FailureNotice } from '../components/failure';
import { Field } from '../components/field';
import { parsed, position_unit, shortest } from '../numbers';
import { go, place } from '../router';
import { layouts, of_option, option_keys, t } from './capture/texts';
import { lasting } from './plan/outcome';
import './capture.css';

type Texts = Record<string, string>;
interface Form { plan: string; source: string; layout: string; options: Texts }

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
  const source = sources.data?.sources.find(({ id }) => id === form.source) ?? sources.data?.sources[0];
  const option = (key: string, text: string) => set_form({ ...form, options: { ...form.options, [key]: text } });

  const start = () => {
    if (!source || chosen === '' || busy) return;
    set_busy(true);
    set_error(null);
    send<Capture>('POST', '/api/captures', {
      plan: Number(chosen), source: source.id, layout: form.layout, options: sent(form.options, source),
    }).then(
      (capture) => go(`/captures/${capture.id}`),
      (failure: unknown) => {
        set_error(failure instanceof ApiError ? failure : new ApiError('refused', String(failure), 0));
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
        <Parts plan={plan.data} option={option} value={form.options['part'] ?? '1'} />
        <Field label={t('source')} hint={t('sources_hint')}>
          {(ids) => (
            <select {...ids} value={source?.id ?? ''} onChange={(event) => set_form({ ...form, source: event.currentTarget.value })}>
              {sources.data?.sources.map(({ id, title, kind }) => <option key={id} value={id}>{kind === 'simulator' ? title : `${title} (${t(kind)})`}</option>)}
            </select>
          )}
        </Field>
        {source?.kind === 'simulator'
          ? <SimulatorFields source={source} options={form.options} option={option} />
          : source && <StreamFields form={form} change={set_form} option={option} unit={unit_of(plan.data)} />}
        {error && <FailureNotice error={error} />}
        <div class="row">
          <button type="submit" class="primary" disabled={busy || !source || chosen === ''}>{t(busy ? 'starting' : 'start')}</button>
        </div>
      </form>
    </>
  );
}

const simulator_keys = ['speed', 'preset', 'seed'];

/** Of what was typed only what concerns the source, numbers with a point. */
function sent(options: Texts, source: Source): Texts {
  const concerns = (key: string) => key === 'part' || simulator_keys.includes(key) === (source.kind === 'simulator');
  const entries = Object.entries(options).filter(([key, text]) => text.trim() !== '' && concerns(key));
  return Object.fromEntries(entries.map(([key, text]) => [key, parsed(text) === null ? text.trim() : String(parsed(text))]));
}

const unit_of = (plan: Plan | null) => position_unit(plan?.plan.axis.kind ?? 'linear');

function summary(plan: Plan): string {
  const [first, last] = [plan.targets[0], plan.targets[plan.targets.length - 1]];
  return `${plan.targets.length} × ${plan.plan.runs} · ${shortest(first)} … ${shortest(last)} ${unit_of(plan)} · ${lasting(plan.duration_s)}`;
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

function SimulatorFields({ source, options, option }: { source: Source; options: Texts; option: (key: string, text: string) => void }) {
  const presets = source.presets ?? [];
  return (
    <div class="pair">
      <Field label={t('fault')} hint={presets.find(({ id }) => id === options['preset'])?.sign}>
        {(ids) => (
          <select {...ids} value={options['preset'] ?? ''} onChange={(event) => option('preset', event.currentTarget.value)}>
            {presets.map(({ id, title }) => <option key={id} value={id}>{title}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('speed')} hint={t('speed_hint')}>
        {(ids) => (
          <select {...ids} class="number" value={options['speed'] ?? ''} onChange={(event) => option('speed', event.currentTarget.value)}>
            {(source.speeds ?? [1]).map((speed) => <option key={speed} value={String(speed)}>{shortest(speed)}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('seed')}>
        {(ids) => <input {...ids} class="number" inputMode="numeric" value={options['seed'] ?? ''} onInput={(event) => option('seed', event.currentTarget.value)} />}
      </Field>
    </div>
  );
}

function StreamFields({ form, change, option, unit }: { form: Form; change: (form: Form) => void; option: (key: string, text: string) => void; unit: string }) {
  return (
    <>
      <Field label={t('layout')}>
        {(ids) => (
          <select {...ids} value={form.layout} onChange={(event) => change({ ...form, layout: event.currentTarget.value })}>
            <option value="">{t('recognised')}</option>
            {layouts.map((id) => <option key={id} value={id}>{id}</option>)}
          </select>
        )}
      </Field>
      <details>
        <summary>{t('more')}</summary>
        <div class="pair">
          {option_keys.map((key) => (
            <Field key={key} label={of_option(key, { unit })}>
              {(ids) => (
                <input {...ids} class="number" inputMode="decimal" placeholder={t('auto')} value={form.options[key] ?? ''}
                  onInput={(event) => option(key, event.currentTarget.value)} />
              )}
            </Field>
          ))}
        </div>
        <div class="boxes">
          <label>
            <input type="checkbox" checked={form.options['reverse'] === '1'} onChange={(event) => option('reverse', event.currentTarget.checked ? '1' : '')} />
            {of_option('reverse')}
          </label>
          <label>
            <input type="checkbox" checked={form.options['zero'] === 'first-target'} onChange={(event) => option('zero', event.currentTarget.checked ? 'first-target' : '')} />
            {of_option('zero')}
          </label>
        </div>
      </details>
    </>
  );
}
