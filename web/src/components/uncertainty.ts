// SPDX-License-Identifier: Apache-2.0
// The uncertainty of record in words: which method found it, and how lists name it.
import type { Evaluated, FigureOfTest, Method, MonteCarloOutput } from '../api/types';
import { texts } from '../i18n/texts';
import { fixed, shortest } from '../numbers';

const t = texts({
  annex_a: 'Annex A',
  gum: 'GUM',
  monte_carlo: 'Monte Carlo',
  unnamed: 'method not kept',
  of_record: 'Uncertainty of record: {method}.',
  k: 'k = {k}',
  k_range: 'k = {least} to {most}',
  percent: '{percent} %',
  of_each: 'Uncertainty of record: of each test by its own method, named with it.',
});

export const method_title = (method: Method): string => t(method);

/** As `uncertainty.method` takes it. */
export const method_word = (method: Method): string => method.replace('_', '-');
export const all_methods: readonly Method[] = ['annex_a', 'gum', 'monte_carlo'];

/** What the Monte Carlo method states: an interval that holds for every kind of noise and the measured value; null where it refuses one. */
export function stated_interval({ value, low, high, symmetric, refusal }: MonteCarloOutput): [number, number] | null {
  if (refusal !== undefined) return null;
  return [Math.min(value, low ?? symmetric[0]), Math.max(value, high ?? symmetric[1])];
}

/** What U or interval of a method mean: k of U, of several parameters its range, or the probability of an interval; '' where it states none. */
export function coverage_words({ result: { uncertainty } }: Evaluated, method: Method): string {
  if (method === 'annex_a') return t('k', { k: 2 });
  if (method === 'monte_carlo') return uncertainty.monte_carlo_run ? t('percent', { percent: shortest(Number((100 * uncertainty.monte_carlo_run.coverage).toFixed(4))) }) : '';
  const factors = Object.values(uncertainty.gum ?? {}).flatMap((of_one) => (of_one ? [of_one.k] : []));
  if (factors.length === 0) return '';
  const [least, most] = [fixed(Math.min(...factors), 2), fixed(Math.max(...factors), 2)];
  return least === most ? t('k', { k: least }) : t('k_range', { least, most });
}

/** A method and what its U or interval mean: "Annex A, k = 2". */
export function method_with_coverage(evaluated: Evaluated, method: Method): string {
  const words = coverage_words(evaluated, method);
  return words === '' ? t(method) : `${t(method)}, ${words}`;
}

const is_stated = ({ U, low }: FigureOfTest): boolean => U !== null || low !== null;

/** By what a test's figures were found; null where none has an uncertainty, '' where an earlier program kept no method. */
export function method_of(figures: readonly FigureOfTest[]): Method | '' | null {
  const found = figures.find(is_stated);
  return found ? (found.method ?? '') : null;
}

export const named_method = (method: Method | '' | null): string => (method === null ? '' : method === '' ? t('unnamed') : t(method));

/** Of several tests: whether their uncertainties are of more than one kind. */
export const differ = (tests: readonly (readonly FigureOfTest[])[]): boolean =>
  new Set(tests.map(method_of).filter((method) => method !== null)).size > 1;

/** What a list says of the uncertainties in it; nothing where there are none. */
export function record_note(tests: readonly (readonly FigureOfTest[])[]): string {
  const found = tests.map(method_of).find((method) => method !== null);
  if (found === undefined) return '';
  return differ(tests) ? t('of_each') : t('of_record', { method: named_method(found) });
}
