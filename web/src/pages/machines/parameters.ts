// SPDX-License-Identifier: Apache-2.0
import type { FigureOfTest, Parameter, Trend, Verdict } from '../../api/types';
import type { Shape } from '../../components/chart/chart';

/** In the order in which the library lists them. */
export const parameters: readonly Parameter[] = ['A', 'A_up', 'A_down', 'E', 'E_up', 'E_down', 'M', 'R', 'R_up', 'R_down', 'B', 'B_mean'];

const colours: Record<string, string> = { A: '--series-1', E: '--series-2', R: '--series-3', B: '--series-4', M: '--series-5' };
const shapes: Record<string, Shape> = { A: 'circle', E: 'square', R: 'diamond', B: 'up', M: 'ring' };

/** A family of parameters shares its colour; single directions are dashed, with arrows for points. */
export function look(parameter: Parameter): { colour: string; shape: Shape; dash?: number[] } {
  const [letter = 'A', suffix] = parameter.split('_');
  const colour = colours[letter] ?? '--series-8';
  if (suffix === 'up') return { colour, shape: 'up', dash: [5, 3] };
  if (suffix === 'down') return { colour, shape: 'down', dash: [2, 3] };
  return suffix === 'mean' ? { colour, shape: 'ring', dash: [7, 3] } : { colour, shape: shapes[letter] ?? 'circle' };
}

/** As plain characters, where no markup can stand: "R↑", "B̄". */
export function plain_symbol(parameter: Parameter): string {
  return parameter.replace('_up', '↑').replace('_down', '↓').replace('_mean', '\u0304');
}

/** Of a test: as it was given, since a limit of a parameter that the test lacks is in no figure. */
export const verdict_of = (point: Trend['points'][number] | undefined): Verdict | null => point?.verdict ?? null;

/** Whether a figure stands over its limit: as it was judged; one that nobody judged, against the limit that is drawn. */
export const is_over = ({ value, verdict }: FigureOfTest, drawn: number | null): boolean =>
  verdict === null ? drawn !== null && value > drawn : verdict === 'does not conform';
