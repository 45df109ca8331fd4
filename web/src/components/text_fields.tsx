// SPDX-License-Identifier: Apache-2.0
import { Field } from './field';

export interface TextField { key: string; label: string; type?: 'text' | 'date' | 'area'; fault?: string | null; first?: boolean }

/** A grid of plain text fields, their values by key. */
export function TextFields({ fields, values, on_change }: {
  fields: readonly TextField[]; values: Record<string, string>; on_change: (key: string, value: string) => void;
}) {
  return (
    <div class="form-grid">
      {fields.map((field) => (
        <div key={field.key} class={field.type === 'area' ? 'whole' : ''}>
          <Field label={field.label} fault={field.fault ?? null}>
            {(ids) => {
              const shared = { ...ids, value: values[field.key] ?? '', ...(field.first ? { 'data-first': '' } : {}) };
              const change = (event: { currentTarget: { value: string } }) => on_change(field.key, event.currentTarget.value);
              return field.type === 'area'
                ? <textarea {...shared} rows={3} onInput={change} />
                : <input {...shared} placeholder={field.type === 'date' ? 'yyyy-mm-dd' : undefined} onInput={change} />;
            }}
          </Field>
        </div>
      ))}
    </div>
  );
}
