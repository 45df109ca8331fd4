// SPDX-License-Identifier: Apache-2.0
// Mean deviations of several tests in one chart. Tests have targets of their own; nothing is shown at places where a
// test has none, except as an interpolated value that says so.
import type { Shape } from '../../components/chart/chart';
import type { ChartModel, ChartSeries } from '../../components/chart/chart';
import type { Test } from '../../api/types';
import { texts } from '../../i18n/texts';
import { position_unit, unit_sign } from '../../numbers';

const t = texts({
  position: 'Position',
  deviation: 'Mean deviation',
});

export type Curve = 'mean' | 'up' | 'down' | 'both';
export type Datum = 'own' | 'start' | 'middle';

type Way = 'mean' | 'mean_up' | 'mean_down';
export interface Points { x: number[]; y: number[] }

const looks: readonly { dash: readonly number[]; shape: Shape }[] = [
  { dash: [], shape: 'circle' }, { dash: [7, 3], shape: 'square' }, { dash: [2, 3], shape: 'diamond' }, { dash: [9, 3, 2, 3], shape: 'ring' },
  { dash: [4, 2], shape: 'up' }, { dash: [12, 4], shape: 'down' }, { dash: [1, 2], shape: 'square' }, { dash: [6, 2, 1, 2, 1, 2], shape: 'circle' },
];

/** Colour, dash and marker of the n-th test: told apart by any one of them. */
export function look_of(n: number) {
  const look = looks[n % looks.length] as (typeof looks)[number];
  return { colour: `--series-${(n % 8) + 1}`, width: 2, shape: look.shape, ...(look.dash.length > 0 ? { dash: look.dash } : {}) };
}

export function points_of(test: Test, way: Way): Points {
  const given = test.result.positions.filter((p) => p[way] !== null).sort((a, b) => a.target - b.target);
  return { x: given.map((p) => p.target), y: given.map((p) => p[way] as number) };
}

/** On the straight line between the neighbours; null outside. */
export function interpolated(points: Points, x: number): number | null {
  const after = points.x.findIndex((one) => one >= x);
  if (after === -1) return null;
  if (points.x[after] === x) return points.y[after] as number;
  if (after === 0) return null;
  const [x0, x1] = [points.x[after - 1] as number, points.x[after] as number];
  const [y0, y1] = [points.y[after - 1] as number, points.y[after] as number];
  return y0 + ((y1 - y0) * (x - x0)) / (x1 - x0);
}

/** The curve that a test is aligned by: of both directions where both were measured. */
function reference(test: Test): Points {
  for (const way of ['mean', 'mean_up', 'mean_down'] as const) {
    const points = points_of(test, way);
    if (points.x.length > 0) return points;
  }
  return { x: [], y: [] };
}

/** The stretch that all tests have in common; null where there is none. */
export function common_stretch(tests: readonly Test[]): [number, number] | null {
  const ends = tests.map((test) => reference(test).x).filter((x) => x.length > 0);
  const low = Math.max(...ends.map((x) => x[0] as number));
  const high = Math.min(...ends.map((x) => x[x.length - 1] as number));
  return ends.length > 0 && low <= high ? [low, high] : null;
}

/** What is taken off all deviations of a test, so that curves that start from different zeros can be compared. */
export function offset_of(test: Test, datum: Datum, stretch: [number, number] | null): number {
  if (datum === 'own' || stretch === null) return 0;
  const points = reference(test);
  if (datum === 'start') return interpolated(points, stretch[0]) ?? 0;
  // The mean along the common stretch: the area under the curve over its length.
  const x = [stretch[0], ...points.x.filter((one) => one > stretch[0] && one < stretch[1]), stretch[1]];
  const y = x.map((one) => interpolated(points, one) ?? 0);
  if (stretch[1] === stretch[0]) return y[0] ?? 0;
  let area = 0;
  for (let i = 1; i < x.length; i += 1) area += (((y[i - 1] as number) + (y[i] as number)) / 2) * ((x[i] as number) - (x[i - 1] as number));
  return area / (stretch[1] - stretch[0]);
}

const ways: Record<Curve, readonly (readonly [Way, string, Shape | null])[]> = {
  mean: [['mean', '', null]], up: [['mean_up', ' ↑', null]], down: [['mean_down', ' ↓', null]],
  both: [['mean_up', ' ↑', 'up'], ['mean_down', ' ↓', 'down']],
};

export interface Curves extends ChartModel {
  /** Of each series: its test's place in the list and its points, shifted. */
  of: { test: number; points: Points }[];
}

export function curves(tests: readonly Test[], curve: Curve, datum: Datum, hidden: ReadonlySet<number>): Curves {
  const stretch = common_stretch(tests);
  const x = [...new Set(tests.flatMap((test) => test.result.positions.map((p) => p.target)))].sort((a, b) => a - b);
  const place = new Map(x.map((one, i) => [one, i]));
  const series: ChartSeries[] = [];
  const of: Curves['of'] = [];
  tests.forEach((test, n) => {
    const offset = offset_of(test, datum, stretch);
    for (const [way, suffix, shape] of ways[curve]) {
      const raw = points_of(test, way);
      const points = { x: raw.x, y: raw.y.map((y) => y - offset) };
      const values: (number | null)[] = x.map(() => null);
      points.x.forEach((one, i) => { values[place.get(one) as number] = points.y[i] as number; });
      const look = look_of(n);
      series.push({ key: `${test.id}:${way}`, label: `${test.title}${suffix}`, values, ...look, shape: shape ?? look.shape, size: 7, across: true, hidden: hidden.has(test.id) });
      of.push({ test: n, points });
    }
  });
  const first = tests[0];
  return {
    x, series, of,
    x_label: `${t('position')} / ${position_unit(first?.result.axis.kind ?? 'linear')}`,
    y_label: `${t('deviation')} / ${unit_sign(first?.result.unit ?? 'um')}`,
  };
}
