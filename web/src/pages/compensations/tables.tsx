// SPDX-License-Identifier: Apache-2.0
// A table that a control has: read by its rule, drawn, and told as numbers. Nothing is kept.
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { CompensatedControl } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { bytes } from '../../numbers';
import './compensations.css';
import { AboutFormat, described_by } from './about';
import { use_read_table } from './asked';
import { TurnedSign } from './choices';
import { ControlChoice } from './control_choice';
import { TableChart } from './curves';
import { largest_table } from './existing';
import { counts_in_lengths, new_form, read_form, reading_numbers, reading_options, type TableForm } from './form';
import { held_table } from './held';
import { NumberFields } from './number_fields';
import { use_readers, type Readers } from './readers';
import { t } from './texts';
import { takes } from './uses';

const none: readonly CompensatedControl[] = [];

export function TablesPage() {
  const controls = use_get<CompensatedControl[]>('/api/controls');
  const [kind, set_kind] = useState<'linear' | 'rotary'>('linear');
  const [chosen, set_chosen] = useState<CompensatedControl | null>(null);
  const [file, set_file] = useState<File | null>(() => held_table.peek());
  const [form, set_form] = useState<TableForm>(new_form);
  const change = (part: Partial<TableForm>) => set_form((before) => ({ ...before, ...part }));
  useEffect(() => { held_table.value = null; }, []);
  const all = controls.data ?? none;
  const is_too_large = file !== null && file.size > largest_table;
  const readers = use_readers(chosen === null ? file : null, all, kind);
  const control = chosen ?? (readers.done && readers.found.length === 1 ? (readers.found[0] ?? null) : null);
  const { options, faults } = useMemo(() => (control ? read_form(control, kind, form, { keys: reading_numbers(control) }) : { options: null, faults: {} }), [control, kind, form]);
  const read = use_read_table(control?.id ?? null, options === null ? null : reading_options(options, kind), is_too_large ? null : file);
  const nodes = read.is_current && read.data ? read.data.table : null;
  const set_axis = (to: 'linear' | 'rotary') => { set_kind(to); if (chosen && !takes(chosen, to)) set_chosen(null); };
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/compensations">{t('title')}</a></p>
          <h1 tabIndex={-1}>{t('look_title')}</h1>
        </div>
      </div>
      <p class="lead">{t('look_how')}</p>
      {controls.error && <FailureNotice error={controls.error} retry={controls.reload} />}
      <div class="compensate">
        <div class="stack compensate-side">
          <section class="panel stack tight" aria-labelledby="look-file">
            <header><h2 id="look-file">{t('file')}</h2></header>
            {file && <p><strong class="file-name">{file.name}</strong> <span class="quiet small number">{bytes(file.size)}</span></p>}
            {is_too_large && <p class="notice bad" role="alert">{t('too_large', { size: bytes(file.size), limit: bytes(largest_table) })}</p>}
            <FileDrop label={t(file ? 'choose_other' : 'choose_table')} hint={t('drop_existing')} of_page take={set_file} />
            <Field label={t('kind')}>
              {(ids) => (
                <select {...ids} value={kind} onChange={(event) => set_axis(event.currentTarget.value as 'linear' | 'rotary')}>
                  <option value="linear">{t('linear')}</option><option value="rotary">{t('rotary')}</option>
                </select>
              )}
            </Field>
          </section>
          <section class="panel stack tight" aria-labelledby="look-control">
            <header><h2 id="look-control">{t('control')}</h2></header>
            {file && chosen === null && !is_too_large && <Candidates readers={readers} choose={set_chosen} />}
            {controls.data && <ControlChoice controls={all} kind={kind} chosen={control} choose={set_chosen} why={chosen === null ? t('only_reader') : null} is_turned={form.turned_sign} />}
            {control && (
              <>
                <TurnedSign {...{ control, form, change }} />
                {counts_in_lengths(control, kind) && <label><input type="checkbox" checked={form.inch} onChange={(event) => change({ inch: event.currentTarget.checked })} />{t('inch')}</label>}
                <details class="more">
                  <summary>{t('more_reading')}</summary>
                  <div class="table-options">
                    <Field label={t('axis_name')}>{(ids) => <input {...ids} autocomplete="off" placeholder="X" value={form.axis} onInput={(event) => change({ axis: event.currentTarget.value })} />}</Field>
                    <NumberFields keys={reading_numbers(control)} {...{ kind, form, change, faults }} />
                  </div>
                </details>
              </>
            )}
          </section>
        </div>
        <div class="stack" aria-busy={read.busy}>
          {file === null && <p class="panel quiet">{t('no_file')}</p>}
          {read.error && <FailureNotice error={read.error} {...(read.error.kind === 'bad_input' ? {} : { retry: read.again })} />}
          {nodes && read.data && control && (
            <>
              <TableChart table={null} existing={nodes} kind={read.data.kind} unit={read.data.unit} height={340} />
              <section class="panel" aria-labelledby="look-format">
                <header><h2 id="look-format">{t('format')}</h2></header>
                <AboutFormat {...described_by(control, form.turned_sign)} />
              </section>
            </>
          )}
        </div>
      </div>
    </>
  );
}

function Candidates({ readers, choose }: { readers: Readers; choose: (control: CompensatedControl) => void }) {
  if (readers.error) return <FailureNotice error={readers.error} />;
  const many = readers.found.length > 1;
  return (
    <div class={readers.done && readers.found.length === 0 ? 'notice bad' : many ? 'notice caution' : ''} role="status">
      <p>{t(!readers.done ? 'trying' : readers.found.length === 0 ? 'no_reader' : many ? 'several_readers' : 'one_reader')}</p>
      {many && <ul class="candidates">{readers.found.map((one) => <li key={one.id}><button type="button" class="link" onClick={() => choose(one)}>{one.title}</button> <span class="small quiet">{one.sign}</span></li>)}</ul>}
    </div>
  );
}
