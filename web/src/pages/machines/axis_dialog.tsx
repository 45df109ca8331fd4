// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Axis, Limit, Parameter } from '../../api/types';
import { EntityDialog } from '../../components/entity_dialog';
import { Field } from '../../components/field';
import { ParameterSymbol } from '../../components/symbol';
import { TextFields } from '../../components/text_fields';
import { parsed, shortest, unit_sign } from '../../numbers';
import { parameters } from './parameters';
import { t } from './texts';

interface Props { axis: Axis | null; machine: number; on_saved: (axis: Axis) => void; on_close: () => void }

/** An axis and its limits, per parameter in its native unit. */
export function AxisDialog({ axis, machine, on_saved, on_close }: Props) {
  const [texts, set_texts] = useState<Record<string, string>>({ name: axis?.name ?? '', notes: axis?.notes ?? '' });
  const [kind, set_kind] = useState(axis?.kind ?? 'linear');
  const [limits, set_limits] = useState<Partial<Record<Parameter, string>>>(
    Object.fromEntries((axis?.limits ?? []).map((limit) => [limit.parameter, shortest(limit.value, 6)])),
  );
  const [tried, set_tried] = useState(false);
  const nameless = (texts['name'] ?? '').trim() === '';
  const unit = unit_sign(kind === 'linear' ? 'um' : 'arcsec');
  const wrong = (text: string | undefined): boolean => text !== undefined && text.trim() !== '' && !((parsed(text) ?? -1) > 0);
  const collect = () => {
    set_tried(true);
    if (nameless || parameters.some((key) => wrong(limits[key]))) return null;
    const given: Limit[] = parameters.flatMap((parameter) => {
      const value = parsed(limits[parameter] ?? '');
      return value === null ? [] : [{ parameter, value }];
    });
    return { machine, name: texts['name'], kind, limits: given, notes: texts['notes'] };
  };
  return (
    <EntityDialog<Axis>
      title={axis ? t('edit_axis', { name: axis.name }) : t('add_axis_title')} path="/api/axes" entity={axis} collect={collect}
      on_saved={on_saved} on_theirs={on_saved} on_close={on_close}
    >
      <div class="form-grid">
        <Field label={t('name')} fault={tried && nameless ? t('name_missing') : null}>
          {(ids) => (
            <input {...ids} value={texts['name'] ?? ''} onInput={(event) => set_texts({ ...texts, name: event.currentTarget.value })} {...(axis ? {} : { 'data-first': '' })} />
          )}
        </Field>
        <Field label={t('kind')}>
          {(ids) => (
            <select {...ids} value={kind} onChange={(event) => set_kind(event.currentTarget.value as Axis['kind'])}>
              <option value="linear">{t('linear')}</option>
              <option value="rotary">{t('rotary')}</option>
            </select>
          )}
        </Field>
      </div>
      <fieldset class="limits">
        <legend>{t('limits')} <span class="quiet small">{t('limits_hint', { unit })}</span></legend>
        <div class="limit-grid">
          {parameters.map((key) => (
            <Field key={key} label={<ParameterSymbol parameter={key} />} fault={wrong(limits[key]) ? t('limit_fault', { text: limits[key] ?? '' }) : null}>
              {(ids) => (
                <input
                  {...ids} inputMode="decimal" class="number" value={limits[key] ?? ''} {...(axis && key === 'A' ? { 'data-first': '' } : {})}
                  onInput={(event) => set_limits({ ...limits, [key]: event.currentTarget.value })}
                />
              )}
            </Field>
          ))}
        </div>
      </fieldset>
      <TextFields fields={[{ key: 'notes', label: t('notes'), type: 'area' }]} values={texts} on_change={(key, value) => set_texts({ ...texts, [key]: value })} />
    </EntityDialog>
  );
}
