// SPDX-License-Identifier: Apache-2.0
// What the chart draws itself: bands, limits, whiskers, and points whose shapes tell series apart without colour.
import type uPlot from 'uplot';
import type { ChartBand, ChartLine, ChartSeries, Shape, Values } from './model';

/** The colour that a token stands for now. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Draws inside the plot's frame only, and leaves the brush as it was. */
export function inside(plot: uPlot, draw: (pen: CanvasRenderingContext2D) => void): void {
  const pen = plot.ctx;
  pen.save();
  pen.beginPath();
  pen.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  pen.clip();
  draw(pen);
  pen.restore();
}

export function paint_band(plot: uPlot, pen: CanvasRenderingContext2D, x: readonly number[], band: ChartBand): void {
  pen.fillStyle = token(band.colour);
  pen.globalAlpha = band.opacity ?? 0.14;
  let start = 0;
  while (start < x.length) {
    // A stretch where both edges exist; gaps stay open.
    while (start < x.length && !both(band, start)) start += 1;
    let end = start;
    while (end < x.length && both(band, end)) end += 1;
    if (end > start) {
      pen.beginPath();
      for (let i = start; i < end; i += 1) pen.lineTo(...at(plot, x, band.upper, i));
      for (let i = end - 1; i >= start; i -= 1) pen.lineTo(...at(plot, x, band.lower, i));
      pen.closePath();
      pen.fill();
    }
    start = end;
  }
}

const both = (band: ChartBand, i: number): boolean => typeof band.upper[i] === 'number' && typeof band.lower[i] === 'number';
const at = (plot: uPlot, x: readonly number[], values: Values, i: number): [number, number] => [
  plot.valToPos(x[i] as number, 'x', true), plot.valToPos(values[i] as number, 'y', true),
];

export function paint_line(plot: uPlot, pen: CanvasRenderingContext2D, line: ChartLine, ratio: number): void {
  const y = Math.round(plot.valToPos(line.value, 'y', true));
  pen.strokeStyle = token(line.colour);
  pen.lineWidth = 1.25 * ratio;
  pen.setLineDash((line.dash ?? [6, 4]).map((length) => length * ratio));
  pen.beginPath();
  pen.moveTo(plot.bbox.left, y);
  pen.lineTo(plot.bbox.left + plot.bbox.width, y);
  pen.stroke();
  pen.setLineDash([]);
}

/** What of a series lies within the plot: the index of each value, and where it is. */
function* within(plot: uPlot, x: readonly number[], series: ChartSeries, ratio: number): Generator<[index: number, value: number, left: number, top: number]> {
  const first = plot.scales['x']?.min ?? -Infinity;
  const last = plot.scales['x']?.max ?? Infinity;
  for (let i = 0; i < x.length; i += 1) {
    const value = series.values[i];
    if (typeof value !== 'number' || (x[i] as number) < first || (x[i] as number) > last) continue;
    const [left, top] = at(plot, x, series.values, i);
    yield [i, value, left + (series.aside ?? 0) * ratio, top];
  }
}

/** Beneath all lines and points, and quieter, with caps of different width where those of several series stand over each other. */
export function paint_whiskers(plot: uPlot, pen: CanvasRenderingContext2D, x: readonly number[], series: ChartSeries, cap_px: number, ratio: number): void {
  if (!series.whisker) return;
  pen.strokeStyle = token(series.colour);
  pen.globalAlpha = 0.6 * (series.opacity ?? 1);
  pen.lineWidth = 1.25 * ratio;
  pen.setLineDash([]);
  const cap = cap_px * ratio;
  for (const [i, , left] of within(plot, x, series, ratio)) {
    const ends = series.whisker[i];
    if (!ends || ends[1] <= ends[0]) continue;
    const [below, above] = ends.map((end) => plot.valToPos(end, 'y', true)) as [number, number];
    pen.beginPath();
    pen.moveTo(left, above); pen.lineTo(left, below);
    pen.moveTo(left - cap, above); pen.lineTo(left + cap, above);
    pen.moveTo(left - cap, below); pen.lineTo(left + cap, below);
    pen.stroke();
  }
  pen.globalAlpha = 1;
}

export function paint_points(plot: uPlot, pen: CanvasRenderingContext2D, x: readonly number[], series: ChartSeries, ratio: number): void {
  if (!series.shape) return;
  pen.strokeStyle = pen.fillStyle = token(series.colour);
  pen.globalAlpha = series.opacity ?? 1;
  pen.setLineDash([]);
  const radius = ((series.size ?? 6) / 2) * ratio;
  for (const [, , left, top] of within(plot, x, series, ratio)) paint_shape(pen, series.shape, left, top, radius, ratio);
}

export function paint_shape(pen: CanvasRenderingContext2D, shape: Shape, x: number, y: number, r: number, ratio: number): void {
  pen.beginPath();
  if (shape === 'circle' || shape === 'ring') pen.arc(x, y, r, 0, 2 * Math.PI);
  else if (shape === 'square') pen.rect(x - r * 0.88, y - r * 0.88, r * 1.76, r * 1.76);
  else {
    const corners: Record<'diamond' | 'up' | 'down', [number, number][]> = {
      diamond: [[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]],
      up: [[0, -1.15], [1.1, 0.85], [-1.1, 0.85]],
      down: [[0, 1.15], [1.1, -0.85], [-1.1, -0.85]],
    };
    for (const [dx, dy] of corners[shape]) pen.lineTo(x + dx * r, y + dy * r);
    pen.closePath();
  }
  if (shape !== 'ring') { pen.fill(); return; }
  pen.lineWidth = 1.5 * ratio;
  pen.stroke();
}
