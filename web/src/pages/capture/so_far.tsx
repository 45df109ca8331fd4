// SPDX-License-Identifier: Apache-2.0
import type { Evaluated, Parameter } from '../../api/types';
import { ParameterSymbol } from '../../components/symbol';
import { absent, marked } from '../../numbers';
import type { Direction } from './live';
import { t } from './texts';

interface Props {
  evaluated: Evaluated | null;
  directions: readonly Direction[];
  running: boolean;
  runs: number; // that the plan has
}

/** What one looks at first; of an axis that is approached in one direction only, the parameters of that direction. */
function looked_at([one = 'up', other]: readonly Direction[]): readonly Parameter[] {
  return other ? ['A', 'E', 'R', 'B'] : [`A_${one}`, `E_${one}`, `R_${one}`];
}

export function SoFar({ evaluated, directions, running, runs }: Props) {
  const parameters = looked_at(directions);
  return (
    <section class="panel" aria-labelledby="so-far">
      <h2 id="so-far">{t('parameters')}</h2>
      {evaluated === null ? <p class="quiet">{t('too_early')}</p> : (
        <dl class="so-far">
          {evaluated.shown.filter(({ parameter }) => parameters.includes(parameter)).map(({ parameter, value, unit }) => (
            <div key={parameter}>
              <dt><ParameterSymbol parameter={parameter} /></dt>
              <dd class="number">{/\d/.test(value) ? <>{marked(value)} <span class="unit">{unit}</span></> : <Missing why={(running && awaited(parameter, runs)) || value} />}</dd>
            </div>
          ))}
        </dl>
      )}
    </section>
  );
}

/** When a parameter will come that there is not yet; empty: it will not. */
function awaited(parameter: Parameter, runs: number): string {
  if (parameter === 'E' || parameter === 'B') return t('way_back');
  return runs > 1 ? t('second_run') : '';
}

/** A parameter that cannot be given: no figure, and the reason where there is room for words. */
function Missing({ why }: { why: string }) {
  return <>{absent} <span class="unit">{why}</span></>;
}
