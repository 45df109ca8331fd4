// SPDX-License-Identifier: Apache-2.0
// Choices that a table of a control leaves open: its curves, the periodic part, its sign, the unit of the table before it.
import { useId } from 'preact/hooks';
import type { CompensatedControl } from '../../api/types';
import { Field } from '../../components/field';
import { shortest } from '../../numbers';
import { counts_in_lengths, type TableForm } from './form';
import { NumberField, type NumberFieldsProps } from './number_fields';
import { t } from './texts';
import { has_use, other_curves, type OtherCurves } from './uses';

interface Props { control: CompensatedControl; form: TableForm; change: (part: Partial<TableForm>) => void }

const own = { 'both-ways': 'own_both', 'with-backlash': 'own_backlash', 'each-way': 'own_each' } as const;

/** Its own curves, or fewer, or one with a number beside it. */
export function CurvesField({ control, form, change }: Props) {
  const others = other_curves(control);
  if (others.length === 0) return null;
  const chosen = form.curves !== null && others.includes(form.curves) ? form.curves : null;
  const named = (curves: OtherCurves) => (curves === 'both-ways' ? t('one_curve') : t('curve_and_number', { number: control.backlash }));
  return (
    <Field label={t('curves')} hint={chosen === 'with-backlash' ? t('hint_beside', { number: control.backlash }) : undefined}>
      {(ids) => (
        <select {...ids} value={chosen ?? ''} onChange={({ currentTarget: { value } }) => change({ curves: value === '' ? null : (value as OtherCurves) })}>
          <option value="">{t(own[control.limits.curves])}</option>
          {others.map((curves) => <option key={curves} value={curves}>{named(curves)}</option>)}
        </select>
      )}
    </Field>
  );
}

/** Whether what repeats with each turn of a screw, or each line of a scale, goes into the table. */
export function PeriodicFields({ expected_period, ...props }: NumberFieldsProps & { expected_period: number | null }) {
  const { form, change } = props;
  const placeholder = expected_period === null ? t('not_told') : shortest(expected_period, 9);
  return (
    <>
      <Field label={t('periodic')} hint={t('hint_periodic')}>
        {(ids) => (
          <select {...ids} value={form.periodic} onChange={({ currentTarget: { value } }) => change({ periodic: value as TableForm['periodic'] })}>
            <option value="keep">{t('periodic_keep')}</option>
            <option value="leave">{t('periodic_leave')}</option>
          </select>
        )}
      </Field>
      <NumberField {...props} of="period" placeholder={placeholder} hint={t(expected_period === null ? 'hint_period' : 'hint_period_of_test')} />
    </>
  );
}

/** The other sign, of a control whose sign was inferred; with what it means. */
export function TurnedSign({ control, form, change }: Props) {
  const id = useId();
  if (!has_use(control, 'turned_sign')) return null;
  return (
    <div class="turned-sign">
      <label><input type="checkbox" checked={form.turned_sign} aria-describedby={id} onChange={(event) => change({ turned_sign: event.currentTarget.checked })} />{t('turned_sign')}</label>
      <p id={id} class={form.turned_sign ? 'notice caution' : 'small quiet'} role="status">{t(form.turned_sign ? 'sign_is_turned' : 'hint_turned')}</p>
    </div>
  );
}

/** The unit of length of the table that was active. */
export function ExistingUnit({ control, kind, form, change }: Props & { kind: 'linear' | 'rotary' }) {
  if (!counts_in_lengths(control, kind)) return null;
  return (
    <Field label={t('existing_unit')} hint={t('hint_existing_unit')}>
      {(ids) => (
        <select {...ids} value={form.existing_unit ?? ''} onChange={({ currentTarget: { value } }) => change({ existing_unit: value === '' ? null : (value as 'mm' | 'inch') })}>
          <option value="">{t('unit_as_new', { unit: t(form.inch ? 'unit_inch' : 'unit_mm') })}</option>
          <option value="mm">{t('unit_mm')}</option>
          <option value="inch">{t('unit_inch')}</option>
        </select>
      )}
    </Field>
  );
}
