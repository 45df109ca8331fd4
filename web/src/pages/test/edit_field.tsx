// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Calibration, Field as FieldInfo, Vocabulary } from '../../api/types';
import { Field } from '../../components/field';
import { texts } from '../../i18n/texts';
import { parsed, shortest } from '../../numbers';
import { decimal } from '../../settings';
import { EditRecords } from './edit_records';
import { field_unit, is_recording, plain_text, same_value, stated_text, typed_text } from './field_value';
import { value_words } from './field_words';
import type { TestState } from './state';
import { colon, semicolon } from '../../i18n/colon';

const t = texts({
  not_given: 'not given',
  file_says: 'In the file: {value}',
  instrument_says: 'From {name}: {value}',
  archive_says: 'Calibration from the archive: {value}',
  axis_says: 'Limit of the axis: {value}',
  over_axis: 'Takes the place of the limit of the axis: {value}',
  clear: 'Clear',
  clear_field: 'Clear {title}',
  file_silent: 'Not in the file',
  no_number: '“{text}” is not a number',
  too_small: 'Expected: at least {minimum}',
  too_large: 'Expected: at most {maximum}',
  'uncertainty.distributions': 'An input by its name, such as machine_temperature, and the distribution that replaces its own: “triangular 1.5 2.5” is a triangle from 1.5 to 2.5. An input “scale:optics” with “normal 0 0.2” is added, and acts on the whole scale.',
  undo: 'Undo',
  undo_field: 'Undo the change of {title}',
});

/** One field of the metadata: what is typed becomes a change at once; what the file says stands below. */
export function EditField({ state, field, vocabulary }: { state: TestState; field: FieldInfo; vocabulary: Vocabulary }) {
  const frame = useRef<HTMLDivElement>(null);
  const stated = stated_text(field, state.stated.value);
  const changed = state.changes.value[field.key] !== undefined;
  const wanted = state.wanted_field.value === field.key;
  useEffect(() => {
    if (!wanted) return;
    state.wanted_field.value = null;
    const control = frame.current?.querySelector<HTMLElement>('input, select, textarea, button');
    frame.current?.scrollIntoView({ block: 'center' });
    control?.focus({ preventScroll: true });
  }, [wanted]);
  const origin = origin_of(state, field, stated, changed, vocabulary);
  const unit = field_unit(field, state.evaluated.value.result.axis.kind);
  return (
    <div ref={frame} class={`edit-field ${changed ? 'changed' : ''}`}>
      <Field label={<>{field.title}{unit !== '' && <span class="unit">, {unit}</span>}</>} fault={fault_words(state, field)}
             hint={<>{origin !== null && <span class="file-says">{origin}</span>} {field.key === 'uncertainty.distributions' ? t(field.key) : field.description}{field.clause !== '' && <span class="clause"> {field.clause}</span>}</>}>
        {(ids) => <Control ids={ids} state={state} field={field} vocabulary={vocabulary} stated={stated} />}
      </Field>
      {changed && (
        <button type="button" class="plain small undo" aria-label={t('undo_field', { title: field.title })} onClick={() => state.put(field, stated)}>{t('undo')}</button>
      )}
    </div>
  );
}

/** What is wrong with a value, for people where the page can tell, else as the server says it. */
function fault_words(state: TestState, field: FieldInfo): string | null {
  const said = state.faults.value[field.key] ?? null;
  if (said === null || field.type !== 'number') return said;
  const text = state.text_of(field);
  const value = parsed(text);
  if (value === null) return t('no_number', { text });
  if (field.minimum !== null && value < field.minimum) return t('too_small', { minimum: shortest(field.minimum) });
  if (field.maximum !== null && value > field.maximum) return t('too_large', { maximum: shortest(field.maximum) });
  return said;
}

