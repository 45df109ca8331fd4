// SPDX-License-Identifier: Apache-2.0
// A result of a volumetric calibration, wherever it comes from: what was found, the errors, the field that they make, what
// a test of one line would show, and tables for controls. It is given the JSON of a result.
import type { ComponentChildren } from 'preact';
import type { VolumetricResult } from '../../api/types';
import { DataTable } from '../../components/table';
import { absent, count, fixed } from '../../numbers';
import { ControlTablePanel } from './control_table';
import { ErrorCurves, ErrorTable, SquarenessFigures, told_count } from './errors';
import { FieldPanel } from './field';
import { VolumeFindings } from './findings';
import { LinePanel } from './line';
import { t } from './result_texts';
import { TablePanel } from './tables';
import '../plan/plan.css';
import './volume.css';

/** `taken`: buttons that take it along; `more`: what belongs to it and is not in it. */
export function VolumeResult({ result, taken, more }: { result: VolumetricResult; taken?: ComponentChildren; more?: ComponentChildren }) {
  return (
    <div class="stack volume-result">
      <section class="panel" aria-labelledby="volume-found">
        <header>
          <h2 id="volume-found">{heading_of(result)}</h2>
          {taken && <div class="row no-print">{taken}</div>}
        </header>
        <Figures result={result} />
        <VolumeFindings findings={result.findings} />
      </section>
      <section class="panel" aria-labelledby="volume-errors">
        <header><h2 id="volume-errors">{t('errors')}</h2></header>
        <p class="quiet">{t('errors_how')}</p>
        {result.unseen.length > 0 && <p class="notice caution">{t('unseen', { names: result.unseen.join(', ') })}</p>}
        <h3>{t('squareness')}</h3>
        <SquarenessFigures errors={result.errors} />
        <ErrorCurves errors={result.errors} />
        <ErrorTable errors={result.errors} />
      </section>
      <FieldPanel result={result} />
      <LinePanel result={result} />
      <TablePanel result={result} />
      <ControlTablePanel result={result} />
      <section class="panel" aria-labelledby="volume-stations">
        <header><h2 id="volume-stations">{t('stations')}</h2></header>
        <Stations result={result} />
        {more}
      </section>
    </div>
  );
}

function heading_of({ errors }: VolumetricResult): string {
  const n = told_count(errors);
  return n === 21 ? t('found_all') : t('found', { n });
}

function Figures({ result }: { result: VolumetricResult }) {
  const { readings, rank, chi2_per_dof, degrees_of_freedom, set_aside, breaks } = result;
  const figures: [string, string, string][] = [
    [t('lengths'), count(readings), ''],
    [t('fit'), chi2_per_dof === null ? absent : fixed(chi2_per_dof, 2), `ν = ${count(degrees_of_freedom)}; ${t('fit_told')}`],
    [t('rank'), `${count(rank.rank)} / ${count(rank.unknowns)}`, ''],
    [t('set_aside'), count(set_aside.length), ''],
    [t('breaks'), count(breaks.length), ''],
  ];
  return (
    <dl class="figures">
      {figures.map(([name, value, note]) => <div key={name}><dt>{name}</dt><dd class="number">{value} {note && <span class="unit">{note}</span>}</dd></div>)}
    </dl>
  );
}

function Stations({ result: { stations } }: { result: VolumetricResult }) {
  const place = (k: number) => ({ key: 'XYZ'[k] as string, head: `${'XYZ'[k]} / mm`, number: true, cell: ({ position_mm }: (typeof stations)[number]) => fixed(position_mm[k], 3) });
  return (
    <DataTable caption={t('stations_found')} rows={stations} row_key={({ station, tool }) => `${station} ${tool}`} columns={[
      { key: 'station', head: t('station'), row_head: true, cell: ({ station }) => station },
      { key: 'tool', head: t('tool'), cell: ({ tool }) => tool },
      place(0), place(1), place(2),
      { key: 'readings', head: t('readings'), number: true, cell: ({ readings }) => count(readings) },
      { key: 'rms', head: t('rms'), number: true, cell: ({ rms_um }) => fixed(rms_um, 2) },
      { key: 'normalised', head: t('normalised'), number: true, cell: ({ normalised_rms }) => fixed(normalised_rms, 2) },
      ...(stations.some(({ scale_um_per_m }) => scale_um_per_m !== undefined) ? [
        { key: 'scale', head: t('part_scale'), number: true, cell: ({ scale_um_per_m: scale, scale_u_um_per_m: u }: (typeof stations)[number]) =>
          (scale === undefined || u === undefined ? absent : `${fixed(scale, 2)} ± ${fixed(2 * u, 2)}`) },
      ] : []),
    ]} />
  );
}
