// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import { position_unit, shortest } from '../../numbers';
import { bounds_of, fault_of, type DynamicForm, type NumberKey } from './form';
import { layouts, t } from './texts';

interface Props { form: DynamicForm; on_change: (form: DynamicForm) => void }

/** How a recording is evaluated. */
export function DynamicFields({ form, on_change }: Props) {
  const set = (part: Partial<DynamicForm>) => on_change({ ...form, ...part });
  const unit = position_unit(form.kind);
  const number = (key: NumberKey, hint?: string) => {
    const fault = fault_of(key, form[key]);
    const { above, most } = bounds_of(key);
    return (
      <Field label={t(key, { unit })} hint={hint} fault={fault && t(`${fault}_fault`, { above: shortest(above), most: shortest(most) })}>
        {(ids) => <input {...ids} class="number" inputMode="decimal" autocomplete="off" value={form[key]} onInput={(event) => set({ [key]: event.currentTarget.value })} />}
      </Field>
    );
  };
  const box = (key: 'reverse' | 'skip_damaged') => (
    <label><input type="checkbox" checked={form[key]} onChange={(event) => set({ [key]: event.currentTarget.checked })} />{t(key)}</label>
  );
  return (
    <>
      <div class="dynamic-fields">
        <Field label={t('kind')}>
          {(ids) => (
            <select {...ids} value={form.kind} onChange={(event) => set({ kind: event.currentTarget.value as DynamicForm['kind'] })}>
              <option value="linear">{t('linear')}</option><option value="rotary">{t('rotary')}</option>
            </select>
          )}
        </Field>
        {number('feed')}
        {number('from')}
        {number('to')}
        {number('window', t('window_hint'))}
        {number('even', t('even_hint'))}
      </div>
      <div class="boxes">{box('reverse')}{box('skip_damaged')}</div>
      <details>
        <summary>{t('more')}</summary>
        <div class="dynamic-fields">
          <Field label={t('stream')}>
            {(ids) => (
              <select {...ids} value={form.stream} onChange={(event) => set({ stream: event.currentTarget.value })}>
                <option value="">{t('recognised')}</option>
                {layouts.map((id) => <option key={id} value={id}>{id}</option>)}
              </select>
            )}
          </Field>
          {number('rate')}
          {number('units_per_count')}
          {number('stream_axis')}
        </div>
      </details>
    </>
  );
}
