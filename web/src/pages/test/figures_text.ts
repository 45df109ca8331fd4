// SPDX-License-Identifier: Apache-2.0
// Parameters as they stand on this page.
import type { Evaluated, LimitSource, Parameter, PositionResult, Result, Shown, Verdict } from '../../api/types';
import { texts } from '../../i18n/texts';
import { decimals_of, shortest } from '../../numbers';

export type { Shown } from '../../api/types';

const t = texts({
  axis: 'axis',
  table: 'table',
  test: 'file',
  entered: 'entered',
  user: 'option',
  one: '{limit} ({source})',
  replaces: 'replaces {list}',
});

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

export const shown_of = (evaluated: Evaluated, parameter: Parameter): Shown | undefined =>
  evaluated.shown.find((row) => row.parameter === parameter);

export const tone_of = (verdict: Verdict | null) =>
  verdict === 'conforms' ? 'good' : verdict === 'does not conform' ? 'bad' : verdict === 'undecided' ? 'caution' : 'none';

export const judgement_of = (evaluated: Evaluated, parameter: Parameter) => evaluated.result.tolerances?.find((one) => one.parameter === parameter);

/** Why nothing is decided about a parameter, as its judgement says it in the reader's language; null where something is. */
export function withheld_of(evaluated: Evaluated, { parameter, withheld }: Shown): string | null {
  const said = judgement_of(evaluated, parameter)?.withheld;
  return withheld === null ? null : (said ?? withheld);
}

/** The uncertainty of record as it stands behind a value: "± 4.3", "5.1 to 12.3". */
export const uncertainty_words = (row: Shown): string => (row.U !== '' ? `± ${row.U}` : row.interval);

/** Who stated a limit, in a word. */
export const source_word = (source: LimitSource): string => t(source);

/** "10 (axis)" */
export const limit_words = (limit: number, source: LimitSource | null): string =>
  source === null ? shortest(limit) : t('one', { limit: shortest(limit), source: t(source) });

/** "replaces 8 (axis)"; '' where a limit takes the place of no other. */
export function replaced_words({ limit, replaced }: Shown): string {
  const others = (replaced ?? []).filter((one) => one.limit !== limit);
  return others.length === 0 ? '' : t('replaces', { list: others.map((one) => limit_words(one.limit, one.source)).join(', ') });
}

export type Quantity = Exclude<keyof PositionResult, 'target' | 'n_up' | 'n_down'>;

/** The parameter that a column of the positions decides, and further decimals that 4 s asks of s. */
const decided: Record<Quantity, readonly [parameters: readonly Parameter[], further: number]> = {
  mean_up: [['E_up', 'E'], 0], mean_down: [['E_down', 'E'], 0], mean: [['M', 'E'], 0], reversal: [['B', 'B_mean'], 0],
  s_up: [['R_up'], 1], s_down: [['R_down'], 1], R_up: [['R_up'], 0], R_down: [['R_down'], 0], R: [['R'], 0],
};

/** A value at a position has the decimals of the parameter that it may decide, wherever on the page it stands. */
export function position_decimals(evaluated: Evaluated, quantity: Quantity): number {
  const [parameters, further] = decided[quantity];
  const row = [...parameters, ...all_parameters].map((parameter) => shown_of(evaluated, parameter)).find((one) => one !== undefined && /\d/.test(one.value));
  return decimals_of(row?.value ?? '') + further;
}
