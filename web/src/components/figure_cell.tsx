// SPDX-License-Identifier: Apache-2.0
import type { FigureOfTest, Parameter, Verdict } from '../api/types';
import { ParameterSymbol } from './symbol';
import { Aligned, most_decimals } from './aligned';
import { absent, figure_decimals, fixed } from '../numbers';

interface Shown { value: string; U: string; verdict: Verdict | null }

export function shown_of(figures: readonly FigureOfTest[], parameter: Parameter): Shown | null {
  const found = figures.find((figure) => figure.parameter === parameter);
  if (!found) return null;
  const decimals = figure_decimals(found.value, found.U);
  return { value: fixed(found.value, decimals), U: found.U === null ? '' : fixed(found.U, decimals), verdict: found.verdict };
}

/** The head of a column of values: the symbol stands above the values, "± U" above theirs. */
export function ParameterHead({ parameter, unit, with_U = true }: { parameter: Parameter; unit?: string; with_U?: boolean }) {
  return <span><ParameterSymbol parameter={parameter} /><span class="plus-minus">{with_U && <>± <span class="symbol">U</span>{unit && ` ${unit}`}</>}</span></span>;
}

/** Of a column of such figures. */
export const column_decimals = (rows: readonly (readonly FigureOfTest[])[], parameter: Parameter): number =>
  most_decimals(rows.map((figures) => shown_of(figures, parameter)?.value));

/** A parameter's value with its U, quieter, where there is one; `decimals` of the column that it stands in. */
export function FigureCell({ shown, decimals = 0 }: { shown: Shown | null; decimals?: number }) {
  if (!shown) return <span class="quiet">{absent}</span>;
  return (
    <span class={shown.verdict === 'does not conform' ? 'over' : undefined}>
      <Aligned text={shown.value} decimals={decimals} />
      <span class="plus-minus">{shown.U !== '' && `±\u2009${shown.U}`}</span>
    </span>
  );
}
