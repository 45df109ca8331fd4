// SPDX-License-Identifier: Apache-2.0
// The options of an evaluation as fields; members that have no field here stay as they are.
import type { CalibrationKind } from '../../api/types';
import { Field } from '../../components/field';
import { texts } from '../../i18n/texts';

const t = texts({
  tolerances: ['Limits', 'Grenzwerte'],
  tolerances_hint: ['such as A=10um for all lines, xy:E=20um for one', 'etwa A=10um für alle Linien, xy:E=20um für eine'],
  reversed: ['lengths fall where the reflector recedes', 'Längen fallen, wo sich der Reflektor entfernt'],
  find_breaks: ['look for breaks of the beam that the file does not tell', 'Strahlunterbrechungen suchen, die die Datei nicht nennt'],
  find_outliers: ['set lengths aside that no model explains', 'Längen beiseitelegen, die kein Modell erklärt'],
  curves: ['Curves', 'Kurven'],
  spans: ['Spans', 'Abschnitte'],
  spans_hint: ['one number, or three for X, Y, Z; empty: as many as the lengths support', 'eine Zahl, oder drei für X, Y, Z; leer: so viele, wie die Längen tragen'],
  spans_fault: ['Whole numbers from 1 to 100 are wanted: one, or three.', 'Gesucht sind ganze Zahlen von 1 bis 100: eine oder drei.'],
  reversal: ['Reversal', 'Umkehr'],
  drift: ['Drift of the dead paths', 'Drift der Totstrecken'],
  'b-spline': ['B-splines', 'B-Splines'],
  legendre: ['Legendre polynomials', 'Legendre-Polynome'],
  nodes: ['nodes', 'Stützstellen'],
  none: ['none', 'keine'],
  constant: ['constant', 'konstant'],
  auto: ['where the residuals demand it', 'wo die Residuen sie verlangen'],
  linear: ['linear', 'linear'],
  curves_each: ['a curve for each direction', 'eine Kurve je Richtung'],
});

export type Options = Readonly<Record<string, unknown>>;

/** Typed text beside the options it stands for; null where it stands for none. */
export interface OptionsForm { options: Options; spans: string; tolerances: string }

export function form_of(options: Options): OptionsForm {
  const list = (value: unknown): string => (Array.isArray(value) ? value.join(', ') : value === undefined || value === null ? '' : String(value));
  return { options, spans: list(options['spans']), tolerances: list(options['tolerances']) };
}

const words = (text: string): string[] => text.split(/[\s,;]+/).filter((word) => word !== '');

/** One number or three; undefined for nothing, null for what is no such. */
function spans_in(text: string): number | number[] | undefined | null {
  const numbers = words(text).map(Number);
  if (numbers.length === 0) return undefined;
  if (![1, 3].includes(numbers.length) || !numbers.every((n) => Number.isInteger(n) && n >= 1 && n <= 100)) return null;
  return numbers.length === 1 ? numbers[0] as number : numbers;
}

/** What is asked; null where a field is wrong. */
export function options_of(kind: CalibrationKind, { options, spans, tolerances }: OptionsForm): Options | null {
  const { spans: _, tolerances: __, ...rest } = options;
  if (kind === 'lines') return tolerances.trim() === '' ? rest : { ...rest, tolerances: words(tolerances) };
  const told = spans_in(spans);
  return told === null ? null : told === undefined ? rest : { ...rest, spans: told };
}

const choices = {
  curves: ['b-spline', 'legendre', 'nodes'],
  reversal: ['none', 'constant', 'curves'],
  drift: ['auto', 'none', 'linear'],
} as const;

export function OptionsFields({ kind, form, on_change }: { kind: CalibrationKind; form: OptionsForm; on_change: (form: OptionsForm) => void }) {
  const set = (key: string, value: unknown) => on_change({ ...form, options: { ...form.options, [key]: value } });
  const check = (key: 'reversed' | 'find_breaks' | 'find_outliers', otherwise: boolean) => (
    <label><input type="checkbox" checked={(form.options[key] ?? otherwise) === true} onChange={(event) => set(key, event.currentTarget.checked)} />{t(key)}</label>
  );
  const choice = (key: keyof typeof choices) => (
    <Field label={t(key)}>
      {(ids) => (
        <select {...ids} value={String(form.options[key] ?? choices[key][0])} onChange={(event) => set(key, event.currentTarget.value)}>
          {choices[key].map((one) => <option key={one} value={one}>{t(one === 'curves' ? 'curves_each' : one)}</option>)}
        </select>
      )}
    </Field>
  );
  if (kind === 'lines') {
    return (
      <>
        <Field label={t('tolerances')} hint={t('tolerances_hint')}>
          {(ids) => <input {...ids} data-first class="whole-width" spellcheck={false} value={form.tolerances} onInput={(event) => on_change({ ...form, tolerances: event.currentTarget.value })} />}
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
        {(ids) => <input {...ids} data-first value={form.spans} onInput={(event) => on_change({ ...form, spans: event.currentTarget.value })} />}
      </Field>
      {choice('reversal')}
      {choice('drift')}
      {check('find_breaks', true)}
      {check('find_outliers', true)}
    </>
  );
}
