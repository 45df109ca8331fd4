// SPDX-License-Identifier: Apache-2.0
import type { FigureOfTest, Method, Parameter, Verdict } from '../api/types';
import { absent, decimals_for, fixed } from '../numbers';
import { Aligned, most_decimals } from './aligned';
import { ParameterSymbol } from './symbol';
import { method_title } from './uncertainty';

/** A value with its uncertainty of record: U, or the interval where the method states that. */
export interface ShownFigure { value: string; U: string; interval: string; method: Method | null; verdict: Verdict | null }

const finest = 6;
const noise = 5e-5;           // µm or ″: what is smaller comes from the arithmetic
const sizes: readonly Parameter[] = ['A', 'A_up', 'A_down', 'E', 'E_up', 'E_down'];

/** As the pages of the tests have them: two digits of the uncertainty; without one, of the test's A or E, but one at least. */
function decimals_in(figures: readonly FigureOfTest[], { U, low, high }: FigureOfTest): number {
  const u = U ?? (low !== null && high !== null ? (high - low) / 4 : 0);
  if (u > 0) return Math.min(decimals_for(u, 2), finest);
  const size = sizes.map((key) => figures.find((figure) => figure.parameter === key)?.value).find((value) => value !== undefined) ?? 0;
  return size > noise ? Math.min(Math.max(decimals_for(size, 2), 1), finest) : 1;
}

export function shown_of(figures: readonly FigureOfTest[], parameter: Parameter): ShownFigure | null {
  const found = figures.find((figure) => figure.parameter === parameter);
  if (!found) return null;
  const { value, U, low, high, method, verdict } = found;
  const decimals = decimals_in(figures, found);
  const interval = U === null && low !== null && high !== null ? `${fixed(low, decimals)}\u202f…\u2009${fixed(high, decimals)}` : '';
  return { value: fixed(value, decimals), U: U === null ? '' : fixed(U, decimals), interval, method, verdict };
}

/** What a test of one direction has in the place of a parameter of both: A↑ for A. Itself where it exists, or where both or neither do. */
export function at_hand(figures: readonly FigureOfTest[], parameter: Parameter): Parameter {
  const has = (key: string): boolean => figures.some((figure) => figure.parameter === key);
  if (has(parameter) || has(`${parameter}_up`) === has(`${parameter}_down`)) return parameter;
  return (has(`${parameter}_up`) ? `${parameter}_up` : `${parameter}_down`) as Parameter;
}

/** "± 4.3", or the interval; '' where nothing is known. */
export const uncertainty_text = ({ U, interval }: ShownFigure): string => (U !== '' ? `±\u2009${U}` : interval);

/** The head of a column of values: the symbol stands above the values, "± U" above theirs, where they have it. */
export function ParameterHead({ parameter, unit, with_U = true }: { parameter: Parameter; unit?: string; with_U?: boolean }) {
  return <span><ParameterSymbol parameter={parameter} /><span class="plus-minus">{with_U && <>± <span class="symbol">U</span>{unit && ` ${unit}`}</>}</span></span>;
}

/** Of a column of such figures. */
export const column_decimals = (rows: readonly (readonly FigureOfTest[])[], parameter: Parameter): number =>
  most_decimals(rows.map((figures) => shown_of(figures, at_hand(figures, parameter))?.value));

/** Whether any of them has a U, which the head of their column then names. */
export const some_U = (rows: readonly (readonly FigureOfTest[])[]): boolean => rows.some((figures) => figures.some(({ U }) => U !== null));

/** Whether any of them states an interval alone. */
export const some_interval = (rows: readonly (readonly FigureOfTest[])[]): boolean => rows.some((figures) => figures.some(({ U, low }) => U === null && low !== null));

/** A parameter's value with its uncertainty, quieter, where there is one; `decimals` of the column that it stands in; `named` where it is not the column's. */
export function FigureCell({ shown, decimals = 0, named }: { shown: ShownFigure | null; decimals?: number; named?: Parameter | undefined }) {
  if (!shown) return <span class="quiet">{absent}</span>;
  return (
    <span class={shown.verdict === 'does not conform' ? 'over' : undefined}>
      {named && <span class="quiet one-direction"><ParameterSymbol parameter={named} /> </span>}
      <Aligned text={shown.value} decimals={decimals} />
      <span class="plus-minus" title={shown.method === null ? undefined : method_title(shown.method)}>{uncertainty_text(shown)}</span>
    </span>
  );
}
