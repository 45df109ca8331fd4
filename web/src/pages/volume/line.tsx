// SPDX-License-Identifier: Apache-2.0
// What a test after ISO 230-2 or ISO 230-6 would show, predicted from the errors.
import { useMemo, useState } from 'preact/hooks';
import { query } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { PredictedLine, Vocabulary, VolumetricPrediction } from '../../api/types';
import { use_get } from '../../api/use';
import { Chart, type ChartModel } from '../../components/chart/chart';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { fixed, parsed, shortest } from '../../numbers';
import { decimal, language } from '../../settings';
import { axes } from './error_names';
import { VolumeFindings } from './findings';
import { given_model, machine_of, type Modelled } from './model_parts';
import { t } from './result_texts';
import { colon } from '../../i18n/colon';

const is_axis = (line: string): boolean => (axes as readonly string[]).includes(line);

export function LinePanel({ result }: { result: Modelled }) {
  const { model } = result;
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const machine = useMemo(() => machine_of(model), [model]);
  const [line, set_line] = useState('X');
  const [tool, set_tool] = useState(machine.tools[0] ?? '');
  const [stands, set_stands] = useState<string[]>(machine.middle.map((mm) => shortest(mm, 1)));
  const places = stands.map(parsed);
  const faults = stands.map((text, k) => (places[k] === null && is_axis(line) && axes[k] !== line ? t('not_number', { text: text.trim() }) : null));
  const at = faults.every((fault) => fault === null) ? places.map((place) => place ?? 0) : null;
  const chosen_tool = machine.tools.includes(tool) ? tool : (machine.tools[0] ?? '');
  const body = useMemo(() => {
    if (!is_axis(line)) return { ...given_model(result), diagonal: line, tool: chosen_tool };
    return at === null ? null : { ...given_model(result), axis: line, at_mm: at, tool: chosen_tool };
  }, [result, line, chosen_tool, JSON.stringify(at)]);
  const answer = use_posted<VolumetricPrediction>(`/api/volumetric/prediction${query({ decimal: decimal.value })}`, body, as_json);
  const is_this = answer.is_current;
  const faces = (name: string) => name.includes(' ');
  return (
    <section class="panel" aria-labelledby="volume-line">
      <header><h2 id="volume-line">{t('lines')}</h2></header>
      <p class="quiet">{t('lines_how')}</p>
      <div class="field-controls no-print">
        <Field label={t('line')}>
          {(ids) => (
            <select {...ids} value={line} onChange={(event) => set_line(event.currentTarget.value)}>
              {axes.map((axis) => <option key={axis} value={axis}>{t('axis', { axis })}</option>)}
              {(vocabulary.data?.diagonals ?? []).map((name) => <option key={name} value={name}>{t(faces(name) ? 'diagonal_face' : 'diagonal_body', { name })}</option>)}
            </select>
          )}
        </Field>
        {machine.tools.length > 1 && (
          <Field label={t('tool')}>
            {(ids) => <select {...ids} value={chosen_tool} onChange={(event) => set_tool(event.currentTarget.value)}>{machine.tools.map((name) => <option key={name} value={name}>{name}</option>)}</select>}
          </Field>
        )}
        {is_axis(line) && axes.map((axis, k) => axis !== line && (
          <Field key={axis} label={t('stands', { axis })} fault={faults[k] ?? null}>
            {(ids) => <input {...ids} class="number short" inputMode="decimal" autocomplete="off" value={stands[k] ?? ''} onInput={(event) => set_stands(stands.map((one, i) => (i === k ? event.currentTarget.value : one)))} />}
          </Field>
        ))}
      </div>
      {answer.error && <FailureNotice error={answer.error} retry={answer.again} />}
      {is_this && answer.data && <Predicted line={answer.data.prediction} name={line} />}
      {is_this && answer.data && answer.data.findings.length > 0 && <VolumeFindings findings={answer.data.findings} />}
    </section>
  );
}

function Predicted({ line, name }: { line: PredictedLine; name: string }) {
  const chart = useMemo(() => line_chart(line), [line, language.value]);
  const with_u = (value: number, u: number, unit: string) => <>{fixed(value, 2)} <span class="unit">± {fixed(2 * u, 2)} {unit} (k = 2)</span></>;
  return (
    <>
      <dl class="figures">
        <div><dt>{t(line.reversal_um === null ? 'systematic_mean' : 'systematic')}</dt><dd class="number">{with_u(line.systematic_um, line.systematic_u_um, 'µm')}</dd></div>
        <div><dt>{t('slope')}</dt><dd class="number">{with_u(line.slope_um_per_m, line.slope_u_um_per_m, 'µm/m')}</dd></div>
        <div><dt>{t('reversal')}</dt><dd class="number">{line.reversal_um === null ? <span class="unit">{t('no_reversal')}</span> : <>{fixed(line.reversal_um, 2)} <span class="unit">µm</span></>}</dd></div>
      </dl>
      <Chart {...chart} name={`${t('predicted')}${colon()} ${name}`} height={240} />
      <p class="quiet small">{t('line_note')}</p>
    </>
  );
}

function line_chart({ targets, reversal_um }: PredictedLine): ChartModel {
  const band = (key: 'up' | 'down', colour: string) => ({
    key, colour, opacity: 0.22,
    upper: targets.map((one) => one[`${key}_um`] + 2 * one[`${key}_u_um`]), lower: targets.map((one) => one[`${key}_um`] - 2 * one[`${key}_u_um`]),
  });
  const series = (key: 'up' | 'down', label: string, colour: string) => ({ key, label, colour, values: targets.map((one) => one[`${key}_um`]), shape: 'circle' as const, size: 5 });
  const both = reversal_um !== null;
  return {
    x: targets.map(({ position_mm }) => position_mm), x_label: t('target'), y_label: t('deviation'), y_zero: true,
    bands: both ? [band('up', '--series-up'), band('down', '--series-down')] : [band('up', '--series-1')],
    series: both ? [series('up', t('up'), '--series-up'), series('down', t('down'), '--series-down')] : [series('up', t('predicted'), '--series-1')],
  };
}
