// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { ApiError, offer } from '../../api/client';
import type { Machine, VolumetricMachine } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { NumberField } from '../tracking/fields';
import { axes } from '../tracking/form';
import { ChainFields } from './chain';
import { Places, VolumeNumber, type VolumeFormProps } from './fields';
import { form_of_file } from './form';
import { t } from './texts';

interface Props extends VolumeFormProps { machines: Machine[]; machine: VolumetricMachine | null }

/** What the machine is: how it is built, its travels, its tools with a reflector, the instrument. */
export function MachinePanel(props: Props) {
  const { form, change, faults, machines } = props;
  const end = (key: 'low' | 'high', k: number) => (text: string) => change({ [key]: form[key].map((one, i) => (i === k ? text : one)) });
  return (
    <section class="panel" aria-labelledby="volume-machine">
      <header><h2 id="volume-machine"><span class="step">1</span>{t('machine')}</h2></header>
      <div class="tracking-form">
        <MachineFile {...props} />
        <Field label={t('machine_name')}>
          {(ids) => (
            <>
              <input {...ids} value={form.machine} list="volume-machines" autocomplete="off" onInput={(event) => change({ machine: event.currentTarget.value })} />
              <datalist id="volume-machines">{machines.map(({ id, name }) => <option key={id} value={name} />)}</datalist>
            </>
          )}
        </Field>
        <ChainFields chain={form.chain} other={form.other} fault={faults.chain ?? null} set={(chain, other) => change({ chain, other })} />
        <fieldset class="triple">
          <legend>{t('travels')} (mm)</legend>
          {axes.map((axis, k) => (
            <div key={axis} class="pair">
              <NumberField label={t('from', { axis })} value={form.low[k] ?? ''} fault={faults[`low.${k}`] ?? null} set={end('low', k)} />
              <NumberField label={t('to')} value={form.high[k] ?? ''} fault={faults[`high.${k}`] ?? null} set={end('high', k)} />
            </div>
          ))}
        </fieldset>
        <Places kind="tool" told="tool_n" legend={t('tools')} hint={t('tools_hint')} add={t('add_tool')} least={1} most={6} places={form.tools} faults={faults} set={(tools) => change({ tools })} />
        <fieldset class="triple">
          <legend>{t('instrument')}</legend>
          <div class="pair">
            <VolumeNumber {...props} name="a" label="a (µm)" />
            <VolumeNumber {...props} name="b" label="b (µm/m)" />
          </div>
        </fieldset>
        <VolumeNumber {...props} name="repeatability" label={t('repeatability')} />
        <VolumeNumber {...props} name="scale" label={t('scale')} placeholder="–" />
        <p class="hint">{t('scale_hint')}</p>
      </div>
    </section>
  );
}

function MachineFile({ form, change, machine }: Props) {
  const [error, set_error] = useState<ApiError | null>(null);
  const read = async (file: File) => {
    set_error(null);
    try {
      change(form_of_file(await file.text(), form));
    } catch (thrown) {
      set_error(new ApiError('refused', t('not_machine', { why: thrown instanceof Error ? thrown.message : String(thrown) }), 0));
    }
  };
  const save = () => offer(new Blob([`${JSON.stringify(machine, null, 2)}\n`], { type: 'application/json' }), `${form.machine.trim() || 'machine'}.machine.json`);
  return (
    <>
      <FileDrop label={t('choose_machine')} hint={t('drop_machine')} accept=".json,application/json" take={(file) => void read(file)} />
      <div><button type="button" disabled={machine === null} onClick={save}>{t('save_machine')}</button></div>
      {error && <FailureNotice error={error} />}
    </>
  );
}
