// SPDX-License-Identifier: Apache-2.0
// What the charts of a motion show.
import type { DynamicCurve, DynamicResult } from '../../api/types';
import type { ChartModel, ChartSeries } from '../../components/chart/chart';
import { decimals_for, fixed, unit_sign } from '../../numbers';
import { t } from './texts';

type Curves = NonNullable<DynamicResult['curves']>;

const colours = [1, 2, 3, 4, 5, 6, 7, 8].map((n) => `--series-${n}`);   // as many as stretches are told
export const arrow_of = (direction: 'up' | 'down'): string => (direction === 'up' ? '↑' : '↓');

/** Decimals that show a thousandth of what a curve spans. */
function decimals_of_span(values: readonly number[]): number {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) { low = Math.min(low, value); high = Math.max(high, value); }
  return high > low ? decimals_for(high - low, 4) : 3;
}

/** One curve over time; the stretches of even motion are an area behind it. */
export function time_model(result: DynamicResult, key: 'position' | 'velocity_per_s' | 'acceleration_per_s2', curves: Curves): ChartModel {
  const { time_s: x, value: values }: DynamicCurve = curves[key];
  const { unit, uniform } = result;
  const [name, label] = key === 'position' ? [t('position'), t('position_axis', { unit })]
    : key === 'velocity_per_s' ? [t('velocity'), t('velocity_axis', { unit })] : [t('acceleration'), t('acceleration_axis', { unit })];
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) { low = Math.min(low, value); high = Math.max(high, value); }
  let next = 0;
  const within = x.map((time) => {
    while (next < uniform.length && (uniform[next]?.end_s ?? 0) < time) next += 1;
    return next < uniform.length && (uniform[next]?.begin_s ?? 0) <= time;
  });
  return {
    x, x_label: t('time_axis'), y_label: label, y_decimals: decimals_of_span(values),
    series: [{ key, label: name, values, colour: '--series-up', width: 1, shape: null }],
    bands: [{ key: 'even', upper: within.map((is) => (is ? high : null)), lower: within.map((is) => (is ? low : null)), colour: '--series-up', opacity: 0.12 }],
  };
}

/** Amplitudes, with a mark at each vibration that is listed. */
export function spectrum_model(result: DynamicResult, curves: Curves): ChartModel {
  const unit = unit_sign(result.deviation_unit);
  const { frequency_hz: x, value: values } = curves.spectrum;
  const highest = result.spectrum.peaks.slice(0, 3);
  return {
    x, x_label: t('frequency_axis'), y_label: t('amplitude_axis', { unit }), y_decimals: decimals_of_span(values), y_zero: true,
    series: [{ key: 'amplitude', label: t('amplitude_name'), values, colour: '--series-up', width: 1, shape: null }],
    marks: highest.map((peak) => ({ x: peak.frequency_hz, label: `${fixed(peak.frequency_hz, decimals_for(result.spectrum.resolution_hz, 2))} Hz`, colour: '--series-down' })),
    lines: [{ value: result.spectrum.threshold, colour: '--ink-quiet', label: fixed(result.spectrum.threshold, decimals_for(result.spectrum.threshold, 2)), dash: [4, 3] }],
  };
}

/** Of several stretches each its line: places of all, in order, and what is known at each. */
export function straying_model(result: DynamicResult, curves: Curves): ChartModel {
  const unit = unit_sign(result.deviation_unit);
  const all = curves.straying.flatMap(({ position, value }, line) => position.map((place, k) => ({ place, line, value: value[k] ?? 0 })));
  all.sort((a, b) => a.place - b.place);
  const series = curves.straying.map(({ begin_s }, line): ChartSeries => {
    const stretch = result.uniform.find((one) => one.begin_s === begin_s);
    return {
      key: `${line}`, label: t('stretch', { arrow: arrow_of(stretch?.direction ?? 'up'), begin: fixed(begin_s, 2) }), colour: colours[line % colours.length] ?? '--series-up',
      values: all.map((one) => (one.line === line ? one.value : null)), width: 1, shape: null, across: true,
    };
  });
  return { x: all.map(({ place }) => place), x_label: t('position_axis', { unit: result.unit }), y_label: t('strays_axis', { unit }), y_decimals: decimals_of_span(all.map(({ value }) => value)), series };
}
