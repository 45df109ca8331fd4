// SPDX-License-Identifier: Apache-2.0
// Which machines need to be looked at, by their last test and its age.
import type { Machine } from '../../api/types';
import { days_until, months_later } from '../../components/dates';
import { due_months } from '../../settings';

export interface Attention { kind: 'not_conforming' | 'overdue' | 'undecided' | 'never'; since: string }

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
  const latest = machine.latest_test;
  if (latest?.verdict === 'does not conform') all.push({ kind: 'not_conforming', since: '' });
  const since = overdue_since(machine);
  if (since !== null) all.push({ kind: 'overdue', since });
  if (latest?.verdict === 'undecided') all.push({ kind: 'undecided', since: '' });
  if (latest === null) all.push({ kind: 'never', since: '' });
  return all;
}

const weights = { not_conforming: 8, overdue: 4, undecided: 2, never: 1 };
export const weight = (machine: Machine): number => attention(machine).reduce((sum, one) => sum + weights[one.kind], 0);
