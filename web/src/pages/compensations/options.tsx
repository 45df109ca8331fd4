// SPDX-License-Identifier: Apache-2.0
import type { CompensatedControl } from '../../api/types';
import { Field } from '../../components/field';
import { CurvesField, PeriodicFields } from './choices';
import { counts_in_lengths, offered_numbers, type TableForm } from './form';
import { NumberFields, type NumberFieldsProps } from './number_fields';
import { t } from './texts';
import { has_grid } from './uses';

export interface OptionsProps extends NumberFieldsProps {
  control: CompensatedControl; axis: string;   // as the test names it
  expected_period: number | null;              // likewise
}

/** What a control has a use for beside the test, folded until someone wants other than the usual. */
export function OptionsFields(props: OptionsProps) {
  const { control, kind, axis, form, change } = props;
  const box = (key: 'smooth' | 'hold_ends' | 'inch') => (
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
      <CurvesField {...props} />
      <PeriodicFields {...props} />
      <div class="boxes">
        {box('smooth')}
        {has_grid(control) && box('hold_ends')}
        {counts_in_lengths(control, kind) && box('inch')}
      </div>
    </div>
  );
}