/** Where an unchanged value comes from: the file, or what the archive knows of instruments and axis. */
function origin_of(state: TestState, field: FieldInfo, stated: string, changed: boolean, vocabulary: Vocabulary): string | null {
  const taken = state.evaluated.value.from_archive;
  const instrument = taken?.instruments.find((one) => one.inputs[field.key] !== undefined);
  if (instrument && !changed) return t('instrument_says', { name: instrument.name, value: value_words(field, instrument.inputs[field.key] as string, vocabulary) });
  const calibrations = field.key === 'equipment' ? (taken?.calibrations ?? []) : [];
  if (calibrations.length > 0) return t('archive_says', { value: calibrations.map(calibration_text).join(semicolon()) });
  const limit = taken?.axis?.limits.find((one) => field.key === `tolerance.${one.parameter}`);
  if (limit && stated === '' && !changed) return t('axis_says', { value: value_words(field, String(limit.value), vocabulary) });
  if (!changed) return null;
  if (limit && stated === '' && state.text_of(field) !== '') return t('over_axis', { value: value_words(field, String(limit.value), vocabulary) });
  return stated === '' ? t('file_silent') : t('file_says', { value: value_words(field, stated, vocabulary) });
}

/** "1: VI-2026-0113, 2026-01-13 – 2027-01-13", of the first component. */
function calibration_text({ component, certificate, calibrated_on, calibration_due }: Calibration): string {
  const days = [calibrated_on, calibration_due].some((day) => day !== '') ? `${calibrated_on || '…'} – ${calibration_due || '…'}` : '';
  return `${component}${colon()} ${[certificate, days].filter((part) => part !== '').join(', ')}`;
}

type Ids = { id: string; 'aria-describedby': string | undefined; 'aria-invalid': 'true' | undefined };

function Control({ ids, state, field, vocabulary, stated }: {
  ids: Ids; state: TestState; field: FieldInfo; vocabulary: Vocabulary; stated: string;
}) {
  const text = state.text_of(field);
  if (field.type === 'records') return <EditRecords ids={ids} field={field} text={text} change={(next) => state.put(field, next)} />;
  if (field.type === 'choice' || field.type === 'boolean') {
    const choices = field.type === 'boolean' ? ['yes', 'no'] : field.choices;
    return (
      <select {...ids} value={text} onChange={(event) => state.put(field, event.currentTarget.value)}>
        <option value="">{t('not_given')}</option>
        {choices.map((choice) => <option key={choice} value={choice}>{value_words(field, choice, vocabulary)}</option>)}
      </select>
    );
  }
  if (is_recording(field, text)) {
    return (
      <div class="row recording">
        <span class="number">{value_words(field, text, vocabulary)}</span>
        <button {...ids} type="button" class="small" aria-label={t('clear_field', { title: field.title })} onClick={() => state.put(field, '')}>{t('clear')}</button>
      </div>
    );
  }
  return <Typed ids={ids} field={field} text={text} placeholder={is_recording(field, stated) ? '' : typed_text(field, stated)} change={(next) => state.put(field, next)} />;
}

/** An input that keeps what was typed as it was typed, until the value changes from elsewhere. */
function Typed({ ids, field, text, placeholder, change }: {
  ids: Ids; field: FieldInfo; text: string; placeholder: string; change: (text: string) => void;
}) {
  const mark = decimal.value;
  const [typed, set_typed] = useState(typed_text(field, text));
  useEffect(() => {
    if (!same_value(field, plain_text(field, typed), text)) set_typed(typed_text(field, text));
  }, [text]);
  useEffect(() => set_typed(typed_text(field, text)), [mark]);
  const numeric = field.type === 'number' || field.type === 'numbers';
  return (
    <input {...ids} type="text" value={typed} placeholder={placeholder} inputMode={field.type === 'number' && (field.minimum ?? -1) >= 0 ? 'decimal' : 'text'}
           class={numeric ? 'number' : ''} autoComplete="off" spellcheck={!numeric}
           onInput={(event) => {
             set_typed(event.currentTarget.value);
             change(plain_text(field, event.currentTarget.value));
           }} />
  );
}
