// SPDX-License-Identifier: Apache-2.0
// What the program makes of options and of an existing table: asked while someone types, and given up when overtaken.
import { useEffect, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files, query } from '../../api/client';
import { returned } from '../../api/session';
import type { CompensationOptions, KeptCompensation, MadeCompensation, ReadTable, Receipt } from '../../api/types';
import { decimal, language } from '../../settings';

const pause_ms = 250;

export interface Answered<T> {
  data: T | null;        // the last that was made; of former options while `is_current` is false
  is_current: boolean;
  busy: boolean;
  error: ApiError | null;
  again: () => void;
}

/** Sends `form()` when `key` or `file` has changed and rests; null asks nothing. */
function use_form<T>(path: string, key: string | null, file: File | null, form: () => FormData): Answered<T> {
  const [answer, set_answer] = useState<{ data: T; key: string; file: File | null } | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const [turn, set_turn] = useState(0);
  const whole_path = `${path}${path.includes('?') ? '&' : '?'}${query({ decimal: decimal.value }).slice(1)}`;
  const spoken = language.value;
  const back = returned.value;
  useEffect(() => {
    set_error(null);
    if (key === null) return;
    const abort = new AbortController();
    const ask = async () => {
      try {
        const response = await made_of_files(whole_path, form(), abort.signal);
        const data = (await response.json()) as T;
        if (!abort.signal.aborted) set_answer({ data, key, file });
      } catch (thrown) {
        if (!abort.signal.aborted) set_error(as_error(thrown));
      }
    };
    const timer = window.setTimeout(() => void ask(), pause_ms);
    return () => { window.clearTimeout(timer); abort.abort(); };
  }, [whole_path, key, file, spoken, back, turn]);
  const is_current = answer !== null && error === null && answer.key === key && answer.file === file;
  return { data: answer?.data ?? null, is_current, busy: key !== null && !is_current && error === null, error, again: () => set_turn((n) => n + 1) };
}

export function form_of(options: CompensationOptions, existing: File | null, notes = ''): FormData {
  const form = new FormData();
  form.append('options', JSON.stringify(options));
  if (existing) form.append('existing', existing, existing.name);
  if (notes.trim() !== '') form.append('notes', notes.trim());
  return form;
}

/** The table that these options make of a test's version; nothing is kept. */
export function use_made(test: number, version: number, options: CompensationOptions | null, existing: File | null): Answered<MadeCompensation> {
  const key = options === null ? null : JSON.stringify(options);
  return use_form(`/api/tests/${test}/compensation${query({ version })}`, key, existing, () => form_of(options as CompensationOptions, existing));
}

/** A table as its control reads it. */
export function use_read_table(control: string | null, options: object | null, table: File | null): Answered<ReadTable> {
  const key = control === null || options === null || table === null ? null : `${control} ${JSON.stringify(options)}`;
  return use_form(`/api/controls/${encodeURIComponent(control ?? '')}/table`, key, table, () => table_form(options as object, table as File));
}

export function table_form(options: object, table: File): FormData {
  const form = new FormData();
  form.append('options', JSON.stringify(options));
  form.append('table', table, table.name);
  return form;
}

/** Keeps the table with the test. A receipt, where it cannot be shown, is thrown as such. */
export async function keep_table(test: number, version: number, form: FormData): Promise<KeptCompensation> {
  const response = await made_of_files(`/api/tests/${test}/compensations${query({ version, decimal: decimal.value })}`, form);
  const content = (await response.json()) as KeptCompensation | Receipt;
  if ('kept' in content) throw new ApiError('kept', content.message, response.status, '', content);
  return content;
}
