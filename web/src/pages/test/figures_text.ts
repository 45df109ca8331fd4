// SPDX-License-Identifier: Apache-2.0
// Parameters as they stand on this page.
import type { Evaluated, Parameter, Result } from '../../api/types';

export type Shown = Evaluated['shown'][number];

export const all_parameters: readonly Parameter[] = [
  'A', 'A_up', 'A_down', 'E', 'E_up', 'E_down', 'M', 'R', 'R_up', 'R_down', 'B', 'B_mean',
];

/** Those that are looked at first: A, E, R, B and M; of a test in one direction those of that direction. */
export function main_parameters(result: Result): Parameter[] {
  const values = result.parameters;
  const one = (parameter: Parameter): Parameter[] => {
    const candidates = [parameter, `${parameter}_up`, `${parameter}_down`] as Parameter[];
    const found = candidates.find((candidate) => values[candidate] !== null && values[candidate] !== undefined);
    return found === undefined ? [] : [found];
  };
  return (['A', 'E', 'R', 'B', 'M'] as const).flatMap(one);
}

export const plain_symbol = (parameter: Parameter): string =>
  parameter === 'B_mean' ? 'B\u0304' : parameter.replace('_up', '↑').replace('_down', '↓');
