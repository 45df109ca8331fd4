// SPDX-License-Identifier: Apache-2.0
// Values of metadata as text: as `--set` takes them (decimal point, one record per line), and as people type them.
import type { Evaluated, Field } from '../../api/types';
import { marked, parsed } from '../../numbers';

type Rows = Record<string, unknown>[];

/** What stands under "group.member" in a result's metadata. */
function value_at(metadata: Record<string, unknown>, key: string): unknown {
  let value: unknown = metadata;
  for (const part of key.split('.')) {
    if (typeof value !== 'object' || value === null) return undefined;
    value = (value as Record<string, unknown>)[part];
  }
  return value;
}

/** A vertical bar or a line break would end a cell. */
const cell_text = (cell: unknown): string => (cell === null || cell === undefined ? '' : String(cell).replace(/[|\r\n]+/g, ' '));

/** A field's value as a change would state it; "" where there is none. */
export function stated_text(field: Field, metadata: Record<string, unknown>): string {
  const value = value_at(metadata, field.key);
  if (value === undefined || value === null) return '';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (!Array.isArray(value)) return String(value);
  if (field.type !== 'records') return value.map(String).join(' ');
  return (value as Rows).map((row) => field.columns.map((column) => cell_text(row[column.key])).join(' | ')).join('\n');
}

/** The metadata of an evaluation without what the archive lent: as file and changes state them. */
export function as_stated({ result, from_archive }: Evaluated): Record<string, unknown> {
  const lent = new Set((from_archive?.calibrations ?? []).map((one) => one.component));
  if (lent.size === 0) return result.metadata;
  const rows = (result.metadata['equipment'] ?? []) as Rows;
  const equipment = rows.map((row, i) => (lent.has(i + 1) ? { ...row, certificate: '', calibrated_on: '', calibration_due: '' } : row));
  return { ...result.metadata, equipment };
}

function plain_number(typed: string): string {
  return parsed(typed) === null ? typed.trim() : typed.trim().replace('\u2212', '-').replace(',', '.').replace(/^\+/, '');
}

/** What was typed, as a change states it. What is no number stays as it is, so that the server can say so. */
export function plain_text(field: Field, typed: string): string {
  if (field.type === 'number') return plain_number(typed);
  if (field.type === 'numbers') return typed.split(/[\s;]+/).filter((word) => word !== '').map(plain_number).join(' ');
  return typed.trim();
}

/** A change's text as people read it, with their decimal mark. */
export function typed_text(field: Field, text: string): string {
  if (field.type !== 'number' && field.type !== 'numbers') return text;
  return text.split(' ').map((word) => (parsed(word) === null ? word : marked(word))).join(' ');
}

const most_in_a_line = 24;

export const numbers_in = (text: string): number => text.split(/\s+/).filter((word) => word !== '').length;

/** Numbers that nobody reads one by one: they are counted. */
export const is_recording = (field: Field, text: string): boolean => field.type === 'numbers' && numbers_in(text) > most_in_a_line;

/** Whether two texts state the same value: "1.50" is 1.5. */
export function same_value(field: Field, a: string, b: string): boolean {
  if (a === b) return true;
  if (field.type !== 'number') return false;
  const [x, y] = [parsed(a), parsed(b)];
  return x !== null && x === y;
}

export function records_of(field: Field, text: string): string[][] {
  if (text.trim() === '') return [];
  return text.split('\n').map((line) => {
    const cells = line.split('|').map((cell) => cell.trim());
    return field.columns.map((_, i) => cells[i] ?? '');
  });
}

export function records_text(field: Field, rows: string[][]): string {
  const written = rows.map((row) =>
    row.map((cell, i) => {
      const one = cell_text(cell).trim();
      return field.columns[i]?.type === 'number' ? plain_number(one) : one;
    }),
  );
  return written.filter((row) => row.some((cell) => cell !== '')).map((row) => row.join(' | ')).join('\n');
}

export const field_unit = (field: Field, kind: 'linear' | 'rotary'): string =>
  kind === 'linear' ? field.unit_linear : field.unit_rotary;
