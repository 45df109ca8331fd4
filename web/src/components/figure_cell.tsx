// SPDX-License-Identifier: Apache-2.0
import type { FigureOfTest, Parameter, Verdict } from '../api/types';
import { ParameterSymbol } from './symbol';
import { absent, fixed } from '../numbers';

interface Shown { value: string; U: string; verdict: Verdict | null }

export function shown_of(figures: readonly FigureOfTest[], parameter: Parameter): Shown | null {
  const found = figures.find((figure) => figure.parameter === parameter);
  return found ? { value: fixed(found.value, 1), U: found.U === null ? '' : fixed(found.U, 1), verdict: found.verdict } : null;
}

/** The head of a column of values: the symbol stands above the values, "± U" above theirs. */
export function ParameterHead({ parameter, unit }: { parameter: Parameter; unit?: string }) {
  return <span><ParameterSymbol parameter={parameter} /><span class="plus-minus">± <span class="symbol">U</span>{unit && ` ${unit}`}</span></span>;
}

/** A parameter's value with its U, quieter, where there is one. */
export function FigureCell({ shown }: { shown: Shown | null }) {
  if (!shown) return <span class="quiet">{absent}</span>;
  return (
    <span class={shown.verdict === 'does not conform' ? 'over' : undefined}>
      {shown.value}
      <span class="plus-minus">{shown.U !== '' && `±\u2009${shown.U}`}</span>
    </span>
  );
}
