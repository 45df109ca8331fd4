// SPDX-License-Identifier: Apache-2.0
// What a recording without standstills tells: curves, figures, even motion, vibrations, what is to be known.
import type { ComponentChildren } from 'preact';
import type { DynamicExtreme, DynamicResult, DynamicStretch } from '../../api/types';
import { Chart, Swatch, type ChartModel } from '../../components/chart/chart';
import { sentence } from '../../components/findings';
import { DataTable } from '../../components/table';
import { absent, count, decimals_for, fixed, shortest, unit_sign } from '../../numbers';
import { arrow_of, spectrum_model, straying_model, time_model } from './models';
import { t } from './texts';

const stretches_shown = 60;   // as a report shows

/** So many digits that count. */
const digits = (value: number, n: number): string => fixed(value, decimals_for(Math.abs(value), n));

export function DynamicView({ result }: { result: DynamicResult }) {
  return (
    <>
      <About result={result} />
      <OverTime result={result} />
      <Extremes result={result} />
      <EvenMotion result={result} />
      <Vibrations result={result} />
    </>
  );
}

function Panel({ name, title, children }: { name: string; title: string; children: ComponentChildren }) {
  return <section class="panel" aria-labelledby={`dynamic-${name}`}><header><h2 id={`dynamic-${name}`}>{title}</h2></header>{children}</section>;
}

/** Of the file, and what no figure of it can tell. */
function About({ result }: { result: DynamicResult }) {
  const { samples, rate_hz, source, remarks } = result;
  return (
    <section class="notice caution" aria-label={t('no_test')}>
      <p><strong>{t('no_test')}</strong> <span class="small number">{source.format}, {t('samples')} {count(samples)}, {shortest(rate_hz, 3)} Hz, {shortest(samples / rate_hz, 3)} s</span></p>
      <ul class="dynamic-remarks">{remarks.map((remark) => <li key={remark}>{sentence(remark)}</li>)}</ul>
    </section>
  );
}

function Named({ model, name, height }: { model: ChartModel; name: string; height: number }) {
  return <Chart {...model} name={name} height={height} />;
}

function OverTime({ result }: { result: DynamicResult }) {
  const { curves } = result;
  if (!curves) return null;
  return (
    <Panel name="over-time" title={t('over_time')}>
      <Named model={time_model(result, 'position', curves)} name={t('position')} height={220} />
      <Named model={time_model(result, 'velocity_per_s', curves)} name={t('velocity')} height={220} />
      <Named model={time_model(result, 'acceleration_per_s2', curves)} name={t('acceleration')} height={220} />
    </Panel>
  );
}

interface Extreme { key: 'velocity_highest' | 'velocity_lowest' | 'acceleration_highest' | 'acceleration_lowest'; at: DynamicExtreme; noise: number; unit: string }

function Extremes({ result }: { result: DynamicResult }) {
  const { unit, noise, velocity_per_s: v, acceleration_per_s2: a, window_s, deviation_unit } = result;
  const rows: Extreme[] = [
    { key: 'velocity_highest', at: v.highest, noise: noise.velocity_per_s, unit: `${unit}/s` },
    { key: 'velocity_lowest', at: v.lowest, noise: noise.velocity_per_s, unit: `${unit}/s` },
    { key: 'acceleration_highest', at: a.highest, noise: noise.acceleration_per_s2, unit: `${unit}/s²` },
    { key: 'acceleration_lowest', at: a.lowest, noise: noise.acceleration_per_s2, unit: `${unit}/s²` },
  ];
  const scale = deviation_unit === 'um' ? 1000 : 3600;
  return (
    <Panel name="figures" title={t('figures')}>
      <DataTable<Extreme> caption={t('figures')} rows={rows} row_key={({ key }) => key} columns={[
        { key: 'quantity', head: t('quantity'), row_head: true, cell: ({ key }) => t(key) },
        { key: 'value', head: t('value'), number: true, cell: ({ at, unit: sign }) => <>{digits(at.value, 5)}<span class="unit"> {sign}</span></> },
        { key: 'noise', head: t('noise'), number: true, cell: ({ noise: own }) => digits(own, 2) },
        { key: 'time', head: t('at_time'), number: true, cell: ({ at }) => fixed(at.time_s, 4) },
        { key: 'place', head: t('at_place', { unit }), number: true, cell: ({ at }) => fixed(at.position, 3) },
      ]} />
      <p class="quiet small">{t('averaged', { window: shortest(window_s, 4), noise: digits(noise.position * scale, 2), unit: unit_sign(deviation_unit) })}</p>
    </Panel>
  );
}

