// SPDX-License-Identifier: Apache-2.0
// Motion without standstills: a recording is dropped, evaluated, shown. Nothing is kept.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, made_of_files, offer, query, upload } from '../../api/client';
import { health } from '../../api/session';
import type { DynamicOptions, DynamicResult } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { FileDrop } from '../../components/file_drop';
import { use_settled } from '../../components/settled';
import { bytes } from '../../numbers';
import { decimal, language } from '../../settings';
import './dynamic.css';
import { DynamicFields } from './fields';
import { dynamic_options, empty_form, type DynamicForm } from './form';
import { held_recording } from './held';
import { t } from './texts';
import { DynamicView } from './view';

const said = (options: DynamicOptions): string => JSON.stringify(options);

interface Asked { result: DynamicResult | null; of: File | null; error: ApiError | null; busy: boolean; part: number }
const nothing: Asked = { result: null, of: null, error: null, busy: false, part: 0 };

/** Evaluates whenever file or options change; what an older request answers counts no more. */
function use_motion(file: File | null, options: string | null): Asked & { again: () => void } {
  const [asked, set_asked] = useState<Asked>(nothing);
  const [turn, set_turn] = useState(0);
  useEffect(() => {
    if (file === null) { set_asked(nothing); return undefined; }
    if (options === null) return undefined;
    const end = new AbortController();
    const still = (to: Partial<Asked>) => { if (!end.signal.aborted) set_asked((before) => ({ ...before, ...to })); };
    set_asked((before) => ({ ...before, result: before.of === file ? before.result : null, error: null, busy: true, part: 0 }));
    upload<DynamicResult>(`/api/dynamic${query({ options, language: language.value, decimal: decimal.value })}`, file, { signal: end.signal, progress: (part) => still({ part }) })
      .then((result) => still({ result, of: file, error: null, busy: false }))
      .catch((failure: unknown) => still({ error: as_error(failure), busy: false }));
    return () => end.abort();
  }, [file, options, language.value, decimal.value, turn]);
  return { ...asked, again: () => set_turn((n) => n + 1) };
}

export function DynamicPage() {
  const [file, set_file] = useState<File | null>(() => held_recording.peek());
  const [form, set_form] = useState<DynamicForm>(empty_form);
  useEffect(() => { held_recording.value = null; }, []);
  const limit = health.value?.limits.upload_bytes ?? Infinity;
  const is_too_large = file !== null && file.size > limit;
  const options = useMemo(() => { const found = dynamic_options(form); return found && said(found); }, [form]);
  const settled = use_settled(options);
  const asked = use_motion(is_too_large ? null : file, settled);
  const is_stale = asked.busy || asked.error !== null || options === null || options !== settled;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/captures">{t('captures')}</a></p>
          <h1 tabIndex={-1}>{t('title')}</h1>
        </div>
        {asked.result && file && settled !== null && <Downloads file={file} options={settled} />}
      </div>
      <p class="lead">{t('how')}</p>
      <div class="dynamic">
        <div class="stack">
          <section class="panel" aria-labelledby="dynamic-file">
            <header><h2 id="dynamic-file">{t('file')}</h2></header>
            {file && <p><strong class="file-name">{file.name}</strong> <span class="quiet small number">{bytes(file.size)}</span></p>}
            {is_too_large && <p class="notice bad" role="alert">{t('too_large', { size: bytes(file.size), limit: bytes(limit) })}</p>}
            <FileDrop label={t(file ? 'choose_other' : 'choose')} hint={t('drop')} of_page take={set_file} />
          </section>
          <section class="panel" aria-labelledby="dynamic-options">
            <header><h2 id="dynamic-options">{t('options')}</h2></header>
            <DynamicFields form={form} on_change={set_form} />
          </section>
        </div>
        <div class="stack" aria-busy={asked.busy}>
          <div aria-live="polite">
            {asked.busy && <p class="quiet small row">{t(asked.part < 1 ? 'sending' : 'evaluating')} {asked.part < 1 && (file?.size ?? 0) > 500_000 && <progress max={1} value={asked.part} aria-label={t('sending')} />}</p>}
            {asked.error && <FailureNotice error={asked.error} {...(asked.error.kind === 'bad_input' ? {} : { retry: asked.again })} />}
          </div>
          {file === null && <p class="panel quiet">{t('no_file')}</p>}
          {asked.result && <div class={`stack dynamic-outcome ${is_stale ? 'stale' : ''}`}><DynamicView result={asked.result} /></div>}
        </div>
      </div>
    </>
  );
}

const files = [
  { path: 'report.pdf', name: 'pdf' }, { path: 'report.html', name: 'html' }, { path: 'report.json', name: 'json' },
  { path: 'series.csv', name: 'samples_csv' }, { path: 'spectrum.csv', name: 'amplitudes_csv' },
] as const;

/** What the command line writes, made anew of the recording that is shown. */
function Downloads({ file, options }: { file: File; options: string }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const [making, set_making] = useState<string | null>(null);
  const stem = file.name.replace(/\.[^.]*$/, '');
  const make = (path: string) => {
    set_error(null);
    set_making(path);
    const told = path.startsWith('report') ? { decimal: decimal.value, download: 1 } : {};
    made_of_files(`/api/dynamic/${path}${query({ options, language: language.value, ...told })}`, file)
      .then(async (answer) => offer(new Blob([await answer.arrayBuffer()]), `${stem}-${path.replace('report', 'motion')}`), (failure: unknown) => set_error(as_error(failure)))
      .finally(() => set_making(null));
  };
  return (
    <div class="row no-print">
      {files.map(({ path, name }) => (
        <button key={path} type="button" disabled={making !== null} onClick={() => make(path)}>
          {name === 'samples_csv' || name === 'amplitudes_csv' ? t(name) : `${t('report')} ${name.toUpperCase()}`}
        </button>
      ))}
      {error && <FailureNotice error={error} />}
    </div>
  );
}
