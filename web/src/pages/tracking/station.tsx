// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { ApiError, as_error, download_made, made_of_files, offer, query, send } from '../../api/client';
import type { TrackingAdvice, TrackingPoints, TrackingRequest, TrackingStation } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { FileDrop } from '../../components/file_drop';
import { decimals_for, fixed, parsed, shortest } from '../../numbers';
import { decimal, language } from '../../settings';
import { NumberField, TripleFields, type FormProps } from './fields';
import { TrackingFindings } from './findings';
import { axes, bounds_of, is_aligned, located_station, station_u, type LocatedStation } from './form';
import { MoreFields } from './more';
import { t } from './texts';
import { station_place } from './station_place';
import { colon } from '../../i18n/colon';

export const look = () => query({ language: language.value, decimal: decimal.value });
export const place_text = (place: readonly number[], decimals = 1): string => axes.map((axis, k) => `${axis} ${shortest(place[k], decimals)}`).join(', ');

interface Props extends FormProps {
  request: TrackingRequest | null;
  located: LocatedStation | null;
  locate: (located: LocatedStation | null) => void;
  points: TrackingPoints | null;
  set_points: (points: TrackingPoints | null) => void;
}


/** Where the instrument stands: typed, proposed, or found from measured points. */
export function StationPanel(props: Props) {
  const { form, change, faults, request, located, locate } = props;
  const [error, set_error] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const asking = async (what: () => Promise<void>) => {
    set_busy(true);
    set_error(null);
    try { await what(); } catch (thrown) { set_error(as_error(thrown)); }
    set_busy(false);
  };
  return (
    <section class="panel" aria-labelledby="tracking-station">
      <header><h2 id="tracking-station"><span class="step">2</span>{t('station')}</h2></header>
      <div class="tracking-form">
        {is_aligned(form) ? <p class="hint">{t('aligned')}</p> : located === null
          ? <TripleFields legend={t('place')} hint={t('station_hint')} name="station" values={form.station} faults={faults} set={(station) => change({ station })} />
          : <LocatedPlace located={located} discard={() => locate(null)} />}
        {!is_aligned(form) && located === null && <Advice {...{ request, busy, asking }} use={(place) => change({ station: place.map((x) => String(Math.round(x * 1000) / 1000)) })} />}
        {error && <FailureNotice error={error} />}
        {!is_aligned(form) && <Locate {...props} asking={asking} busy={busy} />}
        <MoreFields form={form} change={change} faults={faults} />
      </div>
    </section>
  );
}

type Asking = (what: () => Promise<void>) => Promise<void>;

function LocatedPlace({ located, discard }: { located: LocatedStation; discard: () => void }) {
  const u = station_u(located);
  return (
    <div class="located">
      <p><strong>{t('located', { file: located.file })}</strong></p>
      <table>
        <thead><tr><th scope="col" /><th scope="col" class="number">mm</th><th scope="col" class="number">u / µm</th></tr></thead>
        <tbody>
          {axes.map((axis, k) => (
            <tr key={axis}><th scope="row">{axis}</th><td class="number">{fixed(located.position[k], 4)}</td><td class="number">{fixed(u[k], decimals_for(u[k] ?? 0, 2))}</td></tr>
          ))}
        </tbody>
      </table>
      {bounds_of(located) === null && <p class="notice caution">{t('no_bounds')}</p>}
      <button type="button" onClick={discard}>{t('discard')}</button>
    </div>
  );
}

function Advice({ request, busy, asking, use }: { request: TrackingRequest | null; busy: boolean; asking: Asking; use: (place: readonly number[]) => void }) {
  const [advice, set_advice] = useState<{ of: string; found: TrackingAdvice } | null>(null);
  const of = JSON.stringify(request);
  const shown = advice?.of === of ? advice.found : null;
  return (
    <>
      <div><button type="button" disabled={busy || request === null} onClick={() => void asking(async () => {
        set_advice({ of, found: await send<TrackingAdvice>('POST', '/api/tracking/station/advice', { request }) });
      })}>{t('propose')}</button></div>
      {shown && shown.better.length === 0 && <p class="quiet">{t('no_better')}</p>}
      {shown?.better.map((better, k) => (
        <div key={k} class="notice">
          <p>
            {t('better', {
              place: place_text(better.position_mm), n: better.lines, all: shown.lines, length: fixed(better.shortest_mm, 0),
              now: shown.now.lines, now_length: fixed(shown.now.shortest_mm, 0),
            })}
            {better.raised && ` ${t('raised')}`}
          </p>
          <button type="button" onClick={() => use(better.position_mm)}>{t('use')}</button>
        </div>
      ))}
    </>
  );
}

