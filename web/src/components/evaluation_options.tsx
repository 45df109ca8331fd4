// SPDX-License-Identifier: Apache-2.0
// The options of an evaluation of lengths as fields, where they are sent and where they are kept; members that have no field here stay as they are.
import type { CalibrationKind } from '../api/types';
import { texts } from '../i18n/texts';
import { parsed } from '../numbers';
import { Field } from './field';

const t = texts({
  tolerances: 'Limits',
  tolerances_hint: 'such as A=10um for all lines, xy:E=20um for one',
  reversed: 'lengths fall where the reflector recedes',
  find_breaks: 'look for breaks of the beam that the file does not tell',
  find_outliers: 'set lengths aside that no model explains',
  find_part_scales: 'look for parts that were warmer or colder than others',
  curves: 'Curves',
  spans: 'Spans',
  spans_hint: 'one number, or three for X, Y, Z; empty: as many as the lengths support',
  spans_fault: 'Whole numbers from 1 to 400 are wanted: one, or three.',
  reversal: 'Reversal',
  smoothness: 'Smoothness',
  smoothness_hint: 'by how much slopes change over an axis: auto, or one or two numbers in µm and µrad; empty: curves follow the lengths alone',
  smoothness_fault: '“auto”, or one or two numbers from 0.1 to 1000000, is wanted.',
  rule: 'Rule of decision',
  simple: 'simple acceptance',
  'iso14253-1': 'ISO 14253-1',
  as_stated: 'as the files say, else simple acceptance',
  break_threshold: 'Jump that is a break of the beam / mm',
  break_threshold_hint: 'empty: 20 µm, more where the readings scatter',
  break_threshold_fault: 'A length above 0 mm is wanted.',
  drift: 'Drift of the dead paths',
  'b-spline': 'B-splines',
  legendre: 'Legendre polynomials',
  nodes: 'nodes',
  none: ['none', 'nothing'],
  one_curve: 'one curve for both directions',
  constant: 'a constant difference of the directions',
  auto: 'where the residuals demand it',
  linear: ['linear', 'drift'],
  curves_each: 'a curve for each direction',
});

export type Options = Readonly<Record<string, unknown>>;

const fields = {
  tolerances: 'tolerances', rule: 'rule', reversed: 'reversed', find_breaks: 'find_breaks', find_outliers: 'find_outliers', find_part_scales: 'find_part_scales', break_threshold_mm: 'break_threshold',
  curves: 'curves', spans: 'spans', reversal: 'reversal', smoothness: 'smoothness', drift: 'drift',
} as const;

/** An option that was kept as its field calls it and its choice; nothing where it has no field. */
export function kept_option(key: string, value: unknown): readonly [label: string, value: unknown] | undefined {
  if (!(key in fields)) return undefined;
  const label = t(fields[key as keyof typeof fields]);
  const chosen = key in choices ? choices[key as keyof typeof choices].find((one) => one === value) : undefined;
  if (chosen) return [label, t(word_of(key as keyof typeof choices, chosen))];
  return [label, key === 'rule' && (value === 'simple' || value === 'iso14253-1') ? t(value) : value];
}

/** Typed text beside the options it stands for; null where it stands for none. */
export interface OptionsForm { options: Options; spans: string; smoothness: string; tolerances: string; break_threshold: string }

export function form_of(options: Options): OptionsForm {
  const list = (value: unknown): string => (Array.isArray(value) ? value.join(', ') : value === undefined || value === null ? '' : String(value));
  const typed = (name: string): string => list(options[name]);
  return { options, spans: typed('spans'), smoothness: typed('smoothness'), tolerances: typed('tolerances'), break_threshold: typed('break_threshold_mm') };
}

const words = (text: string): string[] => text.split(/[\s,;]+/).filter((word) => word !== '');

/** One number or three; undefined for nothing, null for what is no such. */
function spans_in(text: string): number | number[] | undefined | null {
  const numbers = words(text).map(Number);
  if (numbers.length === 0) return undefined;
  if (![1, 3].includes(numbers.length) || !numbers.every((n) => Number.isInteger(n) && n >= 1 && n <= 400)) return null;
  return numbers.length === 1 ? numbers[0] as number : numbers;
}

/** "auto", one number or two; undefined for nothing, null for what is no such. */
function smoothness_in(text: string): 'auto' | number | number[] | undefined | null {
  const told = text.trim().toLowerCase();
  if (told === '' || told === 'none') return undefined;
  if (told === 'auto') return 'auto';
  const numbers = told.split(/[\s;]+|,\s+/).filter((word) => word !== '').map(parsed);
  if (![1, 2].includes(numbers.length) || !numbers.every((n) => n !== null && n >= 0.1 && n <= 1e6)) return null;
  return numbers.length === 1 ? numbers[0] as number : numbers as number[];
}

