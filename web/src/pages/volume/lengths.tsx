// SPDX-License-Identifier: Apache-2.0
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files, offer, query } from '../../api/client';
import type { VolumetricAssembly, VolumetricMachine, VolumetricPlanFile, VolumetricResult } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { OptionsFields, form_of, options_of } from '../../components/evaluation_options';
import { FileDrop } from '../../components/file_drop';
import { KeepCalibration, type SentCalibration } from '../../components/keep_calibration';
import { use_settled } from '../../components/settled';
import { fixed } from '../../numbers';
import { set_query } from '../../router';
import { decimal, language } from '../../settings';
import { t as t_lengths } from '../capture/length_texts';
import { use_taken_lengths } from '../capture/taken_lengths';
import { AssemblyResult } from './assembly';
import { read_result } from './field';
import { is_assembly } from './model_parts';
import { ResidualChart } from './residuals';
import { VolumeResult } from './result';
import { t } from './texts';

const most_bytes = 7_500_000;  // of both files, as the server takes

/** What was sent, so that reports are of the same. */
interface Sent { lengths: File; machine: string; options: string }

const machine_file = ({ machine }: Sent): File => new File([machine], 'machine.json', { type: 'application/json' });

function form_data_of(sent: Sent): FormData {
  const form = new FormData();
  form.append('options', sent.options);
  form.append('machine', machine_file(sent), 'machine.json');
  form.append('lengths', sent.lengths, sent.lengths.name);
  return form;
}


interface Found { sent: Sent; kept_as: SentCalibration; result: VolumetricResult; residuals: string }

/** The same files and options as the archive wants them. */
const calibration_of = (sent: Sent): SentCalibration => ({
  kind: 'volumetric', files: { lengths: sent.lengths, machine: machine_file(sent) }, options: sent.options,
});

async function found_by(sent: Sent, signal: AbortSignal): Promise<Found> {
  const size = sent.lengths.size + sent.machine.length;
  if (size > most_bytes) throw new ApiError('refused', t('too_large', { n: fixed(size / 1e6, 1), most: most_bytes / 1e6 }), 0);
  const answer = await made_of_files(`/api/volumetric/identification${query({ decimal: decimal.value })}`, form_data_of(sent), signal);
  const result = (await answer.json()) as VolumetricResult;
  const residuals = await (await made_of_files('/api/volumetric/identification/residuals', form_data_of(sent), signal)).text();
  return { sent, kept_as: calibration_of(sent), result, residuals };
}

/** Lengths to errors; or a result that was found before. */
export function LengthsPanel({ machine: of_form }: { machine: VolumetricMachine | null }) {
  const [dropped, set_dropped] = useState<File | null>(null);
  const captured = use_taken_lengths('volume');
  const panel = useRef<HTMLHeadingElement>(null);
  const [form, set_form] = useState(() => form_of({}));
  const options = options_of('volumetric', form);
  const asked = use_settled(options && JSON.stringify(options));
  const [found, set_found] = useState<Found | null>(null);
  const [opened, set_opened] = useState<{ file: File; result: VolumetricResult | VolumetricAssembly } | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const taken = dropped === null ? captured.taken : null;
  const lengths = dropped ?? taken?.file ?? null;
  const machine = taken ? (taken.plan as VolumetricPlanFile).machine : of_form;
  const text = machine && JSON.stringify(machine);
  useEffect(() => {
    if (!captured.taken) return;
    set_dropped(null);
    panel.current?.scrollIntoView();
  }, [captured.taken]);
  const set_lengths = (file: File | null) => { set_query({ captures: null }); set_dropped(file); };
  const sent = useMemo((): Sent | null => (lengths && text && asked !== null ? { lengths, machine: text, options: asked } : null), [lengths, text, asked]);
  const spoken = language.value;
  useEffect(() => {
    if (!sent) return;
    const abort = new AbortController();
    set_error(null);
    set_busy(true);
    found_by(sent, abort.signal).then(
      (one) => { if (!abort.signal.aborted) { set_found(one); set_opened(null); set_busy(false); } },
      (thrown: unknown) => { if (!abort.signal.aborted) { set_found(null); set_error(as_error(thrown)); set_busy(false); } },
    );
    return () => abort.abort();
  }, [sent, spoken]);
  const open = (file: File) => {
    set_error(null);
    read_result(file).then((result) => { set_opened({ file, result }); set_found(null); set_lengths(null); }, (thrown: unknown) => set_error(as_error(thrown)));
  };
  useEffect(() => { if (opened) open(opened.file); }, [spoken]);
  const shown = found?.result ?? opened?.result ?? null;
  return (
    <>
      <section class="panel no-print" aria-labelledby="volume-lengths">
        <header><h2 id="volume-lengths" ref={panel}><span class="step">5</span>{t('lengths')}</h2></header>
        <div class="tracking-form">
          <p class="hint">{t('lengths_how')}</p>
          {taken && <p class="notice">{t('with_captured_plan')} {taken.is_simulated && t_lengths('simulated')}</p>}
          {captured.error && <FailureNotice error={captured.error} />}
          <FileDrop label={t('choose_lengths')} hint={`${t('drop_lengths')}. ${t('with_machine')}`} accept=".csv,.txt,text/csv" take={set_lengths}>
            {lengths && <span class="mono small">{lengths.name}</span>}
          </FileDrop>
          <div class="lengths-options"><OptionsFields kind="volumetric" form={form} on_change={set_form} /></div>
          <FileDrop label={t('choose_result')} hint={t('drop_result')} accept=".json,application/json" take={open}>
            {opened && <span class="mono small">{opened.file.name}</span>}
          </FileDrop>
        </div>
        {busy && <p class="quiet" role="status">{t('finding')}</p>}
        {error && <FailureNotice error={error} />}
      </section>
      {shown && is_assembly(shown) && <AssemblyResult result={shown} />}
      {shown && !is_assembly(shown) && <VolumeResult result={shown} taken={found && <Taken found={found} />} more={found && <ResidualChart csv={found.residuals} />} />}
    </>
  );
}

/** Buttons that take the result along. */
function Taken({ found }: { found: Found }) {
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const stem = found.sent.lengths.name.replace(/\.\w+$/, '');
  const save = async (path: string, name: string) => {
    set_busy(true);
    set_error(null);
    try {
      const answer = await made_of_files(`/api/volumetric/identification/${path}${query({ language: language.value, decimal: decimal.value })}`, form_data_of(found.sent));
      offer(new Blob([await answer.arrayBuffer()]), name);
    } catch (thrown) {
      set_error(as_error(thrown));
    }
    set_busy(false);
  };
  return (
    <>
      <KeepCalibration sent={found.kept_as} />
      {['pdf', 'html'].map((extension) => (
        <button key={extension} type="button" disabled={busy} onClick={() => void save(`report.${extension}`, `${stem}.${extension}`)}>{t('report')} {extension.toUpperCase()}</button>
      ))}
      <button type="button" disabled={busy} onClick={() => void save('report.json', `${stem}.result.json`)}>{t('result_file')} JSON</button>
      <button type="button" onClick={() => offer(new Blob([found.residuals], { type: 'text/csv' }), `${stem}.residuals.csv`)}>{t('residual_file')}</button>
      {error && <FailureNotice error={error} />}
    </>
  );
}
