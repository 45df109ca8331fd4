// SPDX-License-Identifier: Apache-2.0
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files, offer, query } from '../../api/client';
import type { TrackingEvaluation, TrackingPlanFile } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { OptionsFields, form_of, options_of } from '../../components/evaluation_options';
import { FileDrop } from '../../components/file_drop';
import { KeepCalibration, type SentCalibration } from '../../components/keep_calibration';
import { use_settled } from '../../components/settled';
import { set_query } from '../../router';
import { decimal, language } from '../../settings';
import { t as t_lengths } from '../capture/length_texts';
import { use_taken_lengths } from '../capture/taken_lengths';
import { bounds_of, type LocatedStation } from './form';
import { Results } from './results';
import { t } from './texts';

const most_bytes = 15_000_000;  // of all files together, as the server takes

/** What was sent, so that reports are of the same. */
interface Sent { lengths: File; plan: File; station: File | null; options: string }

const as_file = (text: string, name: string): File => new File([text], name, { type: 'application/json' });

function form_data_of({ lengths, plan, station, options }: Sent): FormData {
  const form = new FormData();
  form.append('options', options);
  form.append('plan', plan, plan.name);
  if (station) form.append('station', station, station.name);
  form.append('lengths', lengths, lengths.name);
  return form;
}


function check_size(...files: File[]): void {
  const size = files.reduce((sum, file) => sum + file.size, 0);
  if (size > most_bytes) throw new ApiError('refused', t('too_large', { n: Math.round(size / 1000), most: most_bytes / 1000 }), 0);
}

interface Found { sent: Sent; evaluation: TrackingEvaluation }

/** What comes of files, anew whenever one of them or an option changes; the last good result goes with its files. */
function use_evaluation(sent: Sent | null): { found: Found | null; error: ApiError | null } {
  const [found, set_found] = useState<Found | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const spoken = language.value;
  useEffect(() => {
    set_error(null);
    if (sent === null) return;
    const abort = new AbortController();
    const asked = async () => {
      check_size(sent.lengths, sent.plan);
      const answer = await made_of_files(`/api/tracking/evaluation${query({ decimal: decimal.value })}`, form_data_of(sent), abort.signal);
      return (await answer.json()) as TrackingEvaluation;
    };
    asked().then(
      (evaluation) => { if (!abort.signal.aborted) set_found({ sent, evaluation }); },
      (thrown: unknown) => {
        if (abort.signal.aborted) return;
        set_found(null);
        set_error(as_error(thrown));
      },
    );
    return () => abort.abort();
  }, [sent, spoken]);
  return { found, error };
}

/** The lengths that were measured, and what comes of them. */
export function LengthsPanel({ plan, located }: { plan: TrackingPlanFile | null; located: LocatedStation | null }) {
  const [chosen_plan, set_own_plan] = useState<File | null>(null);
  const [dropped, set_dropped] = useState<File | null>(null);
  const captured = use_taken_lengths('lines');
  const heading = useRef<HTMLHeadingElement>(null);
  const taken = dropped === null ? captured.taken : null;
  const lengths = dropped ?? taken?.file ?? null;
  const captured_plan = useMemo(() => (taken ? as_file(JSON.stringify(taken.plan), 'lines.plan.json') : null), [taken]);
  const own_plan = captured_plan ?? chosen_plan;
  const set_lengths = (file: File) => { set_query({ captures: null }); set_dropped(file); };
  useEffect(() => {
    if (!captured.taken) return;
    set_dropped(null);
    heading.current?.scrollIntoView();
  }, [captured.taken]);
  const [form, set_form] = useState(() => form_of({}));
  const options = options_of('lines', form);
  const asked = use_settled(options && JSON.stringify(options));
  const [busy, set_busy] = useState(false);
  const [not_saved, set_not_saved] = useState<ApiError | null>(null);
  const plan_text = own_plan === null && plan !== null ? JSON.stringify(plan) : null;
  const station_text = own_plan === null && located !== null ? JSON.stringify({ station: located.position, covariance: bounds_of(located) }) : null;
  const sent = useMemo((): Sent | null => {
    const plan_file = own_plan ?? (plan_text === null ? null : as_file(plan_text, 'lines.plan.json'));
    if (lengths === null || plan_file === null || asked === null) return null;
    const station = station_text === null || located === null ? null : as_file(station_text, located.file.replace(/\.\w+$/, '.station.json'));
    return { lengths, plan: plan_file, station, options: asked };
  }, [lengths, own_plan, plan_text, station_text, asked]);
  const { found, error } = use_evaluation(sent);
  const to_keep = useMemo((): SentCalibration | null => (found ? { kind: 'lines', files: { lengths: found.sent.lengths, plan: found.sent.plan, station: found.sent.station }, options: found.sent.options } : null), [found?.sent]);
  const save = async (extension: string) => {
    if (!found) return;
    set_busy(true);
    set_not_saved(null);
    try {
      const answer = await made_of_files(`/api/tracking/evaluation/report.${extension}${query({ language: language.value, decimal: decimal.value })}`, form_data_of(found.sent));
      offer(await answer.blob(), `${found.sent.lengths.name.replace(/\.\w+$/, '')}.${extension}`);
    } catch (thrown) {
      set_not_saved(as_error(thrown));
    }
    set_busy(false);
  };
  return (
    <section class="panel" aria-labelledby="tracking-lengths">
      <header>
        <h2 id="tracking-lengths" ref={heading}><span class="step">6</span>{t('lengths')}</h2>
        {found && (
          <div class="row no-print">
            {['pdf', 'html', 'json'].map((extension) => <button key={extension} type="button" disabled={busy} onClick={() => void save(extension)}>{t('report')} {extension.toUpperCase()}</button>)}
            {to_keep && <KeepCalibration sent={to_keep} />}
          </div>
        )}
      </header>
      <div class="tracking-form no-print">
        <p class="hint">{t('lengths_how')}</p>
        {taken?.is_simulated && <p class="notice">{t_lengths('simulated')}</p>}
        {captured.error && <FailureNotice error={captured.error} />}
        <FileDrop label={t('choose_lengths')} hint={t('drop_lengths')} accept=".csv,.txt,text/csv" take={set_lengths}>
          {lengths && <span class="mono small">{lengths.name}</span>}
        </FileDrop>
        <div class="row">
          <span class="quiet small">
            {taken ? t('with_captured_plan') : own_plan ? t('plan_of', { file: own_plan.name }) : plan ? t('plan_here') : t('no_plan')}
            {station_text !== null && located && ` ${t('with_station', { file: located.file })}`}
          </span>
          {!taken && <PlanChoice take={set_own_plan} />}
          {!taken && own_plan && <button type="button" class="plain small" onClick={() => set_own_plan(null)}>{t('discard')}</button>}
        </div>
        <div class="lengths-options">
          <OptionsFields kind="lines" form={form} on_change={set_form} />
        </div>
      </div>
      {not_saved && <FailureNotice error={not_saved} />}
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
