// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Options, Vocabulary } from '../../api/types';
import { Field } from '../../components/field';
import { texts } from '../../i18n/texts';
import { marked, parsed } from '../../numbers';
import { EditField } from './edit_field';
import { record_method } from './record_choice';
import { method_field, type TestState } from './state';

const t = texts({
  title: 'Evaluation',
  gum: 'Uncertainty by the GUM',
  monte_carlo: 'Uncertainty by Monte Carlo',
  at_once: 'It is of record, and follows every change.',
  trials: 'Trials',
  trials_hint: 'Empty: until two digits are stable.',
  seed: 'Seed',
  coverage: 'Coverage, %',
  run: 'Run Monte Carlo',
  running: 'Drawing trials …',
  corrections: 'Corrections of readings',
  on: '{n} of {all}',
  corrections_hint: 'The readings stay in the archive as they were measured.',
  whole: 'Expected: a whole number from {low} to {high}',
  percent: 'Expected: more than 50 and less than 100',
});

/** Methods, sampling and corrections: how the test is evaluated, beside its metadata. */
export function EditOptions({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary }) {
  const options = state.options.value;
  const sampled = options.methods.includes('monte-carlo');
  const toggle = (method: Options['methods'][number]) => state.choose({
    methods: options.methods.includes(method) ? options.methods.filter((one) => one !== method) : [...options.methods, method],
  });
  const running = state.busy.value === 'sampling';
  const of_record = state.sampled_record.value;
  const by_gum = record_method(state.evaluated.value) === 'gum' && !options.methods.includes('gum');
  const method = vocabulary.fields.find((field) => field.key === method_field);
  return (
    <details class="edit-group" open>
      <summary>{t('title')}</summary>
      <div class="edit-options">
        {method && <EditField state={state} field={method} vocabulary={vocabulary} />}
        <label><input type="checkbox" checked={options.methods.includes('gum') || by_gum} disabled={by_gum} onChange={() => toggle('gum')} /> {t('gum')}</label>
        <label><input type="checkbox" checked={sampled || of_record} disabled={of_record && !sampled} onChange={() => toggle('monte-carlo')} /> {t('monte_carlo')}</label>
        {(sampled || of_record) && (
          <div class="sampling-fields">
            <NumberField label={t('trials')} hint={t('trials_hint')} value={options.trials} empty low={100} high={10_000_000} put={(trials) => state.choose({ trials })} />
            <NumberField label={t('seed')} value={options.seed} low={0} high={Number.MAX_SAFE_INTEGER} put={(seed) => state.choose({ seed: seed ?? 1 })} />
            <CoverageField value={options.coverage} put={(coverage) => state.choose({ coverage })} />
            {of_record ? <span class="small quiet">{running ? t('running') : t('at_once')}</span>
              : <button type="button" disabled={running || !state.edited.value} onClick={() => state.run_monte_carlo()}>{running ? t('running') : t('run')}</button>}
          </div>
        )}
        {vocabulary.corrections.length > 0 && <Corrections state={state} vocabulary={vocabulary} />}
      </div>
    </details>
  );
}

/** Folded, with how many are on: few tests want one. */
function Corrections({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary }) {
  const chosen = state.options.value.corrections;
  const all = vocabulary.corrections.map(({ id }) => id);
  const toggle = (id: string) => state.choose({ corrections: all.filter((one) => (one === id ? !chosen.includes(one) : chosen.includes(one))) });
  return (
    <details>
      <summary>{t('corrections')} <span class="small quiet">{t('on', { n: chosen.length, all: all.length })}</span></summary>
      <div class="edit-options">
        {vocabulary.corrections.map((one) => (
          <label key={one.id}><input type="checkbox" checked={chosen.includes(one.id)} onChange={() => toggle(one.id)} /> {one.title}</label>
        ))}
        <p class="small quiet">{t('corrections_hint')}</p>
      </div>
    </details>
  );
}

/** A whole number; what is none stays in the field with its fault and changes nothing. */
function NumberField({ label, hint, value, empty = false, low, high, put }: {
  label: string; hint?: string; value: number | string | null; empty?: boolean; low: number; high: number; put: (value: number | null) => void;
}) {
  const [typed, set_typed] = useState<string | null>(null);
  const fits = (text: string) => (text.trim() === '' ? empty : /^\d+$/.test(text.trim()) && Number(text) >= low && Number(text) <= high);
  const bad = typed !== null && !fits(typed);
  return (
    <Field label={label} hint={hint} fault={bad ? t('whole', { low, high }) : null}>
      {(ids) => (
        <input {...ids} type="text" inputMode="numeric" class="number" size={9} value={typed ?? (value === null ? '' : String(value))}
               onBlur={() => { if (!bad) set_typed(null); }}
               onInput={(event) => {
                 const text = event.currentTarget.value;
                 set_typed(text);
                 if (fits(text)) put(text.trim() === '' ? null : Number(text));
               }} />
      )}
    </Field>
  );
}

function CoverageField({ value, put }: { value: number; put: (coverage: number) => void }) {
  const [typed, set_typed] = useState<string | null>(null);
  const percent = typed === null ? null : parsed(typed);
  const bad = typed !== null && (percent === null || percent <= 50 || percent >= 100);
  return (
    <Field label={t('coverage')} fault={bad ? t('percent') : null}>
      {(ids) => (
        <input {...ids} type="text" inputMode="decimal" class="number" size={6} value={typed ?? marked(String(Number((100 * value).toFixed(6))))}
               onBlur={() => { if (!bad) set_typed(null); }}
               onInput={(event) => {
                 const text = event.currentTarget.value;
                 const next = parsed(text);
                 set_typed(text);
                 if (next !== null && next > 50 && next < 100) put(Number((next / 100).toFixed(8)));
               }} />
      )}
    </Field>
  );
}
