// SPDX-License-Identifier: Apache-2.0
// The form of a plan as it is typed, and the request that it makes. What is typed stays a text until it is asked for.
import type { PlanRequest } from '../../api/types';
import { decimal } from '../../settings';
import { parsed, shortest } from '../../numbers';
import { t } from './texts';

export type Kind = 'linear' | 'rotary';
export type How = 'planner' | 'count' | 'own';

export interface PlanForm {
  title: string;
  axis: number | null; // of the store
  name: string; kind: Kind;
  from: string; to: string;
  how: How; count: string; positions: string;
  cycle: PlanRequest['cycle'];
  runs: string; feed: string; dwell: string; overrun: string; seed: string;
  further: Record<string, string>;
}
export type Key = 'name' | 'from' | 'to' | 'count' | 'positions' | 'runs' | 'feed' | 'dwell' | 'overrun' | 'seed';
export type Faults = Partial<Record<Key, string>>;

/** Below 2^32: as good as any, and short enough to be copied from paper. */
export const drawn_seed = (): string => String(crypto.getRandomValues(new Uint32Array(1))[0]);

export function new_form(): PlanForm {
  return {
    title: '', axis: null, name: 'X', kind: 'linear', from: '0', to: '500', how: 'planner', count: '', positions: '',
    cycle: 'standard', runs: '', feed: '', dwell: '', overrun: '', seed: drawn_seed(), further: {},
  };
}

export function form_of(title: string, axis: number | null, request: PlanRequest): PlanForm {
  const text = (value: number | null) => (value === null ? '' : typed(value));
  return {
    title, axis, name: request.axis, kind: request.kind, from: text(request.from), to: text(request.to),
    how: request.positions ? 'own' : request.targets !== null ? 'count' : 'planner',
    count: text(request.targets), positions: (request.positions ?? []).map(typed).join('\n'), cycle: request.cycle,
    runs: text(request.runs), feed: text(request.feed), dwell: text(request.dwell_s), overrun: text(request.overrun),
    seed: request.seed === null ? drawn_seed() : String(request.seed), further: { ...request.further },
  };
}

const typed = (value: number): string => shortest(value, 9).replace('\u2212', '-');

/** The request, or what keeps the form from being one, by field. */
export function request_of(form: PlanForm): { request: PlanRequest; faults: null } | { request: null; faults: Faults } {
  const faults: Faults = {};
  const number = (key: Key, wanted: boolean): number | null => {
    const text = (form[key as keyof PlanForm] as string).trim();
    if (text === '') {
      if (wanted) faults[key] = t('wanted');
      return null;
    }
    const value = parsed(text);
    if (value === null) faults[key] = t('not_number', { text: `"${text}"` });
    return value;
  };
  const count = (key: Key, least: number, wanted = false): number | null => {
    const value = number(key, wanted);
    if (value !== null && (!Number.isSafeInteger(value) || value < least))
      faults[key] = t('not_count', { text: `"${(form[key as keyof PlanForm] as string).trim()}"`, least });
    return value;
  };
  if (form.name.trim() === '') faults.name = t('wanted_text');
  const own = form.how === 'own' ? positions_of(form.positions) : null;
  if (typeof own === 'string') faults.positions = own === '' ? t('wanted') : t('not_number', { text: `"${own}"` });
  const request: PlanRequest = {
    axis: form.name.trim(), kind: form.kind, from: number('from', true) ?? 0, to: number('to', true) ?? 0,
    positions: own as number[] | null, targets: form.how === 'count' ? count('count', 2, true) : null,
    cycle: form.cycle, runs: count('runs', 1), feed: number('feed', false), dwell_s: number('dwell', false),
    overrun: number('overrun', false), seed: count('seed', 0), further: further_of(form),
  };
  return Object.keys(faults).length === 0 ? { request, faults: null } : { request: null, faults };
}

/** The program reads a decimal point; lists of it are separated by commas, which a decimal comma would be taken for. */
function further_of(form: PlanForm): Record<string, string> {
  const entries = Object.entries(form.further)
    .map(([key, text]) => [key, text.trim()] as const)
    .filter(([key, text]) => text !== '' && (key !== 'sequence' || form.cycle === 'user-defined'));
  const in_points = (text: string) => (parsed(text) !== null ? String(parsed(text)) : text);
  return Object.fromEntries(entries.map(([key, text]) => [key, key === 'date' || key === 'machine' ? text : in_points(text)]));
}

/** Numbers in any order; a comma parts them where the decimal mark is a point. The word that is none otherwise. */
export function positions_of(text: string): number[] | string {
  const words = text.split(decimal.value === 'comma' ? /[\s;]+/ : /[\s;,]+/).filter((word) => word !== '');
  if (words.length === 0) return '';
  const values: number[] = [];
  for (const word of words) {
    const value = parsed(word);
    if (value === null) return word;
    values.push(value);
  }
  return values;
}
