// SPDX-License-Identifier: Apache-2.0
// The recent history of every axis, for the overview of all machines.
import { signal } from '@preact/signals';
import { get } from '../../api/client';
import type { Axis, Trend, Verdict } from '../../api/types';
import { parameters, verdict_of } from './parameters';

const at_once = 4;

export const courses = signal<ReadonlyMap<number, Trend>>(new Map());
/** The same when all are there: only then are machines ordered by them, so that rows do not jump one by one. */
const complete = signal<ReadonlyMap<number, Trend>>(new Map());

/** Asks for all of them, a few at a time, and gives what ends it. One that fails is left out: its row says so by a dash. */
export function load_courses(axes: readonly Axis[]): () => void {
  const abort = new AbortController();
  const waiting = [...axes];
  const found = new Map(courses.value);
  let shown = 0;
  const show = () => { shown = performance.now(); courses.value = new Map(found); };
  const work = async () => {
    for (let axis = waiting.shift(); axis !== undefined && !abort.signal.aborted; axis = waiting.shift()) {
      const path = `/api/axes/${axis.id}/trend?parameters=${parameters.join(',')}&limit=24`;
      const trend = await get<Trend>(path, abort.signal).catch(() => null);
      if (trend) found.set(axis.id, trend);
      if (performance.now() - shown > 60) show();
    }
  };
  void Promise.all(Array.from({ length: at_once }, work)).then(() => {
    if (abort.signal.aborted) return;
    show();
    complete.value = courses.value;
  });
  return () => abort.abort();
}

/** Whether its last test stands over a limit of the axis that it was not judged by: it was given since, or the test brought its own. */
export function is_over_new_limit(axis: Axis): boolean {
  const points = complete.value.get(axis.id)?.points ?? [];
  const figures = points[points.length - 1]?.figures ?? [];
  return axis.limits.some(({ parameter, value }) =>
    figures.some((one) => one.parameter === parameter && one.limit !== value && Math.abs(one.value) > value && one.verdict !== 'does not conform'));
}

/** Of the last test of an axis. */
export function last_verdict(axis: number): Verdict | null {
  const points = complete.value.get(axis)?.points;
  return verdict_of(points?.[points.length - 1]);
}
