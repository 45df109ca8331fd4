// SPDX-License-Identifier: Apache-2.0
// What errors that were measured one by one make together: findings, curves, field, lines and tables.
import { useState } from 'preact/hooks';
import { type ApiError, as_error, made_of_files, offer, query } from '../../api/client';
import type { VolumetricAssembly } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { DataTable } from '../../components/table';
import { absent, count, fixed } from '../../numbers';
import { decimal, language } from '../../settings';
import { ControlTablePanel } from './control_table';
import { ErrorCurves, ErrorTable, SquarenessFigures, told_count } from './errors';
import { FieldPanel } from './field';
import { VolumeFindings } from './findings';
import { LinePanel } from './line';
import { t as t_result } from './result_texts';
import { singles_form_data, type SentSingles } from './singles';
import { unit_of } from './singles_form';
import { t } from './singles_texts';
import { TablePanel } from './tables';

/** `sent`: what it was made of, where it was made here. */
export function AssemblyResult({ result, sent = null }: { result: VolumetricAssembly; sent?: SentSingles | null }) {
  const { curves, findings, remarks } = result;
  const n = told_count(curves);
  const told = [...findings, ...remarks.map((message) => ({ id: 'volumetric-singles-remark', severity: 'note' as const, message }))];
  return (
    <div class="stack volume-result">
      <section class="panel" aria-labelledby="volume-assembled">
        <header>
          <h2 id="volume-assembled">{n === 21 ? t('found_all') : t('found', { n })}</h2>
          {sent && <div class="row no-print"><Taken sent={sent} /></div>}
        </header>
        <VolumeFindings findings={told} />
        <Measured result={result} />
      </section>
      <section class="panel" aria-labelledby="volume-errors">
        <header><h2 id="volume-errors">{t_result('errors')}</h2></header>
        <p class="quiet">{t_result('errors_how')}</p>
        <h3>{t_result('squareness')}</h3>
        <SquarenessFigures errors={curves} />
        <ErrorCurves errors={curves} />
        <ErrorTable errors={curves} />
      </section>
      <FieldPanel result={result} />
      <LinePanel result={result} />
      <TablePanel result={result} />
      <ControlTablePanel result={result} />
    </div>
  );
}

function Measured({ result: { errors } }: { result: VolumetricAssembly }) {
  const number = (value: number | null) => (value === null ? absent : fixed(value, 2));
  const has_equipment = errors.some(({ equipment }) => equipment !== null);
  return (
    <>
      <h3>{t('measured')}</h3>
      <DataTable caption={t('measured')} rows={errors} row_key={({ name }) => name} columns={[
        { key: 'name', head: t('error'), row_head: true, cell: ({ name }) => name },
        { key: 'file', head: t('file'), cell: ({ file }) => (file === null ? absent : <span class="mono small">{file}</span>) },
        { key: 'runs', head: t('runs'), number: true, cell: ({ runs }) => (runs === null ? absent : count(runs)) },
        { key: 'directions', head: t('directions'), cell: ({ directions }) => (directions === null ? absent : t(directions)) },
        { key: 'reversal', head: t('reversal_most'), number: true, cell: ({ reversal_largest }) => number(reversal_largest) },
        { key: 'u', head: t('u_most'), number: true, cell: ({ u_largest }) => number(u_largest) },
        { key: 'unit', head: t('unit'), cell: ({ name }) => unit_of(name) },
        ...(has_equipment ? [{ key: 'equipment', head: t('equipment'), cell: ({ equipment }: VolumetricAssembly['errors'][number]) => equipment ?? absent }] : []),
      ]} />
    </>
  );
}

/** Buttons that take it along. */
function Taken({ sent }: { sent: SentSingles }) {
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const save = async (extension: string, name: string) => {
    set_busy(true);
    set_error(null);
    try {
      const answer = await made_of_files(`/api/volumetric/assembly/report.${extension}${query({ language: language.value, decimal: decimal.value })}`, singles_form_data(sent));
      offer(new Blob([await answer.arrayBuffer()]), name);
    } catch (thrown) {
      set_error(as_error(thrown));
    }
    set_busy(false);
  };
  return (
    <>
      {['pdf', 'html'].map((extension) => (
        <button key={extension} type="button" disabled={busy} onClick={() => void save(extension, `errors.${extension}`)}>{t('report')} {extension.toUpperCase()}</button>
      ))}
      <button type="button" disabled={busy} onClick={() => void save('json', 'errors.result.json')}>{t('result_file')} JSON</button>
      {error && <FailureNotice error={error} />}
    </>
  );
}
