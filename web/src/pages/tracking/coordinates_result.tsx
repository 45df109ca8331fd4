// SPDX-License-Identifier: Apache-2.0
// Points and stations that were found: findings, a picture, coordinates with their uncertainties, and files to take along.
import { useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, made_of_files, offer, query } from '../../api/client';
import type { FoundPoint, Multilateration, PolarResult, TrackingFinding } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Scene } from '../../components/scene/scene';
import { DataTable } from '../../components/table';
import { absent, count, decimals_for, fixed, shortest } from '../../numbers';
import { decimal, language } from '../../settings';
import { readings_form, type Coordinates, type SentReadings } from './coordinates';
import { coordinates_scene } from './coordinates_scene';
import { t } from './coordinates_texts';
import { TrackingFindings } from './findings';
import { axes } from './form';
import { semicolon } from '../../i18n/colon';

const most_rows = 200;
const is_polar = (result: Coordinates): result is PolarResult => result.result === 'polar';
const u_um = (covariance: readonly (readonly number[])[], c: number): number => 1000 * Math.sqrt(Math.max(0, covariance[c]?.[c] ?? 0));

interface Props { sent: SentReadings; result: Coordinates; try_lengths: (() => void) | null }

export function CoordinatesResult({ sent, result, try_lengths }: Props) {
  const remarks = result.remarks.map((message): TrackingFinding => ({ id: '', severity: 'note', message }));
  const share = is_polar(result) && result.unknowns > 0 ? (100 * result.told_by_angles) / result.unknowns : 0;
  return (
    <div class="stack results coordinates">
      <header class="row">
        <h3>{t('result')}</h3>
        <Taken sent={sent} />
      </header>
      <Figures result={result} />
      <TrackingFindings findings={[...result.findings, ...remarks]} />
      {is_polar(result) ? (
        <div class="notice">
          <p>{t('why_lengths', { share: fixed(share, 0) })}</p>
          {try_lengths && <button type="button" class="no-print" onClick={try_lengths}>{t('try_lengths')}</button>}
        </div>
      ) : <p class="quiet">{t('lengths_told')}</p>}
      <Picture result={result} />
      <p class="quiet">{t(is_polar(result) && result.coordinates === 'station' ? 'in_frame_of_station' : 'in_nominal')}</p>
      <Points points={result.points} />
      <Stations result={result} />
      {!is_polar(result) && <Breaks result={result} />}
    </div>
  );
}

function Figures({ result }: { result: Coordinates }) {
  const { points, stations, chi_squared, degrees_of_freedom } = result;
  const polar = is_polar(result);
  const { equations, unknowns } = polar ? result : result.rank;
  const us = points.flatMap(({ covariance_mm2 }) => (covariance_mm2 ? [0, 1, 2].map((c) => u_um(covariance_mm2, c)) : []));
  const typical = us.length === 0 ? null : Math.sqrt(us.reduce((sum, u) => sum + u * u, 0) / us.length);
  const most = us.reduce((a, b) => Math.max(a, b), 0);
  const micrometres = (u: number) => fixed(u, decimals_for(u, 3));
  const figures: [string, string, string][] = [
    [t('points'), count(points.length), ''],
    [t('stations'), count(stations.length), ''],
    [t('unknowns'), `${count(equations)} / ${count(unknowns)}`, ''],
    [t('fit'), degrees_of_freedom > 0 ? fixed(chi_squared / degrees_of_freedom, 2) : absent, degrees_of_freedom > 0 ? `ν = ${count(degrees_of_freedom)}` : t('no_redundancy')],
    ...(typical === null ? [] : [[t('typical'), micrometres(typical), `µm, ${t('largest', { u: micrometres(most) })}`] as [string, string, string]]),
    polar ? [t('told_by_angles'), unknowns > 0 ? fixed((100 * result.told_by_angles) / unknowns, 0) : absent, '%']
      : [t('weakest'), micrometres(1000 * result.rank.weakest_mm), 'µm'],
  ];
  return (
    <dl class="figures">
      {figures.map(([name, value, note]) => <div key={name}><dt>{name}</dt><dd class="number">{value} {note && <span class="unit">{note}</span>}</dd></div>)}
    </dl>
  );
}

function Picture({ result }: { result: Coordinates }) {
  const { model, enlarged, most_um, farthest } = useMemo(() => coordinates_scene(result, t('off')), [result, language.value]);
  const told = [
    t('picture_told', { points: count(result.points.length), stations: result.stations.map(({ name, position_mm }) => `${name} (${position_mm.map((mm) => shortest(mm, 1)).join(semicolon())})`).join(', ') }),
    ...(most_um > 0 ? [t('picture_off', { n: count(enlarged), name: farthest, most: fixed(most_um, decimals_for(most_um, 3)) })] : []),
  ].join(' ');
  return (
    <div class="field-picture">
      <Scene model={model} name={t('picture')} description={told} />
      {most_um > 0 && <p class="quiet small">{t('picture_off', { n: count(enlarged), name: farthest, most: fixed(most_um, decimals_for(most_um, 3)) })}</p>}
    </div>
  );
}

