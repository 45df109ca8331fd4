// SPDX-License-Identifier: Apache-2.0
// What one person changed, laid over what another kept meanwhile.

type Members = Record<string, unknown>;

const same = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);
const is_members = (value: unknown): value is Members => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Limits: a list in which each parameter stands once. */
interface OfParameter { parameter: string }
const are_of_parameters = (value: unknown): value is OfParameter[] =>
  Array.isArray(value) && value.every((one) => is_members(one) && typeof one['parameter'] === 'string');
const by_parameter = (list: OfParameter[]): Members => Object.fromEntries(list.map((one) => [one.parameter, one]));

function merged_value(before: unknown, mine: unknown, theirs: unknown): unknown {
  if (same(before, mine)) return theirs;
  if (are_of_parameters(before) && are_of_parameters(mine) && are_of_parameters(theirs))
    return Object.values(merged_edit(by_parameter(before), by_parameter(mine), by_parameter(theirs)));
  if (is_members(before) && is_members(mine) && is_members(theirs) && !('parameter' in mine)) return merged_edit(before, mine, theirs);
  return mine;
}

/** Members that were not touched are those of the other, also single limits and inputs; where both changed one, mine counts. */
export function merged_edit(before: Members, mine: Members, theirs: Members): Members {
  const names = [...new Set([...Object.keys(mine), ...Object.keys(before), ...Object.keys(theirs)])];
  const all: Members = {};
  for (const name of names) {
    const value = merged_value(before[name], mine[name], theirs[name]);
    if (value !== undefined) all[name] = value;
  }
  return all;
}

/** Of a whole that is kept: what of `mine` is to be sent, its members alone. */
export function merged_body(before: object, mine: object, theirs: object): Members {
  const all = merged_edit(before as Members, mine as Members, theirs as Members);
  return Object.fromEntries(Object.keys(mine).map((name) => [name, all[name]]));
}
