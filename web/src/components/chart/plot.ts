// SPDX-License-Identifier: Apache-2.0
// The chart library, set up as all charts of the workbench look.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { marked } from '../../numbers';
import { paint_line_labels } from './labels';
import { mark_row_px, paint_marks } from './marks';
import { mark_rows, y_range, type ChartModel } from './model';
import { inside, paint_band, paint_line, paint_points, paint_whiskers, token } from './paint';

export interface PlotEvents {
  pointed: (plot: uPlot) => void;   // the pointer moved over the plot, or left it
  drawn: () => void;                // scales or size may have changed
  zoomed: () => void;
  unzoomed: () => void;
}

const pixels = () => window.devicePixelRatio || 1;
const day = 86_400;

const month_steps = [1, 2, 3, 6, 12, 24, 60, 120, 240];
const day_steps = [1, 2, 7, 14];

/** Where dates stand below the chart: at beginnings of months or years, or days where the stretch is short. */
export function time_splits(low: number, high: number, most: number): number[] {
  const day_step = day_steps.find((days) => (high - low) / (days * day) <= most);
  if (day_step !== undefined) {
    const step = day_step * day;
    return every(Math.ceil(low / step) * step, high, (at) => at + step);
  }
  const months = month_steps.find((n) => (high - low) / (n * 30.44 * day) <= most) ?? 480;
  const first = new Date(low * 1000);
  let month = Math.ceil((first.getUTCFullYear() * 12 + first.getUTCMonth() + (first.getUTCDate() > 1 ? 1 : 0)) / months) * months;
  const second = () => Date.UTC(Math.floor(month / 12), month % 12, 1) / 1000;
  return every(second(), high, () => { month += months; return second(); });
}

function every(first: number, last: number, next: (at: number) => number): number[] {
  const all: number[] = [];
  for (let at = first; at <= last && all.length < 200; at = next(at)) all.push(at);
  return all;
}

/** Dates as everywhere in the workbench, as fine as they need to be. */
function time_ticks(splits: number[]): string[] {
  const dates = splits.map((second) => new Date(second * 1000).toISOString());
  const cut = dates.every((date) => date.slice(5, 10) === '01-01') ? 4 : dates.every((date) => date.slice(8, 10) === '01') ? 7 : 10;
  return dates.map((date) => date.slice(0, cut));
}

/** As many decimals as the step between ticks has: 2.5 needs one. */
function number_ticks(splits: number[], step: number): string[] {
  let decimals = 0;
  while (decimals < 9 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals += 1;
  return splits.map((value) => marked(value.toFixed(decimals)));
}

/** Between ticks of an angle: what divides a turn, below that what divides a degree. */
const degree_steps = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720, 1440, 3600];

/** The line of a series that stands aside goes along with its points. */
function moved_line(pixels_aside: number): uPlot.Series.PathBuilder {
  const straight = uPlot.paths.linear?.();
  return (plot, series, first, last) => {
    const made = straight?.(plot, series, first, last) ?? null;
    if (made === null || !(made.stroke instanceof Path2D)) return made;
    const stroke = new Path2D();
    stroke.addPath(made.stroke, new DOMMatrix().translate(pixels_aside * pixels(), 0));
    return { ...made, stroke };
  };
}

function axis(label: string, kind: 'number' | 'angle' | 'time', side: 'x' | 'y'): uPlot.Axis {
  const font = `12px ${token('--font')}`;
  return {
    label, font, labelFont: font, labelSize: 18, labelGap: 0, gap: 5,
    size: side === 'x' ? 24 : 44,
    space: kind === 'time' ? 84 : side === 'x' ? 56 : 34,
    stroke: () => token('--ink-quiet'),
    grid: { stroke: () => token('--line'), width: 1 },
    ticks: { show: false },
    ...(kind === 'time' ? { splits: (plot: uPlot, _axis: number, low: number, high: number) => time_splits(low, high, plot.bbox.width / pixels() / 84) } : {}),
    ...(kind === 'angle' ? { incrs: degree_steps } : {}),
    values: (_plot, splits, _axis, _space, step) => (kind === 'time' ? time_ticks(splits) : number_ticks(splits, step)),
  };
}