function threshold_in(text: string): number | undefined | null {
  if (text.trim() === '') return undefined;
  const mm = parsed(text);
  return mm !== null && mm > 0 && mm <= 1e6 ? mm : null;
}

/** With a member that may have been left out, or is wrong. */
function with_member(options: Options | null, name: string, value: unknown): Options | null {
  if (options === null || value === null) return null;
  return value === undefined ? options : { ...options, [name]: value };
}

/** What is asked; null where a field is wrong. */
export function options_of(kind: CalibrationKind, { options, spans, smoothness, tolerances, break_threshold }: OptionsForm): Options | null {
  const { spans: _, smoothness: __, tolerances: ___, break_threshold_mm: ____, ...rest } = options;
  if (kind === 'lines') {
    const limited = tolerances.trim() === '' ? rest : { ...rest, tolerances: words(tolerances) };
    return with_member(limited, 'break_threshold_mm', threshold_in(break_threshold));
  }
  return with_member(with_member(rest, 'spans', spans_in(spans)), 'smoothness', smoothness_in(smoothness));
}

const choices = {
  curves: ['b-spline', 'legendre', 'nodes'],
  reversal: ['none', 'constant', 'curves'],
  drift: ['auto', 'none', 'linear'],
} as const;

/** The same word means something else of another choice. */
function word_of(key: keyof typeof choices, one: string) {
  if (key === 'reversal' && one === 'none') return 'one_curve';
  return one === 'curves' ? 'curves_each' : one as Exclude<(typeof choices)[keyof typeof choices][number], 'curves'>;
}

export function OptionsFields({ kind, form, on_change }: { kind: CalibrationKind; form: OptionsForm; on_change: (form: OptionsForm) => void }) {
  const set = (key: string, value: unknown) => on_change({ ...form, options: { ...form.options, [key]: value } });
  const check = (key: 'reversed' | 'find_breaks' | 'find_outliers' | 'find_part_scales', otherwise: boolean) => (
    <label><input type="checkbox" checked={(form.options[key] ?? otherwise) === true} onChange={(event) => set(key, event.currentTarget.checked)} />{t(key)}</label>
  );
  const choice = (key: keyof typeof choices) => (
    <Field label={t(key)}>
      {(ids) => (
        <select {...ids} class="of-words" value={String(form.options[key] ?? choices[key][0])} onChange={(event) => set(key, event.currentTarget.value)}>
          {choices[key].map((one) => <option key={one} value={one}>{t(word_of(key, one))}</option>)}
        </select>
      )}
    </Field>
  );
  if (kind === 'lines') {
    const rule = form.options['rule'];
    const rules = ['simple', 'iso14253-1'] as const;
    const is_other = typeof rule === 'string' && !(rules as readonly string[]).includes(rule);
    return (
      <>
        <Field label={t('tolerances')} hint={t('tolerances_hint')}>
          {(ids) => <input {...ids} data-first class="whole-width" autocomplete="off" spellcheck={false} placeholder="E=20um" value={form.tolerances} onInput={(event) => on_change({ ...form, tolerances: event.currentTarget.value })} />}
        </Field>
        <Field label={t('rule')}>
          {(ids) => (
            <select {...ids} class="of-words" value={String(rule ?? '')} onChange={(event) => set('rule', event.currentTarget.value === '' ? undefined : event.currentTarget.value)}>
              <option value="">{t('as_stated')}</option>
              {rules.map((one) => <option key={one} value={one}>{t(one)}</option>)}
              {is_other && <option value={rule}>{rule}</option>}
            </select>
          )}
        </Field>
        <Field label={t('break_threshold')} hint={t('break_threshold_hint')} fault={threshold_in(form.break_threshold) === null ? t('break_threshold_fault') : null}>
          {(ids) => <input {...ids} class="number short" inputMode="decimal" autocomplete="off" value={form.break_threshold} onInput={(event) => on_change({ ...form, break_threshold: event.currentTarget.value })} />}
        </Field>
        {check('reversed', false)}
        {check('find_breaks', true)}
      </>
    );
  }
  return (
    <>
      {choice('curves')}
      <Field label={t('spans')} hint={t('spans_hint')} fault={spans_in(form.spans) === null ? t('spans_fault') : null}>
        {(ids) => <input {...ids} data-first autocomplete="off" value={form.spans} onInput={(event) => on_change({ ...form, spans: event.currentTarget.value })} />}
      </Field>
      {choice('reversal')}
      <Field label={t('smoothness')} hint={t('smoothness_hint')} fault={smoothness_in(form.smoothness) === null ? t('smoothness_fault') : null}>
        {(ids) => <input {...ids} autocomplete="off" spellcheck={false} value={form.smoothness} onInput={(event) => on_change({ ...form, smoothness: event.currentTarget.value })} />}
      </Field>
      {choice('drift')}
      {check('reversed', false)}
      {check('find_breaks', true)}
      {check('find_outliers', true)}
      {check('find_part_scales', true)}
    </>
  );
}
