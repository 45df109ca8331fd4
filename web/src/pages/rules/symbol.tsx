// SPDX-License-Identifier: Apache-2.0

/** "P_s,max", "A↑", "B̄": an italic letter, upright arrows, and after the underscore what stands below. */
export function RuleSymbol({ symbol }: { symbol: string }) {
  const [, letter = symbol, arrow = '', below = ''] = /^(.\u0304?)([↑↓]?)(?:_(.+))?$/u.exec(symbol) ?? [];
  return <span class="parameter"><span class="symbol">{letter}</span>{arrow}{below !== '' && <sub>{below}</sub>}</span>;
}
