// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { EvaluatedLine, Parameter, TrackingEvaluation } from '../../api/types';
import { Chart, Swatch, type ChartModel } from '../../components/chart/chart';
import { FindingList, sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { ParameterSymbol } from '../../components/symbol';
import { DataTable } from '../../components/table';
import { VerdictMark } from '../../components/verdict';
import { absent, decimals_for, fixed } from '../../numbers';
import { TrackingFindings } from './findings';
import { LineName } from './lines';
import { place_text } from './station';
import { t } from './texts';
import { station_place } from './station_place';

const shown: readonly Parameter[] = ['A', 'E', 'R', 'B', 'M'];

/** What was found along the lines: parameters, slopes, verdicts; one line is looked at closer. */
export function Results({ evaluation }: { evaluation: TrackingEvaluation }) {
  const [wanted, set_wanted] = useState<string | null>(null);
  const line = evaluation.lines.find(({ id }) => id === wanted) ?? evaluation.lines[0] ?? null;
  const at = station_place(evaluation.setup);
  const found_along = evaluation.lines.filter(({ test }) => test.findings.length > 0);
  return (
    <div class="stack results">
      <h3>{t('results')}</h3>
      <p class="quiet">{at === null ? t('as_aligned') : t('station_as', { place: place_text(at, 3), how: t(evaluation.source.station ? 'as_located' : 'as_planned') })}</p>
      <ResultTable evaluation={evaluation} chosen={line?.id ?? null} choose={set_wanted} />
      <Diagonals evaluation={evaluation} />
      <FacePairs evaluation={evaluation} />
      {line && <LineChart line={line} />}
      <Squareness evaluation={evaluation} />
      <div>
        <h3>{t('findings')}</h3>
        {(evaluation.findings.length > 0 || found_along.length === 0) && <TrackingFindings findings={evaluation.findings} />}
        {found_along.map(({ id, test }) => (
          <details key={id} class="more">
            <summary>{t('findings_of', { line: id })}</summary>
            <FindingList findings={test.findings} />
          </details>
        ))}
      </div>
    </div>
  );
}

/** A slope with as many decimals as its uncertainty has meaning, and k where it is not 2; a result that was kept before it had one has U with 2. */
function slope_text({ um_per_m: value, u_um_per_m: u, k: own_k }: { um_per_m: number | null; u_um_per_m: number | null; k?: number | null }): string {
  if (value === null) return absent;
  if (u === null || !(u > 0)) return fixed(value, 2);
  const k = own_k ?? 2;
  const decimals = Math.min(3, decimals_for(k * u, 2));
  return `${fixed(value, decimals)} ± ${fixed(k * u, decimals)}${k === 2 ? '' : ` (k = ${fixed(k, 2)})`}`;
}

const bound_of = ({ length_difference: difference }: EvaluatedLine): string => {
  if (!difference || difference.bounds_um.length === 0) return absent;
  const most = Math.max(...difference.bounds_um);
  return most > 0 && most < 0.005 ? `< ${fixed(0.01, 2)}` : fixed(most, 2);
};

function ResultTable({ evaluation, chosen, choose }: { evaluation: TrackingEvaluation; chosen: string | null; choose: (id: string) => void }) {
  const rows = evaluation.lines.map((line, k) => ({ ...line, k }));
  const judged = rows.some(({ test }) => test.verdict !== undefined);
  const withheld = [...new Set(rows.flatMap(({ test }) => (test.tolerances ?? []).flatMap((one) => (one.withheld ? [one.withheld] : []))))];
  return (
    <>
      <DataTable caption={t('results')} rows={rows} row_key={({ id }) => id} row_class={({ id }) => (id === chosen ? 'chosen' : '')}
        columns={[
          { key: 'id', head: t('line'), row_head: true, cell: ({ id, k }) => <button type="button" class="plain small" aria-pressed={id === chosen} onClick={() => choose(id)}><LineName id={id} k={k} /></button> },
          { key: 'distance', head: t('distance'), number: true, cell: ({ distances_mm }) => `${fixed(Math.min(...distances_mm), 0)} … ${fixed(Math.max(...distances_mm), 0)}` },
          ...shown.map((parameter) => ({
            key: parameter, head: <ParameterSymbol parameter={parameter} />, number: true,
            cell: ({ test }: EvaluatedLine) => fixed(test.parameters[parameter], 1),
          })),
          { key: 'slope', head: t('slope'), number: true, cell: ({ slope }) => slope_text(slope) },
          { key: 'bound', head: t('bound'), number: true, cell: bound_of },
          { key: 'standard', head: t('standard'), class: 'standard', cell: ({ standard }) => standard.replace(/:.*$/, '') },
          ...(judged ? [{ key: 'verdict', head: t('verdict'), cell: ({ test }: EvaluatedLine) => <VerdictMark verdict={verdict_of(test.verdict)} /> }] : []),
        ]} />
      <p class="quiet small">{t('slopes_told')}</p>
      {withheld.map((reason) => <p key={reason} class="notice caution">{sentence(reason)}</p>)}
    </>
  );
}

const verdict_of = (verdict: EvaluatedLine['test']['verdict']) => (verdict === undefined || verdict === 'not applicable' ? null : verdict);

function Diagonals({ evaluation: { iso230_6 } }: { evaluation: TrackingEvaluation }) {
  const largest = (['E', 'R', 'B'] as const).flatMap((key) => {
    const found = iso230_6[key];
    return found ? [`${key} ${fixed(found.value_um, 1)} µm (${found.line})`] : [];
  });
  if (largest.length === 0) return null;
  return <p><strong>{iso230_6.standard}, {t('diagonals')}:</strong> {largest.join(', ')}. <span class="quiet">{t('cancel')}</span></p>;
}

/** Two diagonals of a face tell how far its axes are from square. */
function FacePairs({ evaluation: { iso230_6 } }: { evaluation: TrackingEvaluation }) {
  if (iso230_6.face_pairs.length === 0) return null;
  return (
    <div>
      <h3>{t('face_pairs')}</h3>
      <DataTable caption={t('face_pairs')} rows={iso230_6.face_pairs} row_key={({ face }) => face}
        columns={[
          { key: 'face', head: t('face_of'), row_head: true, cell: ({ face, lines }) => `${face} (${lines.join(', ')})` },
          { key: 'slopes', head: t('slopes_apart'), number: true, cell: ({ slope_difference_um_per_m: apart }) => fixed(apart, 2) },
          { key: 'value', head: t('value'), number: true, cell: (pair) => `${pair.squareness} ${slope_text(pair)}` },
        ]} />
    </div>
  );
}

function LineChart({ line }: { line: EvaluatedLine }) {
  const positions = [...line.test.positions].sort((a, b) => a.target - b.target);
  const series = (key: 'mean_up' | 'mean_down') => positions.map((position) => position[key]);
  const spread = (mean: 'mean_up' | 'mean_down', s: 's_up' | 's_down') => positions.map((position): readonly [number, number] | null => {
    const [middle, width] = [position[mean], position[s]];
    return middle === null || width === null ? null : [middle - 2 * width, middle + 2 * width];
  });
  const model: ChartModel = {
    x: positions.map(({ target }) => target), x_label: t('position'), y_label: t('deviation'), y_decimals: 2,
    series: [
      { key: 'mean_up', label: t('mean_up'), values: series('mean_up'), colour: '--series-up', width: 2, shape: 'up', whisker: spread('mean_up', 's_up'), aside: -2 },
      { key: 'mean_down', label: t('mean_down'), values: series('mean_down'), colour: '--series-down', width: 2, dash: [5, 2], shape: 'down', whisker: spread('mean_down', 's_down'), aside: 2 },
    ],
  };
  return (
    <div>
      <h3>{t('deviations', { line: line.id })}</h3>
      <p class="row small">{model.series.map((one) => <span key={one.key}><Swatch series={one} /> {one.label}</span>)}</p>
      <Chart {...model} name={t('deviations', { line: line.id })} height={260} />
    </div>
  );
}

function Squareness({ evaluation: { squareness } }: { evaluation: TrackingEvaluation }) {
  if (!squareness) return null;
  const known = squareness.terms.filter(({ um_per_m }) => um_per_m !== null);
  const unknown = squareness.terms.filter(({ um_per_m }) => um_per_m === null).map(({ id }) => id);
  if (known.length === 0 && squareness.notes.length === 0) return null;
  return (
    <div>
      <h3>{t('squareness')}</h3>
      <dl class="figures terms">
        {known.map((term) => (
          <div key={term.id}><dt><Formula text={term.id} /></dt><dd class="number">{slope_text(term)}<span class="unit"> {term.id.startsWith('e_') ? 'µm/m' : 'µrad'}</span></dd></div>
        ))}
      </dl>
      {unknown.length > 0 && <p class="quiet small"><Formula text={t('untold', { ids: unknown.join(', ') })} /></p>}
      {squareness.notes.map((note, k) => <p key={k} class="quiet small"><Formula text={sentence(note)} /></p>)}
    </div>
  );
}
