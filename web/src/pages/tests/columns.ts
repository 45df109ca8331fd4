// SPDX-License-Identifier: Apache-2.0
// What a person says about the columns of a table, as the import profile that the server reads it by.
import type { ImportProfile } from '../../api/types';

type ImportColumn = ImportProfile['columns'][number];

export type DirectionRule = NonNullable<ImportProfile['direction']>;
/** A role, and of readings the direction that the whole column was approached from: "deviation/up". */
export type Meaning = string;

export const is_reading = (column: ImportColumn): boolean => column.role === 'deviation' || column.role === 'position';
const once = ['target', 'direction', 'run', 'time'];

export const has = (profile: ImportProfile, role: ImportColumn['role']): boolean => profile.columns.some((column) => column.role === role);
export const readings_of = (profile: ImportProfile): ImportColumn[] => profile.columns.filter(is_reading);

export const meaning_of = (column: ImportColumn): Meaning => (column.direction ? `${column.role}/${column.direction}` : column.role);

/** What a column may mean in this table. */
export function meanings(profile: ImportProfile, c: number): Meaning[] {
  const across = profile.layout === 'transposed';
  if (across && c === profile.columns.length - 1) return ['deviation', 'position'];
  if (across) return ['ignore', 'run', 'direction', 'label'];
  return ['ignore', 'target', 'deviation', 'deviation/up', 'deviation/down', 'position', 'position/up', 'position/down', 'direction', 'run', 'time'];
}

const counts_runs = (profile: ImportProfile): boolean => has(profile, 'run') || has(profile, 'label');
const is_numbered = (profile: ImportProfile): boolean => has_readings(profile) && readings_of(profile).every((column) => column.run !== undefined);
const has_readings = (profile: ImportProfile): boolean => profile.columns.some(is_reading);

/** Rules for the direction that this table may follow. */
export function direction_rules(profile: ImportProfile): DirectionRule[] {
  const across = profile.layout === 'transposed';
  const readings = readings_of(profile);
  return [
    ...(has(profile, 'direction') ? ['column' as const] : []),
    ...(has(profile, 'label') || (readings.length > 0 && readings.every((column) => column.direction)) ? ['names' as const] : []),
    ...(across ? [] : ['motion' as const]),
    'visits',
    ...(counts_runs(profile) || is_numbered(profile) ? ['run-parity' as const] : []),
    'up', 'down',
  ];
}

/** What follows from the columns alone is taken from them; a rule that fits them no longer is open again. */
function settled(profile: ImportProfile): ImportProfile {
  const fits = profile.runs === 'column' ? counts_runs(profile) : profile.runs === 'names' ? is_numbered(profile) : true;
  const runs = fits ? profile.runs : counts_runs(profile) ? 'column' : 'repetition';
  const possible = direction_rules(profile);
  const stated = possible.find((rule) => rule === 'column' || rule === 'names');
  const direction = stated ?? (profile.direction !== null && possible.includes(profile.direction) ? profile.direction : null);
  const layout = profile.layout === 'transposed' ? profile.layout : readings_of(profile).length > 1 ? 'wide' : 'long';
  return { ...profile, runs, direction, layout };
}

/** The profile with another meaning of column `c`; `cells` of it are those that are seen. */
export function with_meaning(profile: ImportProfile, c: number, meaning: Meaning, cells: readonly string[]): ImportProfile {
  const [role, direction] = meaning.split('/') as [ImportColumn['role'], ImportColumn['direction']];
  const reading = role === 'deviation' || role === 'position';
  const columns = profile.columns.map((column, other): ImportColumn => {
    const name = column.name === undefined ? {} : { name: column.name };
    if (other !== c) {
      const gives_way = (once.includes(role) && column.role === role) || (reading && is_reading(column) && column.role !== role);
      return gives_way ? { role: 'ignore', ...name } : column;
    }
    if (!reading) return { role, ...name };
    const { direction: _, ...kept } = column;
    return { ...kept, role, ...(direction ? { direction } : {}) };
  });
  if (role !== 'run') return settled({ ...profile, columns });
  return settled({ ...profile, columns, runs: 'column', first_run: cells.some((cell) => /^0+([.,]0*)?$/.test(cell)) ? 0 : 1 });
}

/** The profile with another rule for the direction, and runs counted so that they fit it. */
export function with_rule(profile: ImportProfile, direction: ImportProfile['direction']): ImportProfile {
  if (direction === 'run-parity') return { ...profile, direction, runs: counts_runs(profile) ? 'column' : 'names' };
  if (direction === 'visits' && profile.runs === 'names') return { ...profile, direction, runs: 'repetition' };
  return { ...profile, direction };
}

export type Open = 'target' | 'readings' | 'target_unit' | 'reading_unit' | 'direction';

/** What has still to be said before the table can be read. */
export function open_in(profile: ImportProfile): Open[] {
  const readings = readings_of(profile);
  const all: [Open, boolean][] = [
    ['target', profile.layout !== 'transposed' && !has(profile, 'target')],
    ['readings', readings.length === 0],
    ['target_unit', profile.target_unit === null],
    ['reading_unit', profile.reading_unit === null && !(readings.length > 0 && readings.every((column) => column.unit))],
    ['direction', profile.direction === null],
  ];
  return all.filter(([, open]) => open).map(([key]) => key);
}

/** What was said of one table, for another with the same columns. Where its rows begin and end, each knows itself. */
export function as_said_of(other: ImportProfile, own: ImportProfile): ImportProfile {
  const { layout, columns, target_unit, reading_unit, direction, first_direction, up_words, down_words, runs, first_run, sign } = other;
  return { ...own, layout, columns, target_unit, reading_unit, direction, first_direction, up_words, down_words, runs, first_run, sign };
}

/** Whether two tables have the same columns, so that what was said of one holds for the other. */
export const same_columns = (a: ImportProfile, b: ImportProfile): boolean =>
  a.delimiter === b.delimiter && (a.layout === 'transposed') === (b.layout === 'transposed') && a.columns.length === b.columns.length && a.columns.every((column, c) => column.name === b.columns[c]?.name);
