// SPDX-License-Identifier: Apache-2.0
// Straightness, angles and squareness: files are dropped, evaluated, shown, and kept among the calibrations.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, made_of_files, offer, query } from '../../api/client';
import type { MotionResult } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { FileDrop } from '../../components/file_drop';
import { KeepCalibration, type SentCalibration } from '../../components/keep_calibration';
import { bytes } from '../../numbers';
import { decimal, language } from '../../settings';
import { empty_form, motion_options, type MotionForm, type MotionKind, type MotionOptions } from './form';
import { MotionFields } from './fields';
import { files_of, looked_at, roles, type MotionFile } from './files';
import { held_motions } from './held';
import { take_captured } from './captured';
import { PlanChoice } from './plan_choice';
import { t } from './texts';
import { MotionView } from './view';

function form_data(files: readonly MotionFile[], kind: MotionKind | null, options: MotionOptions): FormData {
  const form = new FormData();
  if (kind !== null) form.append('kind', kind);
  form.append('options', JSON.stringify(options));
  for (const [role, file] of Object.entries(roles(files))) form.append(role, file, file.name);
  return form;
}

interface Asked { result: MotionResult | null; error: ApiError | null; busy: boolean }

/** Evaluates whenever files or options change; what an older request answers counts no more. */
function use_motions(files: readonly MotionFile[], options: MotionOptions | null): Asked {
  const [asked, set_asked] = useState<Asked>({ result: null, error: null, busy: false });
  const said = JSON.stringify(options);
  useEffect(() => {
    if (files_of(files, false).length === 0) { set_asked({ result: null, error: null, busy: false }); return undefined; }
    if (options === null) return undefined;
    const end = new AbortController();
    set_asked((before) => ({ ...before, busy: true }));
    made_of_files(`/api/motions${query({ language: language.value, decimal: decimal.value })}`, form_data(files, null, options), end.signal)
      .then(async (answer) => set_asked({ result: (await answer.json()) as MotionResult, error: null, busy: false }))
      .catch((failure: unknown) => {
        if (end.signal.aborted) return;
        set_asked({ result: null, error: as_error(failure), busy: false });
      });
    return () => end.abort();
  }, [files, said, language.value, decimal.value]);
  return asked;
}

export function MotionsPage() {
  const [files, set_files] = useState<readonly MotionFile[]>([]);
  const [captured_error, set_captured_error] = useState<ApiError | null>(null);
  const [form, set_form] = useState<MotionForm>(empty_form);
  const [kind, set_kind] = useState<MotionKind>('straightness');   // as the last files turned out to be
  const options = useMemo(() => motion_options(kind, form), [kind, form]);
  const asked = use_motions(files, options);
  const add = async (more: readonly File[]) => {
    const looked = await Promise.all(more.map(looked_at));
    set_files((before) => [...before, ...looked]);
  };
  useEffect(() => {
    void add(held_motions.peek());
    held_motions.value = [];
    take_captured(add, set_captured_error);
  }, []);
  useEffect(() => { if (asked.result) set_kind(asked.result.result); }, [asked.result]);
  const sent = useMemo<SentCalibration | null>(
    () => (asked.result && options ? { kind: asked.result.result, files: roles(files), options: JSON.stringify(options) } : null), [asked.result]);
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/calibrations">{t('calibrations')}</a></p>
          <h1 tabIndex={-1}>{t('title')}</h1>
        </div>
        {sent && options && (
          <div class="row no-print">
            {(['pdf', 'html', 'json'] as const).map((extension) => <ReportButton key={extension} files={files} kind={sent.kind as MotionKind} options={options} extension={extension} />)}
            <KeepCalibration sent={sent} />
          </div>
        )}
      </div>
      <section class="panel">
        <p>{t('how')}</p>
        <FileDrop label={t('choose')} hint={t('drop')} accept=".csv,.txt,.json" of_page take={{ all: (more) => void add(more) }} />
        {files.length > 0 && (
          <ul class="plain-list">
            {files.map(({ file, is_plan }, k) => (
              <li key={k} class="row">
                <strong>{file.name}</strong> <span class="quiet small number">{bytes(file.size)}</span>
                {is_plan && <span class="quiet small">{plan_sign(files, k, kind)}</span>}
                <button type="button" class="plain" aria-label={t('take_away', { name: file.name })} onClick={() => set_files(files.filter((_, other) => other !== k))}>×</button>
              </li>
            ))}
          </ul>
        )}
        {files.length > 0 && (
          <div class="form-grid"><PlanChoice take={(plan) => void add([plan])} /></div>
        )}
        {files.length > 0 && (
          <details open>
            <summary>{t('options')}</summary>
            <MotionFields kind={kind} form={form} on_change={set_form} />
          </details>
        )}
      </section>
      <div aria-live="polite">
        {asked.busy && <p class="quiet small">{t('evaluating')}</p>}
        {captured_error && <FailureNotice error={captured_error} />}
        {asked.error && <FailureNotice error={asked.error} />}
      </div>
      {asked.result && <MotionView result={asked.result} />}
    </>
  );
}

/** Of a squareness it matters which line a plan is of: they are taken in the order in which they came. */
function plan_sign(files: readonly MotionFile[], index: number, kind: MotionKind): string {
  const n = files_of(files.slice(0, index + 1), true).length;
  return kind === 'squareness' ? t('plan_of_line', { n }) : t('plan');
}

function ReportButton({ files, kind, options, extension }: { files: readonly MotionFile[]; kind: MotionKind; options: MotionOptions; extension: string }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const make = () => {
    set_error(null);
    made_of_files(`/api/motions/report.${extension}${query({ language: language.value, decimal: decimal.value, download: 1 })}`, form_data(files, kind, options))
      .then(async (answer) => offer(await answer.blob(), `${kind}.${extension}`))
      .catch((failure: unknown) => set_error(as_error(failure)));
  };
  return <><button type="button" onClick={make}>{t('report')} {extension.toUpperCase()}</button>{error && <FailureNotice error={error} />}</>;
}
