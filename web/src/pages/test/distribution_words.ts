// SPDX-License-Identifier: Apache-2.0
// "uniform -0.25 0.25", as inputs state their distributions, in the words of the report.
import { texts } from '../../i18n/texts';
import { parsed, shortest } from '../../numbers';

const t = texts({
  uniform: 'uniform from {0} to {1}',
  triangular: 'triangular from {0} to {1}',
  arcsine: 'arcsine from {0} to {1}',
  trapezoidal: 'trapezoidal from {0} to {1}, top to base {2}',
  ctrap: 'uniform from {0} to {1}, limits ± {2}',
  constant: 'constant {0}',
  normal: 'normal, mean {0}, standard deviation {1}',
  t: 't with {0} degrees of freedom, location {1}, scale {2}',
});

const forms = { constant: 1, uniform: 2, triangular: 2, arcsine: 2, trapezoidal: 3, ctrap: 3, normal: 2, t: 3 } as const;

/** What is of no known form stays as it is; what has no distribution has no words. */
export function distribution_words(text: string | null): string {
  if (text === null) return '';
  const [name, ...rest] = text.split(' ');
  const form = (Object.keys(forms) as (keyof typeof forms)[]).find((one) => one === name);
  const numbers = rest.map(parsed);
  if (form === undefined || numbers.length !== forms[form] || numbers.includes(null)) return text;
  const [first = '', second = '', third = ''] = numbers.map((number) => shortest(number, 5));
  return t(form, { 0: first, 1: second, 2: third });
}
