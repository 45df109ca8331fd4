// SPDX-License-Identifier: Apache-2.0
import { useMemo } from 'preact/hooks';
import type { CompensatedControl, CompensationMean, CompensationOptions, MadeCompensation, Test } from '../../api/types';
import { position_unit, shortest } from '../../numbers';
import { VolumeFindings } from '../volume/findings';
import { AboutFormat, TableText, described_by } from './about';
import type { Answered } from './asked';
import type { Nodes } from './curve_model';
import { MeansChart, TableChart } from './curves';
import type { Existing } from './existing';
import { FigureTable } from './figures';
import { KeepTable } from './keep';
import { Refused } from './refused';
import { t } from './texts';

interface Props {
  test: Test; control: CompensatedControl | null; options: CompensationOptions | null; made: Answered<MadeCompensation>;
  existing: Existing | null; file: File | null;   // null while there is none, or it is too large
  read: Nodes | null;                             // of the existing table, as the control reads it
  wrong: number;                                  // fields that are
  is_turned: boolean;                             // the sign
}

const means_of = (test: Test): CompensationMean[] => test.result.positions.map(({ target, mean_up, mean_down }) => ({ target, up: mean_up, down: mean_down }));

/** What comes of the choice. Where no table comes of it, why not, and the axis as it was measured. */
export function Outcome({ test, control, options, made, existing, file, read, wrong, is_turned }: Props) {
  const { kind } = test.result.axis;
  const { unit } = test.result;
  const before = useMemo(() => means_of(test), [test]);
  const shown = made.is_current || made.busy ? made.data : null;   // not beside what was refused
  const result = shown?.result ?? null;
  const fits = result !== null && control !== null && result.control === control.id;
  const stale = !made.is_current;
  const means = useMemo(() => (fits && result ? { before: result.before_means, predicted: result.predicted_means } : { before }), [fits, result, before]);
  return (
    <div class={`stack table-outcome ${stale && fits ? 'stale' : ''}`} aria-busy={made.busy}>
      <p class="visually-hidden" role="status">{made.busy ? t('making') : made.is_current ? t('made') : ''}</p>
      {control === null && <p class="panel quiet">{t('choose_control')}</p>}
      {wrong > 0 && <p class="notice bad" role="alert">{t('fields_wrong')}</p>}
      {made.error && <Refused error={made.error} again={made.again} />}
      {fits && result && shown && (
        <section class="panel flush table-results" aria-labelledby="table-result">
          <header>
            <h2 id="table-result">{t('result')} <span class="quiet small">{control.title}, {range_of(result.table, kind)}</span></h2>
            <KeepTable ready={made.is_current && options !== null} test={test.id} version={test.version} options={options as CompensationOptions}
              existing={file} serious={result.findings.filter(({ severity }) => severity === 'serious').length} />
          </header>
          <div class="inset"><VolumeFindings findings={result.findings} /></div>
          <FigureTable result={result} test={test} />
        </section>
      )}
      <MeansChart means={means} shown={test.shown} kind={kind} unit={unit} />
      {(fits || read !== null) && (
        <TableChart table={fits && result ? result.table : null} existing={read ?? (fits && existing !== null ? (result?.existing ?? null) : null)} kind={kind} unit={unit} />
      )}
      {fits && shown && <TableText text={shown.table} name={shown.file_name} stale={stale} />}
      {control !== null && (
        <section class="panel" aria-labelledby="table-format">
          <header><h2 id="table-format">{t('format')}</h2></header>
          <AboutFormat {...described_by(control, is_turned)} />
        </section>
      )}
    </div>
  );
}

/** "11 positions from 0 to 500 mm" */
function range_of(nodes: Nodes, kind: 'linear' | 'rotary'): string {
  const [first, last] = [nodes[0], nodes[nodes.length - 1]];
  if (!first || !last) return '';
  return nodes.length === 1 ? t('one_position') : t('range', { n: nodes.length, from: shortest(first.position), to: shortest(last.position), unit: position_unit(kind) });
}
