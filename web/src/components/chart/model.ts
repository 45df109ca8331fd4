// SPDX-License-Identifier: Apache-2.0
// What a chart shows, said in terms of the drawing and free of the library that draws it.
import type { ComponentChildren } from 'preact';

export type Values = readonly (number | null)[];
export type Shape = 'circle' | 'square' | 'diamond' | 'up' | 'down' | 'ring';

/** Of a whisker: the ends of an interval, which need not lie evenly about the value. */
export type Ends = readonly [low: number, high: number];

export interface ChartSeries {
  key: string;               // stays the same while the values change
  label: string;
  values: Values;            // one for each x; null where there is none
  colour: string;            // a token of styles/tokens.css, "--series-up"
  width?: number;            // of the line in px; 0: points only; 1.5 when not given
  dash?: readonly number[];
  shape?: Shape | null;      // of the points; null: a line only
  size?: number;             // of the points in px; 6 when not given
  opacity?: number;          // 0 to 1
  whisker?: readonly (Ends | null)[];
  aside?: number;            // px to the right of its place, so that whiskers of several series do not cover each other
  hidden?: boolean;
  quiet?: boolean;           // not found by the pointer: help lines
  across?: boolean;          // the line goes on over missing values
}

/** An area between two curves, behind all lines. */
export interface ChartBand { key: string; upper: Values; lower: Values; colour: string; opacity?: number; hidden?: boolean }

/** A limit: a line across the whole chart, with its name beside it. */
export interface ChartLine { value: number; colour: string; label: string; dash?: readonly number[]; hidden?: boolean }

/** Something that happened at an x: a line from top to bottom, its name above the plot. */
export interface ChartMark { x: number; label: string; colour: string; aside?: number }

export interface ChartModel {
  x: readonly number[];      // ascending; for "time" seconds since 1970 in UTC
  x_kind?: 'number' | 'angle' | 'time';   // an angle in degrees has steps of 15, 30, 45 and 90
  x_label: string;
  y_label: string;
  y_decimals?: number;       // of tips and announcements, 2 when not given
  y_zero?: boolean;          // the scale always shows 0
  series: readonly ChartSeries[];
  bands?: readonly ChartBand[];
  lines?: readonly ChartLine[];
  marks?: readonly ChartMark[];
}

/** Where the cursor is: which x, and which series where the pointer or the keys chose one. */
export interface ChartPlace { index: number; series: number | null }

export interface ChartProps extends ChartModel {
  name: string;              // what the chart shows, for those who do not see it
  height?: number;           // px, 320 when not given
  tip?: (place: ChartPlace) => ComponentChildren;   // the default lists the visible series
  spoken?: (place: ChartPlace) => string;           // announced when the keys move the cursor
  cursor?: number | null;    // marks this x from outside, as from a row of a table
  on_cursor?: (place: ChartPlace | null) => void;
  on_choose?: (place: ChartPlace) => void;          // a click on a point, or Enter
}

/** Rows above the plot for names of marks: as many as there are marks, but so few that the plot stays the picture. */
export const mark_rows = ({ marks }: ChartModel): number => Math.min(marks?.length ?? 0, 3);

/** What makes another plot necessary; everything else is only drawn again. */
export function structure(model: ChartModel): string {
  const looks = model.series.map((s) => [s.key, s.colour, s.width, s.dash, s.shape, s.size, s.opacity, s.across, s.aside]);
  return JSON.stringify([model.x_kind, model.x_label, model.y_label, looks, mark_rows(model)]);
}

/** Lowest and highest of what is visible from index `first` to `last`, with a margin; 0 to 1 when there is nothing. */
export function y_range(model: ChartModel, first: number, last: number): [number, number] {
  let low = model.y_zero ? 0 : Infinity;
  let high = model.y_zero ? 0 : -Infinity;
  const take = (value: number | null | undefined) => {
    if (value === null || value === undefined || !Number.isFinite(value)) return;
    if (value < low) low = value;
    if (value > high) high = value;
  };
  for (const series of model.series) {
    if (series.hidden) continue;
    for (let i = first; i <= last; i += 1) {
      const value = series.values[i] ?? null;
      if (value === null) continue;
      take(value);
      series.whisker?.[i]?.forEach(take);
    }
  }
  for (const band of model.bands ?? []) {
    if (band.hidden) continue;
    for (let i = first; i <= last; i += 1) { take(band.upper[i]); take(band.lower[i]); }
  }
  for (const line of model.lines ?? []) if (!line.hidden) take(line.value);
  if (low > high) return [0, 1];
  const margin = high > low ? (high - low) * 0.06 : Math.max(Math.abs(high) * 0.1, 0.5);
  return [model.y_zero && low === 0 ? 0 : low - margin, high + margin];
}
