// SPDX-License-Identifier: Apache-2.0
import type { CompensatedControl } from '../../api/types';
import { Field } from '../../components/field';
import { position_unit, unit_sign } from '../../numbers';
import { offered_numbers, type Faults, type NumberKey, type TableForm } from './form';
import { t } from './texts';
import { has_grid, has_use } from './uses';

export interface OptionsProps {
  control: CompensatedControl; kind: 'linear' | 'rotary'; axis: string;   // as the test names it
  form: TableForm; change: (part: Partial<TableForm>) => void; faults: Faults; with_existing: boolean;
}

function label_of(key: NumberKey, kind: 'linear' | 'rotary'): string {
  const unit = key === 'steps_per_unit' ? t('per', { unit: position_unit(kind) })
    : key === 'resolution' ? unit_sign(kind === 'linear' ? 'um' : 'arcsec')
    : ['start', 'end', 'step', 'reference'].includes(key) ? position_unit(kind) : '';
  return unit === '' ? t(key) : `${t(key)} / ${unit}`;
}

const usual: Partial<Record<NumberKey, 'auto' | 'within' | 'zero' | 'one' | 'not_told'>> = {
  start: 'within', end: 'within', step: 'auto', points: 'auto', reference: 'zero', number: 'zero', resolution: 'one', magnification: 'one', largest: 'auto', steps_per_unit: 'not_told',
};

const of_grid: readonly NumberKey[] = ['start', 'end', 'step', 'points'];

/** Fields of numbers, empty ones telling what stands for them. */
export function NumberFields({ keys, kind, form, change, faults, with_existing = false }: Pick<OptionsProps, 'kind' | 'form' | 'change' | 'faults'> & { keys: readonly NumberKey[]; with_existing?: boolean }) {
  return (
    <>
      {keys.map((key) => {
        const word = usual[key];
        const placeholder = of_grid.includes(key) && with_existing ? t('as_existing') : word ? t(word) : '';
        return (
          <Field key={key} label={label_of(key, kind)} fault={faults[key] ?? null} hint={key in hints ? t(hints[key] as 'hint_reference') : undefined}>
            {(ids) => (
              <input {...ids} class="number" inputMode="text" autocomplete="off" placeholder={placeholder} value={form.texts[key]}
                onInput={(event) => change({ texts: { ...form.texts, [key]: event.currentTarget.value } })} />
            )}
          </Field>
        );
      })}
    </>
  );
}

const hints: Partial<Record<NumberKey, 'hint_reference' | 'hint_number' | 'hint_resolution' | 'hint_steps'>> = {
  reference: 'hint_reference', number: 'hint_number', resolution: 'hint_resolution', steps_per_unit: 'hint_steps',
};

/** What a control has a use for beside the test, folded until someone wants other than the usual. */
export function OptionsFields(props: OptionsProps) {
  const { control, kind, axis, form, change } = props;
  const box = (key: 'smooth' | 'hold_ends' | 'one_curve' | 'inch') => (
    <label><input type="checkbox" checked={form[key]} onChange={(event) => change({ [key]: event.currentTarget.checked })} />{t(key)}</label>
  );
  return (
    <div class="table-options">
      <Field label={t('axis_name')} hint={t('hint_axis')}>
        {(ids) => <input {...ids} autocomplete="off" placeholder={axis} value={form.axis} onInput={(event) => change({ axis: event.currentTarget.value })} />}
      </Field>
      <NumberFields {...props} keys={offered_numbers(control)} />
      <Field label={t('method')}>
        {(ids) => (
          <select {...ids} value={form.method} onChange={(event) => change({ method: event.currentTarget.value as TableForm['method'] })}>
            <option value="least-squares">{t('least_squares')}</option>
            <option value="interpolation">{t('interpolation')}</option>
          </select>
        )}
      </Field>
      <div class="boxes">
        {box('smooth')}
        {has_grid(control) && box('hold_ends')}
        {control.limits.curves !== 'both-ways' && box('one_curve')}
        {kind === 'linear' && has_use(control, 'inch') && box('inch')}
      </div>
    </div>
  );
}
