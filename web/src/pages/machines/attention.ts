// SPDX-License-Identifier: Apache-2.0
// Which machines need to be looked at: by the last test of each axis, and by its age.
import type { Machine, Verdict } from '../../api/types';
import { days_until, months_later } from '../../components/dates';
import { due_months } from '../../settings';
import { is_over_new_limit, last_verdict } from './axis_courses';

export interface Attention {
  kind: 'does not conform' | 'new limit' | 'overdue' | 'undecided' | 'never';
  axes: readonly string[];       // of a verdict
  overdue: readonly Overdue[];   // of what is overdue
}

/** Axes whose next test has been due since one day; no names where these are all axes of the machine. */
export interface Overdue { since: string; axes: readonly string[] }

/** The day since when a next test is due; null while it is not, or when that cannot be said. */
function overdue_since(measured_on: string, months: number): string | null {
  const due = months_later(measured_on, months);
  return due !== null && (days_until(due) ?? 0) < 0 ? due : null;
}

/** What is overdue of a machine, the oldest first: each axis by its own latest test, whatever was measured of the others. */
export function overdue(machine: Machine): Overdue[] {
  const months = Number(due_months.value);
  if (months === 0 || machine.latest_test === null) return [];
  if (machine.latest_of_axes.length === 0) {
    const since = overdue_since(machine.latest_test.measured_on || machine.latest_test.received_at, months);
    return since === null ? [] : [{ since, axes: [] }];
  }
  const by_day = new Map<string, string[]>();
  for (const latest of machine.latest_of_axes) {
    // Where no day is known it was measured on the day it was received, or earlier.
    const since = overdue_since(latest.measured_on || latest.received_at, months);
    const axis = machine.axes.find(({ id }) => id === latest.axis);
    if (since !== null && axis) by_day.set(since, [...(by_day.get(since) ?? []), axis.name]);
  }
  return [...by_day.entries()].sort(([a], [b]) => a.localeCompare(b)).map(([since, axes]) => ({ since, axes: axes.length === machine.axes.length ? [] : axes }));
}

/** The gravest first. */
export function attention(machine: Machine): Attention[] {
  const all: Attention[] = [];
  const of_verdict = (kind: Verdict & Attention['kind']) => {
    const axes = machine.axes.filter((axis) => last_verdict(axis.id) === kind).map((axis) => axis.name);
    // The last test of all is known at once; those of the axes come a moment later.
    if (axes.length > 0 || machine.latest_test?.verdict === kind) all.push({ kind, axes, overdue: [] });
  };
  of_verdict('does not conform');
  const over = machine.axes.filter(is_over_new_limit).map((axis) => axis.name);
  if (over.length > 0) all.push({ kind: 'new limit', axes: over, overdue: [] });
  const late = overdue(machine);
  if (late.length > 0) all.push({ kind: 'overdue', axes: [], overdue: late });
  of_verdict('undecided');
  if (machine.latest_test === null) all.push({ kind: 'never', axes: [], overdue: [] });
  return all;
}

const weights = { 'does not conform': 16, 'new limit': 8, overdue: 4, undecided: 2, never: 1 };
export const weight = (machine: Machine): number => attention(machine).reduce((sum, one) => sum + weights[one.kind], 0);
