// SPDX-License-Identifier: Apache-2.0
import type { Parameter } from '../api/types';

const arrows: Record<string, string> = { up: '↑', down: '↓' };

/** A parameter's symbol as the standard sets it: an italic letter, upright arrows, B with a bar for the mean. */
export function ParameterSymbol({ parameter }: { parameter: Parameter }) {
  const [letter, suffix] = parameter.split('_') as [string, string | undefined];
  if (suffix === 'mean') return <span class="symbol">{letter}&#x304;</span>;
  return (
    <span class="parameter">
      <span class="symbol">{letter}</span>
      {suffix ? arrows[suffix] : ''}
    </span>
  );
}
