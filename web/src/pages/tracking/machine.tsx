// SPDX-License-Identifier: Apache-2.0
import type { Machine } from '../../api/types';
import { Field } from '../../components/field';
import { NumberField, TripleFields, type FormProps } from './fields';
import { axes } from './form';
import { t } from './texts';

/** What the machine is: its name, its travels, and what hangs in the spindle. */
export function MachinePanel({ form, change, faults, machines }: FormProps & { machines: Machine[] }) {
  const end = (key: 'low' | 'high', k: number) => (text: string) => change({ [key]: form[key].map((one, i) => (i === k ? text : one)) });
  return (
    <section class="panel" aria-labelledby="tracking-machine">
      <header><h2 id="tracking-machine"><span class="step">1</span>{t('machine')}</h2></header>
      <div class="tracking-form">
        <Field label={t('machine_name')}>
          {(ids) => (
            <>
              <input {...ids} value={form.machine} list="tracking-machines" autocomplete="off" onInput={(event) => change({ machine: event.currentTarget.value })} />
              <datalist id="tracking-machines">{machines.map(({ id, name }) => <option key={id} value={name} />)}</datalist>
            </>
          )}
        </Field>
        <fieldset class="triple">
          <legend>{t('travels')} (mm)</legend>
          {axes.map((axis, k) => (
            <div key={axis} class="pair">
              <NumberField label={t('from', { axis })} value={form.low[k] ?? ''} fault={faults[`low.${k}`] ?? null} set={end('low', k)} />
              <NumberField label={t('to')} value={form.high[k] ?? ''} fault={faults[`high.${k}`] ?? null} set={end('high', k)} />
            </div>
          ))}
        </fieldset>
        <TripleFields legend={t('tool')} hint={t('tool_hint')} name="tool" values={form.tool} faults={faults} set={(tool) => change({ tool })} />
      </div>
    </section>
  );
}