/** A little room beside the first and the last point. */
function x_range(model: ChartModel, low: number, high: number): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const one = model.x_kind === 'time' ? 30 * day : 1;
  const margin = high > low ? (high - low) * 0.02 : one;
  return [low - margin, high + margin];
}

/** `model` is asked at each drawing, so that new values need no new plot. */
export function make_plot(model: () => ChartModel, events: PlotEvents, size: { width: number; height: number }, into: HTMLElement): uPlot {
  const shape = model();
  const kind = shape.x_kind ?? 'number';
  const options: uPlot.Options = {
    ...size,
    padding: [8 + mark_rows(shape) * mark_row_px, kind === 'time' ? 44 : 20, 0, 0], // half of the last date stands beside the plot
    tzDate: (second) => uPlot.tzDate(new Date(second * 1000), 'Etc/UTC'),
    legend: { show: false },
    cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: true, uni: 24, dist: 6 } },
    scales: {
      x: {
        time: false,
        range: (_plot, low, high) => {
          const x = model().x;
          if (x.length === 1) return x_range(model(), x[0] as number, x[0] as number);
          return low === x[0] && high === x[x.length - 1] ? x_range(model(), low, high) : [low, high];
        },
      },
      y: {
        range: (plot) => {
          const [first, last] = plot.series[0]?.idxs ?? [0, model().x.length - 1];
          return y_range(model(), first, last);
        },
      },
    },
    axes: [axis(shape.x_label, kind, 'x'), axis(shape.y_label, 'number', 'y')],
    series: [
      {},
      ...shape.series.map((series): uPlot.Series => ({
        label: series.label, show: !series.hidden, width: series.width ?? 1.5, alpha: series.opacity ?? 1,
        spanGaps: series.across ?? false, points: { show: false },
        stroke: () => token(series.colour),
        ...(series.dash ? { dash: [...series.dash] } : {}),
        ...(series.width === 0 ? { paths: () => null } : series.aside ? { paths: moved_line(series.aside) } : {}),
      })),
    ],
    hooks: {
      drawAxes: [
        (plot) => paint_marks(plot, model(), pixels()),
        (plot) => inside(plot, (pen) => {
          for (const band of model().bands ?? []) if (!band.hidden) paint_band(plot, pen, model().x, band);
          pen.globalAlpha = 1;
          for (const line of model().lines ?? []) if (!line.hidden) paint_line(plot, pen, line, pixels());
          const shown = model().series.filter((series) => series.whisker && !series.hidden);
          shown.forEach((series, n) => paint_whiskers(plot, pen, model().x, series, 3 + 2 * (shown.length - 1 - n), pixels()));
        }),
      ],
      drawSeries: [
        (plot, index) => {
          const series = model().series[index - 1];
          if (series && !series.hidden) inside(plot, (pen) => paint_points(plot, pen, model().x, series, pixels()));
        },
      ],
      draw: [
        (plot) => inside(plot, (pen) => paint_line_labels(plot, pen, model(), pixels())),
        () => events.drawn(),
      ],
      setCursor: [(plot) => events.pointed(plot)],
      setSelect: [(plot) => { if (plot.select.width > 0 || plot.select.height > 0) events.zoomed(); }],
      ready: [(plot) => plot.over.addEventListener('dblclick', () => events.unzoomed())],
    },
  };
  return new uPlot(options, aligned(shape), into);
}

export function aligned(model: ChartModel): uPlot.AlignedData {
  return [[...model.x], ...model.series.map((series) => [...series.values])];
}

/** Makes the stretch of x that is shown `factor` as long, around a place that stays; y follows what is visible. */
export function zoom(plot: uPlot, model: ChartModel, factor: number, around: number): boolean {
  const { min, max } = plot.scales['x'] ?? {};
  if (min === undefined || max === undefined || min === null || max === null) return false;
  const [low, high] = x_range(model, model.x[0] ?? NaN, model.x[model.x.length - 1] ?? NaN);
  const next = [around - (around - min) * factor, around + (max - around) * factor] as [number, number];
  const all = next[0] <= low && next[1] >= high;
  plot.setScale('x', { min: Math.max(next[0], low), max: Math.min(next[1], high) });
  return !all;
}

export function unzoom(plot: uPlot, model: ChartModel): void {
  plot.setData(aligned(model), true);
}