function Points({ points }: { points: readonly FoundPoint[] }) {
  const shown = points.slice(0, most_rows);
  const has_u = shown.some(({ covariance_mm2 }) => covariance_mm2);
  const has_nominal = shown.some(({ deviation_um }) => deviation_um);
  return (
    <>
      <DataTable caption={t('points')} rows={shown} row_key={({ name }) => name} columns={[
        { key: 'name', head: t('point'), row_head: true, cell: ({ name }) => name },
        ...axes.map((axis, c) => ({ key: axis, head: `${axis} / mm`, number: true, cell: ({ position_mm }: FoundPoint) => fixed(position_mm[c], 4) })),
        ...(has_nominal ? axes.map((axis, c) => ({ key: `d${axis}`, head: `Δ${axis} / µm`, number: true, cell: ({ deviation_um }: FoundPoint) => (deviation_um ? fixed(deviation_um[c], 2) : absent) })) : []),
        ...(has_u ? axes.map((axis, c) => ({ key: `u${axis}`, head: `u(${axis}) / µm`, number: true, cell: ({ covariance_mm2 }: FoundPoint) => (covariance_mm2 ? fixed(u_um(covariance_mm2, c), 2) : absent) })) : []),
      ]} />
      {points.length > most_rows && <p class="quiet small">{t('shown_first', { n: most_rows, all: count(points.length) })}</p>}
    </>
  );
}

type AnyStation = Multilateration['stations'][number] | PolarResult['stations'][number];

function Stations({ result }: { result: Coordinates }) {
  const rows: readonly AnyStation[] = result.stations;
  const has_scale = !is_polar(result) && result.scale !== 'fixed';
  return (
    <DataTable caption={t('stations')} rows={rows} row_key={({ name }) => name} columns={[
      { key: 'name', head: t('station'), row_head: true, cell: ({ name }) => name },
      ...axes.map((axis, c) => ({ key: axis, head: `${axis} / mm`, number: true, cell: ({ position_mm }: AnyStation) => fixed(position_mm[c], 4) })),
      ...axes.map((axis, c) => ({ key: `u${axis}`, head: `u(${axis}) / µm`, number: true, cell: ({ covariance_mm2 }: AnyStation) => fixed(u_um(covariance_mm2, c), 2) })),
      { key: 'dead', head: t('dead_path'), number: true, cell: ({ dead_paths }) => (dead_paths.length === 0 ? absent : dead_paths.map(({ dead_path_mm }) => fixed(dead_path_mm, 4)).join(semicolon())) },
      ...(has_scale ? [{ key: 'scale', head: t('scale_of'), number: true, cell: (one: AnyStation) => ('scale' in one ? `${fixed(1e6 * (one.scale - 1), 3)} ± ${fixed(1e6 * one.scale_u, 3)}` : absent) }] : []),
    ]} />
  );
}

function Breaks({ result: { breaks } }: { result: Multilateration }) {
  if (breaks.length === 0) return null;
  return (
    <DataTable caption={t('breaks')} rows={breaks} row_key={({ reading }) => reading} columns={[
      { key: 'station', head: t('station'), row_head: true, cell: ({ station }) => station },
      { key: 'reading', head: t('before_reading'), number: true, cell: ({ reading }) => count(reading) },
      { key: 'point', head: t('point'), cell: ({ point }) => point },
      { key: 'jump', head: t('jump'), number: true, cell: ({ jump_mm }) => fixed(jump_mm, 4) },
    ]} />
  );
}

/** Buttons that take it along. */
function Taken({ sent }: { sent: SentReadings }) {
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const stem = (sent.readings[0]?.name ?? sent.way).replace(/\.\w+$/, '');
  const save = async (path: string, name: string) => {
    set_busy(true);
    set_error(null);
    try {
      const answer = await made_of_files(`/api/tracking/${sent.way}/${path}`, readings_form(sent));
      offer(new Blob([await answer.arrayBuffer()]), name);
    } catch (thrown) {
      set_error(as_error(thrown));
    }
    set_busy(false);
  };
  const look = () => query({ language: language.value, decimal: decimal.value });
  return (
    <div class="row no-print">
      {['pdf', 'html', 'json'].map((extension) => (
        <button key={extension} type="button" disabled={busy} onClick={() => void save(`report.${extension}${look()}`, `${stem}.${extension}`)}>{t('report')} {extension.toUpperCase()}</button>
      ))}
      <button type="button" disabled={busy} onClick={() => void save('points', `${stem}.points.csv`)}>{t('points_table')}</button>
      {sent.way === 'multilateration' && <button type="button" disabled={busy} onClick={() => void save('residuals', `${stem}.residuals.csv`)}>{t('residuals_table')}</button>}
      {error && <FailureNotice error={error} />}
    </div>
  );
}
