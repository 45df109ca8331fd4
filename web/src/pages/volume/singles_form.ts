// SPDX-License-Identifier: Apache-2.0
// Files of errors that were measured one by one, and what their fields ask for.
import type { AssemblyOptions, VolumetricMachine } from '../../api/types';
import { parsed, typed } from '../../numbers';
import { axes, motions, squarenesses, type Axis } from './error_names';
import { t as t_result } from './result_texts';
import { t } from './singles_texts';

export interface SingleRow { key: number; file: File; error: string; a: string; b: string }
export interface Stand { at: readonly string[]; came: readonly ('' | 'up' | 'down')[]; tool: string }
export interface SinglesForm {
  rows: readonly SingleRow[];
  squares: Readonly<Record<string, { value: string; U: string }>>;
  stands: Readonly<Record<Axis, Stand>>;
  reversal: 'curves' | 'none';
}

const no_stand: Stand = { at: ['', '', ''], came: ['', '', ''], tool: '' };
export const new_singles = (): SinglesForm => ({
  rows: [], squares: Object.fromEntries(squarenesses.map(([name]) => [name, { value: '', U: '' }])),
  stands: { X: no_stand, Y: no_stand, Z: no_stand }, reversal: 'curves',
});

export const error_names: readonly string[] = [...motions.map(({ name }) => name), ...squarenesses.map(([name]) => name)];
export const is_motion = (name: string): boolean => name.startsWith('E');
export const unit_of = (name: string): string => motions.find((motion) => motion.name === name)?.unit ?? 'µrad';

const named = /(?<![A-Za-z0-9])(E[XYZABC][XYZ]|C0Y|B0Z|A0Z)(?![A-Za-z0-9])/gi;
const names_in = (text: string): string[] =>
  [...new Set([...text.matchAll(named)].map(([, name]) => (name as string).toUpperCase()))].filter((name) => error_names.includes(name));

/** The errors that a file seems to hold: what it says itself, else its name; of a test of positions the axis. */
export async function errors_of(file: File): Promise<string[]> {
  const text = await file.slice(0, 65_536).text();
  const said = names_in(text);
  if (/"result"\s*:\s*"squareness"/.test(text)) return said.filter((name) => !is_motion(name)).slice(0, 1);
  if (said.length > 0) return /^\s*\{/.test(text) ? said : said.slice(0, 1);
  const axis = /axis\.name["\s:=,;]+([XYZ])\b/.exec(text)?.[1];
  return axis ? [`E${axis}${axis}`] : names_in(file.name.replace(/_/g, ' ')).slice(0, 1);
}

export interface SinglesRead {
  options: AssemblyOptions | null;   // null while there is nothing, or something wrong
  given: ReadonlySet<string>;
  faults: Readonly<Record<string, string>>;
}

const number_text = (x: number): string => typed(x).replace(',', '.');

/** What is asked for, or what keeps the form from it. A place that is left empty is not stated. */
export function read_singles({ rows, squares, stands, reversal }: SinglesForm, { tools_mm, travel_mm }: Pick<VolumetricMachine, 'tools_mm' | 'travel_mm'>): SinglesRead {
  const faults: Record<string, string> = {};
  const given = new Set<string>();
  const errors: string[] = [];
  const instruments: string[] = [];
  const at: string[] = [];
  const number = (key: string, text: string): number => {
    const x = parsed(text);
    if (x === null) faults[key] = t_result('not_number', { text: text.trim() });
    return x ?? 0;
  };
  const take = (key: string, name: string) => {
    if (given.has(name)) faults[key] = t('twice', { name });
    given.add(name);
  };
  for (const { key, file, error, a, b } of rows) {
    if (error === '') { faults[`row.${key}`] = t('choose_error'); continue; }
    take(`row.${key}`, error);
    errors.push(`${error}=${file.name}`);
    if (!is_motion(error) || (a.trim() === '' && b.trim() === '')) continue;
    instruments.push(`${error}=${number_text(a.trim() === '' ? 0 : number(`a.${key}`, a))},${number_text(b.trim() === '' ? 0 : number(`b.${key}`, b))}`);
  }
  for (const [name, { value, U }] of Object.entries(squares)) {
    if (value.trim() === '' && U.trim() === '') continue;
    take(`value.${name}`, name);
    errors.push(`${name}=${number_text(number(`value.${name}`, value))},${number_text(number(`U.${name}`, U))}`);
  }
  for (const axis of axes) {
    const stand = stands[axis];
    const others = axes.map((one, k) => [one, k] as const).filter(([one]) => one !== axis);
    if (others.every(([, k]) => (stand.at[k] ?? '').trim() === '')) continue;
    const places = axes.map((one, k) => {
      // The place of the axis itself does not count; it moved.
      if (one === axis) return number_text((travel_mm as unknown as Record<string, number[]>)[axis]?.[0] ?? 0);
      const came = stand.came[k];
      return `${number_text(number(`stand.${axis}.${k}`, stand.at[k] ?? ''))}${came ? `:${came}` : ''}`;
    });
    const tools = Object.keys(tools_mm);
    at.push(`${axis}=${places.join(',')}@${tools.includes(stand.tool) ? stand.tool : (tools[0] ?? '')}`);
  }
  const sound = errors.length > 0 && Object.keys(faults).length === 0;
  return { options: sound ? { errors, at, instruments, reversal } : null, given, faults };
}