function EvenMotion({ result }: { result: DynamicResult }) {
  const { unit, uniform, uniform_share, curves, feed_per_min } = result;
  const sign = unit_sign(result.deviation_unit);
  const of_velocity = (part: number, { velocity_per_s }: DynamicStretch) => fixed((100 * part) / Math.abs(velocity_per_s), 3);
  if (uniform.length === 0) return <Panel name="even" title={t('even_motion')}><p>{t('none_even')}</p></Panel>;
  const model = curves && straying_model(result, curves);
  const drawn = curves?.straying.length ?? 0;
  return (
    <Panel name="even" title={t('even_motion')}>
      <DataTable<DynamicStretch> caption={t('even_motion')} rows={uniform.slice(0, stretches_shown)} row_key={({ begin_s }) => begin_s} columns={[
        { key: 'direction', head: t('direction'), row_head: true, cell: ({ direction }) => arrow_of(direction) },
        { key: 'begin', head: t('from_time'), number: true, cell: ({ begin_s }) => fixed(begin_s, 4) },
        { key: 'end', head: t('to_time'), number: true, cell: ({ end_s }) => fixed(end_s, 4) },
        { key: 'from', head: t('from_place', { unit }), number: true, cell: ({ from }) => fixed(from, 2) },
        { key: 'to', head: t('to_place', { unit }), number: true, cell: ({ to }) => fixed(to, 2) },
        { key: 'feed', head: t('feed_told', { unit }), number: true, cell: ({ velocity_per_s }) => digits(60 * Math.abs(velocity_per_s), 6) },
        ...(feed_per_min === null ? [] : [{ key: 'error', head: t('feed_error'), number: true, cell: ({ feed_error_percent }: DynamicStretch) => fixed(feed_error_percent, 3) }]),
        { key: 'spread', head: t('velocity_spread'), number: true, cell: (one) => of_velocity(one.velocity_standard_deviation_per_s, one) },
        { key: 'range', head: t('velocity_range'), number: true, cell: (one) => of_velocity(one.velocity_range_per_s, one) },
        { key: 'strays', head: t('strays_range', { unit: sign }), number: true, cell: ({ deviation_range }) => digits(deviation_range, 4) },
        { key: 'rms', head: t('strays_rms', { unit: sign }), number: true, cell: ({ deviation_rms }) => digits(deviation_rms, 4) },
      ]} />
      {uniform.length > stretches_shown && <p class="small">{t('more_stretches', { n: count(uniform.length - stretches_shown) })}</p>}
      <p class="quiet small">{t('even_how', { percent: shortest(100 * uniform_share) })}</p>
      {model && drawn > 0 && (
        <>
          <h3>{t('straying')}</h3>
          <p class="row small">{model.series.map((series) => <span key={series.key}><Swatch series={series} /> {series.label}</span>)}</p>
          <Named model={model} name={t('straying')} height={280} />
          {drawn < uniform.length && <p class="quiet small">{t('longest', { n: drawn, all: count(uniform.length) })}</p>}
        </>
      )}
    </Panel>
  );
}

type Peak = DynamicResult['spectrum']['peaks'][number];

function Vibrations({ result }: { result: DynamicResult }) {
  const { spectrum, unit, curves } = result;
  const sign = unit_sign(result.deviation_unit);
  const of_stretch = spectrum.of === 'longest_stretch';
  const step = decimals_for(spectrum.resolution_hz, 3);
  return (
    <Panel name="vibrations" title={t('vibrations')}>
      {spectrum.peaks.length === 0 ? <p>{t('no_vibration')}</p> : (
        <DataTable<Peak> caption={t('vibrations')} rows={spectrum.peaks} row_key={({ frequency_hz }) => frequency_hz} columns={[
          { key: 'frequency', head: t('frequency'), row_head: true, class: 'number', cell: ({ frequency_hz }) => fixed(frequency_hz, step) },
          { key: 'amplitude', head: t('amplitude', { unit: sign }), number: true, cell: ({ amplitude }) => digits(amplitude, 4) },
          ...(of_stretch ? [{ key: 'period', head: t('period', { unit }), number: true, cell: ({ period }: Peak) => (period === null ? absent : digits(period, 5)) }] : []),
        ]} />
      )}
      <p class="quiet small">
        {t(of_stretch ? 'of_stretch' : 'of_recording', { begin: fixed(spectrum.begin_s, 3), end: fixed(spectrum.end_s, 3), resolution: digits(spectrum.resolution_hz, 3) })}
        {' '}{t('stands_out', { threshold: digits(spectrum.threshold, 2), unit: sign })}
        {spectrum.peaks_more > 0 && <> {t('more_peaks', { n: spectrum.peaks_more })}</>}
      </p>
      {curves && <Named model={spectrum_model(result, curves)} name={t('spectrum')} height={280} />}
    </Panel>
  );
}
