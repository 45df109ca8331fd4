// SPDX-License-Identifier: Apache-2.0
// The result of a compensation as the program writes it: docs/results.md, "axiometry compensate".
import type { CompensationNode, Parameter, Unit, VolumetricFinding } from '../../api/types';

/** By key; null where the test has no such parameter. In µm or ″. */
export type Values = Partial<Record<Parameter, number | null>>;

/** Mean deviations at a target, mm or °; null in a direction that was not measured. */
export interface Mean { target: number; up: number | null; down: number | null }

export interface Retested {
  parameters: Values;
  means: readonly Mean[];
  share?: number;       // 1: the whole table acts, 0: nothing of it, −1: the opposite
  u?: number;           // of the share
}

export interface CompensationResult {
  control: string;
  axis: string;
  kind: 'linear' | 'rotary';
  unit: Unit;
  sign: string;
  table: readonly CompensationNode[];
  existing?: readonly CompensationNode[];
  before: Values;
  predicted: Values;
  expected_retest?: { median: Values; percent_95: Values; trials: number };
  least_squares: Values;
  interpolated: Values;
  scatter: Values;      // what no table removes
  before_means: readonly Mean[];
  predicted_means: readonly Mean[];
  smoothing: number | null;
  retest?: Retested;
  verified: { verified: string; inferred: string };
  findings: readonly VolumetricFinding[];
}

/** The API hands a result on without describing it once more. */
export const result_of = (answer: { result: object }): CompensationResult => answer.result as CompensationResult;

const families = ['A', 'E', 'R', 'B', 'M'] as const;

/** A, E, R, B and M as far as there are; of a test in one direction those of that direction. */
export function shown_parameters(values: Values): Parameter[] {
  return families.flatMap((letter) => {
    const found = ([letter, `${letter}_up`, `${letter}_down`] as Parameter[]).find((key) => typeof values[key] === 'number');
    return found === undefined ? [] : [found];
  });
}