const most_points = 256 * 1024;  // bytes, as the server takes

function Locate({ form, request, locate, points, set_points, asking, busy }: Props & { asking: Asking; busy: boolean }) {
  const [sigma, set_sigma] = useState('');
  // With what it was found: the report is of that, whatever is typed since.
  const [found, set_found] = useState<{ file: File; station: TrackingStation; options: string } | null>(null);
  const count = 8;
  const micrometres = parsed(sigma);
  const sigma_fault = sigma.trim() === '' || micrometres !== null ? null : t('not_number', { text: sigma.trim() });
  const options = () => {
    const near = request && form.station.every((text) => text.trim() !== '') ? { near_mm: station_place(request.setup) ?? undefined } : {};
    return JSON.stringify({ ...near, ...(micrometres === null ? {} : { machine_sigma_um: micrometres }) });
  };
  const path = (of: string, asked: string) => `/api/tracking/station${of}${query({ language: language.value, decimal: decimal.value, options: asked })}`;
  const take = (file: File) => void asking(async () => {
    set_found(null);
    if (sigma_fault !== null) throw new ApiError('refused', `${t('sigma')}${colon()} ${sigma_fault}`, 0);
    if (file.size > most_points) throw new ApiError('refused', t('too_large', { n: Math.round(file.size / 1000), most: most_points / 1000 }), 0);
    const asked = options();
    const station = (await (await made_of_files(path('', asked), file)).json()) as TrackingStation;
    set_found({ file, station, options: asked });
    if (!station.findings.some(({ severity }) => severity === 'serious')) { locate(located_station(station)); set_points(null); }
  });
  const save = (extension: string) => void asking(async () => {
    if (found) offer(await (await made_of_files(path(`/report.${extension}`, found.options), found.file)).blob(), `station.${extension}`);
  });
  return (
    <details class="more" open={found !== null || points !== null || undefined}>
      <summary>{t('exactly')}</summary>
      <div class="tracking-form">
        <p class="hint">{t('exactly_how')}</p>
        <div class="row">
          <button type="button" disabled={busy || request === null} onClick={() => void asking(async () => {
            set_points(await send<TrackingPoints>('POST', `/api/tracking/points${look()}`, { request, count }));
          })}>{t('plan_points', { n: count })}</button>
          {points && <button type="button" onClick={() => offer(new Blob([points.csv], { type: 'text/csv' }), 'points.csv')}>{t('points_table')}</button>}
          {points && <button type="button" disabled={busy} onClick={() => void asking(() => download_made(`/api/tracking/points/sheet.pdf${look()}`, { request, count }, 'points.pdf'))}>{t('points_sheet')}</button>}
        </div>
        {points && <p class="quiet small">{t('points_expected', { u: fixed(Math.max(...points.expected.amplification), 1) })}</p>}
        <NumberField label={t('sigma')} value={sigma} fault={sigma_fault} set={set_sigma} placeholder="0" />
        <FileDrop label={t('choose_points')} hint={t('drop_points')} accept=".csv,.txt,text/csv" take={take} />
        {found && <TrackingFindings findings={found.station.findings} />}
        {found && (
          <div class="row">
            <button type="button" disabled={busy} onClick={() => save('pdf')}>{t('report')} PDF</button>
            <button type="button" disabled={busy} onClick={() => save('html')}>{t('report')} HTML</button>
            <button type="button" disabled={busy} onClick={() => save('json')}>{t('station_file')}</button>
          </div>
        )}
      </div>
    </details>
  );
}
