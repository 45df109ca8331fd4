// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { ApiError, made_of_files, offer, query } from '../../api/client';
import type { TrackingEvaluation, TrackingPlanFile } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { decimal, language } from '../../settings';
import type { LocatedStation } from './form';
import { Results } from './results';
import { t } from './texts';

const most_bytes = 15_000_000;  // of all files together, as the server takes

/** What was sent, so that reports are of the same. */
interface Sent { lengths: File; plan: File; station: File | null; options: string }

const as_file = (value: unknown, name: string): File => new File([JSON.stringify(value)], name, { type: 'application/json' });

function form_of({ lengths, plan, station, options }: Sent): FormData {
  const form = new FormData();
  form.append('options', options);
  form.append('plan', plan, plan.name);
  if (station) form.append('station', station, station.name);
  form.append('lengths', lengths, lengths.name);
  return form;
}

/** The lengths that were measured, and what comes of them. */
export function LengthsPanel({ plan, located }: { plan: TrackingPlanFile | null; located: LocatedStation | null }) {
  const [own_plan, set_own_plan] = useState<File | null>(null);
  const [lengths, set_lengths] = useState<File | null>(null);
  const [limits, set_limits] = useState('');
  const [reversed, set_reversed] = useState(false);
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const [found, set_found] = useState<{ sent: Sent; evaluation: TrackingEvaluation } | null>(null);
  const plan_file = own_plan ?? (plan && as_file(plan, 'lines.plan.json'));
  const asking = async (what: () => Promise<void>) => {
    set_busy(true);
    set_error(null);
    try { await what(); } catch (thrown) { set_error(thrown instanceof ApiError ? thrown : new ApiError('refused', String(thrown), 0)); }
    set_busy(false);
  };
  const evaluate = (file: File, with_plan: File | null) => void asking(async () => {
    set_lengths(file);
    set_found(null);
    if (with_plan === null) throw new ApiError('refused', t('no_plan'), 0);
    if (file.size + with_plan.size > most_bytes)
      throw new ApiError('refused', t('too_large', { n: Math.round((file.size + with_plan.size) / 1000), most: most_bytes / 1000 }), 0);
    const station = located && own_plan === null
      ? as_file({ station: located.position, covariance: located.covariance }, located.file.replace(/\.\w+$/, '.station.json')) : null;
    const tolerances = limits.split(/[\s;]+/).filter((word) => word !== '');
    const sent: Sent = { lengths: file, plan: with_plan, station, options: JSON.stringify({ tolerances, reversed }) };
    const answer = await made_of_files(`/api/tracking/evaluation${query({ decimal: decimal.value })}`, form_of(sent));
    set_found({ sent, evaluation: (await answer.json()) as TrackingEvaluation });
  });
  const save = (extension: string) => void asking(async () => {
    if (!found) return;
    const answer = await made_of_files(`/api/tracking/evaluation/report.${extension}${query({ language: language.value, decimal: decimal.value })}`, form_of(found.sent));
    offer(await answer.blob(), `${found.sent.lengths.name.replace(/\.\w+$/, '')}.${extension}`);
  });
  return (
    <section class="panel" aria-labelledby="tracking-lengths">
      <header>
        <h2 id="tracking-lengths"><span class="step">5</span>{t('lengths')}</h2>
        {found && (
          <div class="row no-print">
            {['pdf', 'html', 'json'].map((extension) => <button key={extension} type="button" disabled={busy} onClick={() => save(extension)}>{t('report')} {extension.toUpperCase()}</button>)}
          </div>
        )}
      </header>
      <div class="tracking-form no-print">
        <p class="hint">{t('lengths_how')}</p>
        <div class="lengths-options">
          <Field label={t('tolerances')} hint={t('tolerances_hint')}>
            {(ids) => <input {...ids} value={limits} autocomplete="off" spellcheck={false} placeholder="E=20um" onInput={(event) => set_limits(event.currentTarget.value)}
              onChange={() => { if (lengths) evaluate(lengths, plan_file); }} />}
          </Field>
          <label><input type="checkbox" checked={reversed} onChange={(event) => set_reversed(event.currentTarget.checked)} />{t('reversed')}</label>
        </div>
        <FileDrop label={t('choose_lengths')} hint={t('drop_lengths')} accept=".csv,.txt,text/csv" take={(file) => evaluate(file, plan_file)} />
        <div class="row">
          <span class="quiet small">
            {own_plan ? t('plan_of', { file: own_plan.name }) : plan ? t('plan_here') : t('no_plan')}
            {own_plan === null && plan && located && ` ${t('with_station', { file: located.file })}`}
          </span>
          <PlanChoice take={(file) => { set_own_plan(file); if (lengths) evaluate(lengths, file); }} />
          {own_plan && <button type="button" class="plain small" onClick={() => set_own_plan(null)}>{t('discard')}</button>}
        </div>
      </div>
      {error && <FailureNotice error={error} />}
      {found && <Results evaluation={found.evaluation} />}
    </section>
  );
}

function PlanChoice({ take }: { take: (file: File) => void }) {
  return (
    <label class="button plain small">
      {t('choose_plan')}
      <input type="file" class="visually-hidden" accept=".json,application/json" onChange={(event) => {
        const file = event.currentTarget.files?.[0];
        if (file) take(file);
        event.currentTarget.value = '';
      }} />
    </label>
  );
}
