// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import type { Faults, NumberKey, TableForm } from './form';
import { number_label } from './option_words';
import { t } from './texts';

export interface NumberFieldsProps {
  kind: 'linear' | 'rotary'; form: TableForm; change: (part: Partial<TableForm>) => void; faults: Faults;
  with_existing?: boolean;
}

const usual: Partial<Record<NumberKey, 'auto' | 'within' | 'zero' | 'one' | 'not_told'>> = {
  start: 'within', end: 'within', step: 'auto', points: 'auto', reference: 'zero', number: 'zero', resolution: 'one', magnification: 'one', largest: 'auto', steps_per_unit: 'not_told',
};

const hints: Partial<Record<NumberKey, 'hint_reference' | 'hint_number' | 'hint_resolution' | 'hint_steps'>> = {
  reference: 'hint_reference', number: 'hint_number', resolution: 'hint_resolution', steps_per_unit: 'hint_steps',
};

const of_grid: readonly NumberKey[] = ['start', 'end', 'step', 'points'];

/** Fields of numbers, empty ones telling what stands for them. */
export function NumberFields({ keys, kind, form, change, faults, with_existing = false }: NumberFieldsProps & { keys: readonly NumberKey[] }) {
  return (
    <>
      {keys.map((key) => {
        const word = usual[key];
        const hint = hints[key];
        const placeholder = of_grid.includes(key) && with_existing ? t('as_existing') : word ? t(word) : '';
        return <NumberField key={key} of={key} placeholder={placeholder} hint={hint && t(hint)} {...{ kind, form, change, faults }} />;
      })}
    </>
  );
}

/** One of them; `placeholder`: what stands for it while it is empty. */
export function NumberField({ of, placeholder, hint, kind, form, change, faults }: NumberFieldsProps & { of: NumberKey; placeholder: string; hint?: string | undefined }) {
  return (
    <Field label={number_label(of, kind)} fault={faults[of] ?? null} hint={hint}>
      {(ids) => (
        <input {...ids} class="number" inputMode="text" autocomplete="off" placeholder={placeholder} value={form.texts[of]}
          onInput={(event) => change({ texts: { ...form.texts, [of]: event.currentTarget.value } })} />
      )}
    </Field>
  );
}
