// SPDX-License-Identifier: Apache-2.0
// Which machines need to be looked at: by the last test of each axis, and by its age.
import type { Machine, Verdict } from '../../api/types';
import { days_until, months_later } from '../../components/dates';
import { due_months } from '../../settings';
import { last_verdict } from './axis_courses';

export interface Attention {
  kind: 'does not conform' | 'overdue' | 'undecided' | 'never';
  since: string;            // of what is overdue
  axes: readonly string[];  // of a verdict
}

/** The day since when its next test is due; null while it is not, or when that cannot be said. */
export function overdue_since(machine: Machine): string | null {
  const months = Number(due_months.value);
  if (months === 0 || machine.latest_test === null) return null;
  const due = months_later(machine.latest_test.measured_on, months);
  return due !== null && (days_until(due) ?? 0) < 0 ? due : null;
}

/** The gravest first. */
export function attention(machine: Machine): Attention[] {
  const all: Attention[] = [];
  const of_verdict = (kind: Verdict & Attention['kind']) => {
    const axes = machine.axes.filter((axis) => last_verdict(axis.id) === kind).map((axis) => axis.name);
    // The last test of all is known at once; those of the axes come a moment later.
    if (axes.length > 0 || machine.latest_test?.verdict === kind) all.push({ kind, since: '', axes });
  };
  of_verdict('does not conform');
  const since = overdue_since(machine);
  if (since !== null) all.push({ kind: 'overdue', since, axes: [] });
  of_verdict('undecided');
  if (machine.latest_test === null) all.push({ kind: 'never', since: '', axes: [] });
  return all;
}

const weights = { 'does not conform': 8, overdue: 4, undecided: 2, never: 1 };
export const weight = (machine: Machine): number => attention(machine).reduce((sum, one) => sum + weights[one.kind], 0);
