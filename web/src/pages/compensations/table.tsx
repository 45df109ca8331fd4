// SPDX-License-Identifier: Apache-2.0
// From a kept test to the table by which the control corrects its axis: what is chosen on the left, what comes of it beside it.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, get } from '../../api/client';
import type { CompensatedControl, CompensationHead, CompensationList, KeptCompensation, Machine, Test } from '../../api/types';
import { use_get } from '../../api/use';
import { day_seconds } from '../../components/dates';
import { FailureNotice } from '../../components/failure';
import { test_date } from '../../components/test_date';
import { place } from '../../router';
import './compensations.css';
import { use_made, use_read_table } from './asked';
import { ExistingUnit, TurnedSign } from './choices';
import { ControlChoice } from './control_choice';
import { ExistingPanel, file_of, largest_table, type Existing } from './existing';
import { as_usual, chosen_count, making_numbers, new_form, read_form, reading_options, type TableForm } from './form';
import { keep_control, kept_control } from './kept';
import { OptionsFields } from './options';
import { Outcome } from './outcome';
import { t } from './texts';
import { guessed, takes } from './uses';
import '../plan/plan.css';
import '../test/test.css';
import { test_path } from '../test/state';

export function TablePage({ parts }: { parts: Record<string, string> }) {
  const id = parts['id'] ?? '';
  const version = place.value.query.get('version');
  const test = use_get<Test>(test_path(id, '', { version }));
  const controls = use_get<CompensatedControl[]>('/api/controls');
  const of_test = use_get<CompensationList>(`/api/compensations?test=${encodeURIComponent(id)}`);
  const axis = test.data?.axis?.id ?? null;
  const of_axis = use_get<CompensationList>(axis === null ? null : `/api/compensations?axis=${axis}&limit=1`);
  const machine = use_get<Machine>(test.data?.machine ? `/api/machines/${test.data.machine.id}` : null);
  const failed = [test, controls, of_test, of_axis, machine].find(({ error, data }) => error !== null && data === null);
  if (failed?.error) return <><h1 tabIndex={-1}>{t('correct')}</h1><FailureNotice error={failed.error} retry={failed.reload} /></>;
  const waits = !test.data || String(test.data.id) !== id || !controls.data || !of_test.data || (axis !== null && !of_axis.data) || (test.data.machine && !machine.data);
  if (waits || !test.data || !controls.data) return <><h1 tabIndex={-1} class="visually-hidden">{t('correct')}</h1><p class="slow quiet" role="status">{t('loading')}</p></>;
  const active = of_test.data?.compensations.find(({ retest }) => retest?.id === test.data?.id) ?? null;
  return <Correct key={`${test.data.id}.${test.data.version}`} test={test.data} controls={controls.data} active={active} last={of_axis.data?.compensations[0] ?? null} words={machine.data?.controller ?? ''} />;
}

/** Which control to begin with: that of the table before, that of this machine in this browser, that which the machine's own words mean. */
function first_control(controls: readonly CompensatedControl[], kind: 'linear' | 'rotary', test: Test, last: CompensationHead | null, words: string): { control: CompensatedControl | null; why: string | null } {
  const named = (id: string | null | undefined) => controls.find((one) => one.id === id && takes(one, kind)) ?? null;
  const before = named(last?.control.id);
  if (before && last) return { control: before, why: t('as_table', { id: last.id }) };
  const kept = named(kept_control(test.machine?.id ?? null));
  if (kept) return { control: kept, why: t('as_last') };
  const meant = guessed(words, controls, kind);
  return { control: meant, why: meant && t('guessed', { words }) };
}

/** The last table of the axis, where it was made of an earlier test: it may have been active. */
function earlier_table(last: CompensationHead | null, test: Test): CompensationHead | null {
  const day = day_seconds(test.result.metadata.test?.date ?? '') ?? Infinity;
  return last !== null && last.test.id !== test.id && (day_seconds(last.test.measured_on) ?? -Infinity) <= day ? last : null;
}

/** How the numbers of a table of the archive are meant: who takes it means them so too. */
const meant_by = ({ options }: KeptCompensation): Partial<TableForm> => ({ turned_sign: options.turned_sign === true, existing_unit: options.inch === true ? 'inch' : null });

interface Props { test: Test; controls: readonly CompensatedControl[]; active: CompensationHead | null; last: CompensationHead | null; words: string }

