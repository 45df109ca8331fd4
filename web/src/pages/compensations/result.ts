// SPDX-License-Identifier: Apache-2.0
// Which figures of a compensation are shown.
import type { Parameter, ParameterNumbers } from '../../api/types';

const families = ['A', 'E', 'R', 'B', 'M'] as const;

/** A, E, R, B and M as far as there are; of a test in one direction those of that direction. */
export function shown_parameters(values: ParameterNumbers): Parameter[] {
  return families.flatMap((letter) => {
    const found = ([letter, `${letter}_up`, `${letter}_down`] as Parameter[]).find((key) => typeof values[key] === 'number');
    return found === undefined ? [] : [found];
  });
}
