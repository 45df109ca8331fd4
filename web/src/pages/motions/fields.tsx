// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import { is_no_number, is_no_offset, type MotionForm, type MotionKind } from './form';
import { t } from './texts';

/** How readings are evaluated, as far as their kind has a use for it. */
export function MotionFields({ kind, form, on_change }: { kind: MotionKind; form: MotionForm; on_change: (form: MotionForm) => void }) {
  const set = (part: Partial<MotionForm>) => on_change({ ...form, ...part });
  const number = (key: 'instrument_a' | 'instrument_b' | 'square_error' | 'square_uncertainty') => (
    <Field label={t(key)} fault={is_no_number(form[key]) ? t('number_fault') : null}>
      {(ids) => <input {...ids} inputMode="decimal" value={form[key]} onInput={(event) => set({ [key]: event.currentTarget.value })} />}
    </Field>
  );
  const text = (key: 'error' | 'positive') => (
    <Field label={t(key)} hint={t(`${key}_hint`)}>
      {(ids) => <input {...ids} spellcheck={false} value={form[key]} onInput={(event) => set({ [key]: event.currentTarget.value })} />}
    </Field>
  );
  const usual = kind === 'angles' ? 'none' : 'least-squares';
  const lines = kind === 'angles' ? ['none', 'least-squares', 'end-points'] as const : ['least-squares', 'end-points'] as const;
  return (
    <div class="form-grid">
      <Field label={t('reference')}>
        {(ids) => (
          <select {...ids} data-first value={form.reference === '' ? usual : form.reference} onChange={(event) => set({ reference: event.currentTarget.value })}>
            {lines.map((one) => <option key={one} value={one}>{t(one)}</option>)}
          </select>
        )}
      </Field>
      {text('positive')}
      {kind !== 'squareness' && text('error')}
      {number('instrument_a')}
      {number('instrument_b')}
      {kind === 'squareness' && number('square_error')}
      {kind === 'squareness' && number('square_uncertainty')}
      {kind === 'angles' && (
        <Field label={t('offset')} fault={is_no_offset(form) ? t('offset_fault') : null}>
          {(ids) => (
            <span class="row">
              {form.offset.map((one, k) => (
                <input key={k} {...(k === 0 ? ids : {})} aria-label={`${t('offset')} ${'XYZ'[k]}`} size={6} inputMode="decimal" value={one}
                  onInput={(event) => {
                    const [x, y, z] = form.offset;
                    const typed = event.currentTarget.value;
                    set({ offset: k === 0 ? [typed, y, z] : k === 1 ? [x, typed, z] : [x, y, typed] });
                  }} />
              ))}
            </span>
          )}
        </Field>
      )}
    </div>
  );
}