function Correct({ test, controls, active, last, words }: Props) {
  const { kind } = test.result.axis;
  const [{ control, why }, set_control] = useState(() => first_control(controls, kind, test, last, words));
  const [form, set_form] = useState<TableForm>(new_form);
  const [existing, set_existing] = useState<Existing | null>(null);
  const [untaken, set_untaken] = useState<ApiError | null>(null);
  const change = (part: Partial<TableForm>) => set_form((before) => ({ ...before, ...part }));
  const expected_period = test.result.metadata.axis?.expected_period || null;
  const with_existing = existing !== null;
  const { options, faults } = useMemo(() => (
    control ? read_form(control, kind, form, { keys: making_numbers(control), expected_period, with_existing }) : { options: null, faults: {} }
  ), [control, kind, form, expected_period, with_existing]);
  const loaded = active ?? earlier_table(last, test);
  const take_loaded = () => {
    if (loaded === null) return;
    set_untaken(null);
    Promise.all([file_of(loaded), get<KeptCompensation>(`/api/compensations/${loaded.id}`)]).then(([file, kept]) => {
      set_existing({ file, of: loaded.id });
      change(meant_by(kept));
    }, (error: unknown) => set_untaken(as_error(error)));
  };
  // The table that this test proves was active while it was measured: without it the new one would lack what it does.
  useEffect(() => { if (active !== null && active.control.id === control?.id) take_loaded(); }, []);
  const choose = (one: CompensatedControl) => {
    keep_control(test.machine?.id ?? null, one.id);
    set_control({ control: one, why: null });
    if (existing !== null && existing.of !== null && one.id !== loaded?.control.id) set_existing(null);
  };
  const file = existing !== null && existing.file.size <= largest_table ? existing.file : null;
  const read = use_read_table(control?.id ?? null, options === null ? null : reading_options(options, kind), file);
  const is_too_large = existing !== null && file === null;
  const made = use_made(test.id, test.version, is_too_large || read.error !== null ? null : options, file);
  const axis = test.axis?.name || test.result.axis.name;
  const changed = chosen_count(options);
  const wrong = Object.keys(faults).length;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href={`/tests/${test.id}${test.version === test.latest ? '' : `?version=${test.version}`}`}>{test.title}</a> · {test_date(test)}</p>
          <h1 tabIndex={-1}>{axis ? t('correct_axis', { axis }) : t('correct')}</h1>
        </div>
      </div>
      {test.version !== test.latest && <p class="notice caution">{t('older_test', { n: test.version, latest: test.latest })} <a href={`/tests/${test.id}/table`}>{t('to_latest')}</a></p>}
      {test.withdrawn && <p class="notice caution">{t('withdrawn_test')}</p>}
      <div class="compensate">
        <div class="stack compensate-side">
          <section class="panel" aria-labelledby="table-control">
            <header><h2 id="table-control">{t('control')}</h2></header>
            <ControlChoice controls={controls} kind={kind} chosen={control} choose={choose} why={why} is_turned={form.turned_sign} />
            {control && <TurnedSign {...{ control, form, change }} />}
          </section>
          {control && (
            <section class="panel" aria-labelledby="table-existing">
              <header><h2 id="table-existing">{t('existing')}</h2></header>
              <ExistingPanel existing={existing} set={set_existing} read={read} loaded={loaded} is_proved={active !== null} control={control} take_loaded={take_loaded}>
                <ExistingUnit {...{ control, kind, form, change }} />
              </ExistingPanel>
              {untaken !== null && <FailureNotice error={untaken} retry={take_loaded} />}
            </section>
          )}
          {control && (
            <details class="panel more">
              <summary><strong>{t('more')}</strong> <span class="quiet small">{wrong > 0 ? t('more_wrong', { n: wrong }) : changed > 0 ? t('more_changed', { n: changed }) : t('more_usual')}</span></summary>
              <OptionsFields {...{ control, kind, form, change, faults, axis, expected_period, with_existing }} />
              {(changed > 0 || wrong > 0) && <button type="button" class="small" onClick={() => set_form(as_usual)}>{t('usual')}</button>}
            </details>
          )}
        </div>
        <Outcome {...{ test, control, options, made, existing }} file={file} read={read.is_current ? (read.data?.table ?? null) : null} wrong={wrong} is_turned={form.turned_sign} />
      </div>
    </>
  );
}
