// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import { axes, type Faults, type TextKey, type TrackingForm } from './form';

export interface FormProps {
  form: TrackingForm;
  change: (part: Partial<TrackingForm>) => void;
  faults: Faults;
}

interface NumberProps { label: string; value: string; set: (text: string) => void; fault?: string | null; placeholder?: string }

export function NumberField({ label, value, set, fault = null, placeholder }: NumberProps) {
  return (
    <Field label={label} fault={fault}>
      {(ids) => <input {...ids} class="number" inputMode="text" autocomplete="off" value={value} placeholder={placeholder} onInput={(event) => set(event.currentTarget.value)} />}
    </Field>
  );
}

/** One of the texts that may be left empty. */
export function TextNumber({ form, change, faults, name, label, placeholder }: FormProps & { name: TextKey; label: string; placeholder?: string }) {
  return (
    <NumberField label={label} value={form.texts[name]} fault={faults[name] ?? null} placeholder={placeholder ?? ''}
      set={(text) => change({ texts: { ...form.texts, [name]: text } })} />
  );
}

const replaced = (list: readonly string[], at: number, text: string): string[] => list.map((one, k) => (k === at ? text : one));

/** X, Y and Z beside each other. */
export function TripleFields({ legend, hint, values, set, faults, name, unit = 'mm' }:
  { legend: string; hint?: string; values: readonly string[]; set: (values: string[]) => void; faults: Faults; name: string; unit?: string }) {
  return (
    <fieldset class="triple">
      <legend>{legend}{unit === '' ? '' : ` (${unit})`}</legend>
      <div>
        {axes.map((axis, k) => (
          <NumberField key={axis} label={axis} value={values[k] ?? ''} fault={faults[`${name}.${k}`] ?? null} set={(text) => set(replaced(values, k, text))} />
        ))}
      </div>
      {hint && <p class="hint">{hint}</p>}
    </fieldset>
  );
}
