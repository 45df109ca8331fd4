// SPDX-License-Identifier: Apache-2.0
// From the 21 errors to the table of one axis for a control: which control, which axis, what it moves, and what remains.
import { useMemo, useState } from 'preact/hooks';
import { query } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { CompensatedControl, VolumetricCompensation } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { fixed } from '../../numbers';
import { decimal } from '../../settings';
import '../compensations/compensations.css';
import { AboutFormat, TableText, described_by } from '../compensations/about';
import { CurvesField, TurnedSign } from '../compensations/choices';
import { ControlChoice } from '../compensations/control_choice';
import { TableChart } from '../compensations/curves';
import { counts_in_lengths, new_form, offered_numbers, read_form, type TableForm } from '../compensations/form';
import { NumberFields } from '../compensations/number_fields';
import { Refused } from '../compensations/refused';
import { t as words } from '../compensations/texts';
import { takes } from '../compensations/uses';
import { axes, type Axis } from './error_names';
import { VolumeFindings } from './findings';
import { given_model, machine_of, type Modelled } from './model_parts';
import { t } from './result_texts';

export function ControlTablePanel({ result }: { result: Modelled }) {
  const { model } = result;
  const controls = use_get<CompensatedControl[]>('/api/controls');
  const { tools } = useMemo(() => machine_of(model), [model]);
  const [along, set_along] = useState<Axis>('X');
  const [moved, set_moved] = useState<Axis | null>(null);   // null: the axis itself
  const [tool, set_tool] = useState('');
  const [wanted, set_wanted] = useState<CompensatedControl | null>(null);
  const [form, set_form] = useState<TableForm>(new_form);
  const [output, set_output] = useState('');
  const change = (part: Partial<TableForm>) => set_form((before) => ({ ...before, ...part }));
  const is_cross = moved !== null && moved !== along;
  const able = useMemo(() => (controls.data ?? []).filter(({ cross }) => cross || !is_cross), [controls.data, is_cross]);
  const can = (one: CompensatedControl) => is_cross || takes(one, 'linear');   // some have cross tables alone
  const control = wanted !== null && able.includes(wanted) && can(wanted) ? wanted : null;
  const chosen_tool = tools.includes(tool) ? tool : (tools[0] ?? '');
  const { options, faults } = useMemo(() => (control ? read_form(control, 'linear', form) : { options: null, faults: {} }), [control, form]);
  const body = useMemo(() => options && {
    ...given_model(result), along, ...(is_cross ? { component: moved } : {}), tool: chosen_tool, options,
    ...(is_cross && output.trim() !== '' ? { output_axis: output.trim() } : {}),
  }, [result, along, moved, is_cross, chosen_tool, options, output]);
  const made = use_posted<VolumetricCompensation>(`/api/volumetric/compensation${query({ decimal: decimal.value })}`, body, as_json);
  const shown = body !== null && made.error === null ? made.data : null;
  const stale = !made.is_current;
  const select = (label: string, value: string, all: readonly (readonly [string, string])[], take: (value: string) => void) => (
    <Field label={label}>
      {(ids) => <select {...ids} value={value} onChange={(event) => take(event.currentTarget.value)}>{all.map(([key, text]) => <option key={key} value={key}>{text}</option>)}</select>}
    </Field>
  );
  const named = (label: string, value: string, placeholder: string, take: (text: string) => void) => (
    <Field label={label}>
      {(ids) => <input {...ids} autocomplete="off" placeholder={placeholder} value={value} onInput={(event) => take(event.currentTarget.value)} />}
    </Field>
  );
  return (
    <>
      <section class="panel control-table" aria-labelledby="volume-control-table" aria-busy={body !== null && stale && made.error === null}>
        <header><h2 id="volume-control-table">{t('axis_table')}</h2></header>
        <p class="quiet">{t('axis_table_how')}</p>
        <div class="field-controls no-print">
          {select(t('along'), along, axes.map((letter) => [letter, letter]), (letter) => set_along(letter as Axis))}
          {select(t('moves'), is_cross ? moved : along, axes.map((letter) => [letter, letter === along ? t('moves_itself', { axis: letter }) : t('moves_other', { axis: letter })]), (letter) => set_moved(letter as Axis))}
          {tools.length > 1 && select(t('tool'), chosen_tool, tools.map((name) => [name, name]), set_tool)}
        </div>
        {controls.error && <FailureNotice error={controls.error} retry={controls.reload} />}
        {controls.data && (
          <>
            {is_cross && <p class="small quiet">{t('cross_only', { n: able.length, all: controls.data.length })}</p>}
            <ControlChoice key={is_cross ? 'cross' : 'own'} controls={able} kind="linear" chosen={control} choose={set_wanted} is_turned={form.turned_sign} can={can} />
            {control && <TurnedSign {...{ control, form, change }} />}
          </>
        )}
        {control && (
          <div class="field-controls no-print">
            {named(words('axis_name'), form.axis, along, (axis) => change({ axis }))}
            {is_cross && named(t('output_axis'), output, moved, set_output)}
            <NumberFields keys={offered_numbers(control)} kind="linear" form={form} change={change} faults={faults} />
            <CurvesField {...{ control, form, change }} />
            {counts_in_lengths(control, 'linear') && <label><input type="checkbox" checked={form.inch} onChange={(event) => change({ inch: event.currentTarget.checked })} />{words('inch')}</label>}
          </div>
        )}
        {made.error && body !== null && <Refused error={made.error} again={made.again} />}
        {shown && <Remaining made={shown} />}
      </section>
      {shown && <TableChart table={shown.result.table} existing={null} kind="linear" unit={shown.result.unit} />}
      {shown && <TableText text={shown.table} name={shown.file_name} stale={stale} />}
      {control && (
        <section class="panel" aria-labelledby="volume-table-format">
          <header><h2 id="volume-table-format">{words('format')}</h2></header>
          <AboutFormat {...described_by(control, form.turned_sign)} />
        </section>
      )}
    </>
  );
}

/** On the line that the table corrects, and over the whole volume with this table alone. */
function Remaining({ made: { result } }: { made: VolumetricCompensation }) {
  const { line_range: line, volume } = result;
  const figures: [string, number, number, string][] = [
    [t('line_range'), line.before, line.after, t('line_u', { u: fixed(2 * line.u, 1) })],
    [t('size_95'), volume.before.percent_95, volume.after.percent_95, t('alone')],
    [t('size_most'), volume.before.largest, volume.after.largest, t('alone')],
    [t('size_mean'), volume.before.mean, volume.after.mean, t('alone')],
  ];
  return (
    <>
      <p>{t('corrects', { errors: result.errors })}</p>
      <dl class="figures">
        {figures.map(([name, before, after, note]) => (
          <div key={name}><dt>{name}</dt><dd class="number">{fixed(before, 1)} → {fixed(after, 1)} <span class="unit">µm {note}</span></dd></div>
        ))}
      </dl>
      <VolumeFindings findings={result.findings} />
    </>
  );
}
