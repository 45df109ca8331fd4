// SPDX-License-Identifier: Apache-2.0
import type { Machine, PlanFile, PlanRequest, Vocabulary } from '../../api/types';
import { Field } from '../../components/field';
import { position_unit, shortest } from '../../numbers';
import { drawn_seed, type Faults, type Key, type Kind, type PlanForm } from './form';
import { further_fields, of_further, t } from './texts';

interface Props {
  form: PlanForm;
  change: (part: Partial<PlanForm>) => void;
  faults: Faults;
  chosen: PlanFile | null; // by the planner, for what is left empty
  machines: Machine[];
  vocabulary: Vocabulary | null;
}

type TextKey = Key | 'title';

export function PlanFields(props: Props) {
  const { form, change, vocabulary, chosen } = props;
  const unit = position_unit(form.kind);
  const cycles = (vocabulary?.cycles ?? [{ id: form.cycle, title: form.cycle }]).map(({ id, title }) => ({ id, ...name_of(title) }));
  const cycle = cycles.find(({ id }) => id === form.cycle);
  const whole = (value: number | undefined) => (value === undefined ? t('automatic') : shortest(value));
  return (
    <form class="plan-form" onSubmit={(event) => event.preventDefault()}>
      <AxisFields {...props} />
      <div class="pair">
        <TextField {...props} key_="from" label={t('from')} unit={unit} />
        <TextField {...props} key_="to" label={t('to')} unit={unit} />
      </div>
      <TargetFields {...props} />
      <Field label={t('cycle')} hint={cycle?.what}>
        {(ids) => (
          <select {...ids} value={form.cycle} onChange={(event) => change({ cycle: event.currentTarget.value as PlanRequest['cycle'] })}>
            {cycles.map(({ id, name }) => <option key={id} value={id}>{name}</option>)}
          </select>
        )}
      </Field>
      {form.cycle === 'user-defined' && <FurtherField {...props} name="sequence" label={t('sequence')} hint={t('sequence_hint')} />}
      <div class="pair">
        <TextField {...props} key_="runs" label={t('runs')} placeholder={whole(chosen?.runs)} />
        <TextField {...props} key_="dwell" label={t('dwell')} unit="s" placeholder={whole(chosen?.dwell_s)} />
        <TextField {...props} key_="feed" label={t('feed')} unit={`${unit}/min`} placeholder={whole(chosen?.feed)} />
        <TextField {...props} key_="overrun" label={t('overrun')} unit={unit} placeholder={whole(chosen?.overrun)} />
      </div>
      <p class="quiet small">{t('automatic_hint')}</p>
      <div class="with-button">
        <TextField {...props} key_="seed" label={t('seed')} />
        <button type="button" onClick={() => change({ seed: drawn_seed() })}>{t('draw')}</button>
      </div>
      <MoreFields {...props} />
    </form>
  );
}

/** "Step cycle: all runs at one target" is a name, and what it means: the name fits into a list. */
function name_of(title: string): { name: string; what: string | undefined } {
  const [name = title, ...rest] = title.split(': ');
  return { name, what: rest.length === 0 ? undefined : rest.join(': ') };
}

function AxisFields(props: Props) {
  const { form, change, machines } = props;
  const pick = (value: string) => {
    const machine = machines.find((one) => one.axes.some((axis) => String(axis.id) === value));
    const axis = machine?.axes.find((one) => String(one.id) === value);
    if (!machine || !axis) return change({ axis: null });
    change({ axis: axis.id, further: { ...form.further, machine: machine.name }, ...of_kind(form, axis.kind), name: axis.name });
  };
  return (
    <>
      <Field label={t('of_store')}>
        {(ids) => (
          <select {...ids} value={form.axis === null ? '' : String(form.axis)} onChange={(event) => pick(event.currentTarget.value)}>
            <option value="">{t('named_here')}</option>
            {machines.filter((machine) => machine.axes.length > 0).map((machine) => (
              <optgroup key={machine.id} label={machine.name}>
                {machine.axes.map((axis) => <option key={axis.id} value={String(axis.id)}>{`${machine.name} · ${axis.name}`}</option>)}
              </optgroup>
            ))}
          </select>
        )}
      </Field>
      {form.axis === null && (
        <div class="pair">
          <TextField {...props} key_="name" label={t('axis_name')} />
          <Field label={t('kind')}>
            {(ids) => (
              <select {...ids} value={form.kind} onChange={(event) => change(of_kind(form, event.currentTarget.value as Kind))}>
                <option value="linear">{t('linear')}</option>
                <option value="rotary">{t('rotary')}</option>
              </select>
            )}
          </Field>
        </div>
      )}
      {form.axis === null && <FurtherField {...props} name="machine" label={t('machine_name')} />}
    </>
  );
}

/** Another kind has another travel as a rule; one that was typed stays. */
function of_kind(form: PlanForm, kind: Kind): Partial<PlanForm> {
  const untouched = form.from === '0' && (form.to === '500' || form.to === '360');
  return { kind, to: untouched ? (kind === 'linear' ? '500' : '360') : form.to };
}

function TargetFields(props: Props) {
  const { form, change } = props;
  const ways = [['planner', t('by_planner')], ['count', t('by_count')], ['own', t('by_hand')]] as const;
  return (
    <>
      <Field label={t('targets')}>
        {(ids) => (
          <select {...ids} value={form.how} onChange={(event) => change({ how: event.currentTarget.value as PlanForm['how'] })}>
            {ways.map(([id, title]) => <option key={id} value={id}>{title}</option>)}
          </select>
        )}
      </Field>
      {form.how === 'count' && <TextField {...props} key_="count" label={t('how_many')} />}
      {form.how === 'own' && (
        <Field label={`${t('own_positions')} (${position_unit(form.kind)})`} hint={t('own_hint')} fault={props.faults.positions ?? null}>
          {(ids) => (
            <textarea {...ids} rows={6} class="number" value={form.positions} onInput={(event) => change({ positions: event.currentTarget.value })} />
          )}
        </Field>
      )}
    </>
  );
}

function MoreFields(props: Props) {
  const { form } = props;
  const given = further_fields.filter(({ key }) => (form.further[key] ?? '') !== '').length;
  const unit = position_unit(form.kind);
  const units = { position: unit, acceleration: `${unit}/s²`, '': '' };
  return (
    <details class="more">
      <summary>{t('more')}{given > 0 && <span class="quiet small"> · {t('given', { n: given })}</span>}</summary>
      <div class="pair">
        {further_fields.map((row) => (
          <FurtherField {...props} key={row.key} name={row.key} label={of_further(row.key)} unit={units[row.unit]} placeholder={row.form} />
        ))}
      </div>
    </details>
  );
}

export function TextField({ form, change, faults, key_, label, unit, placeholder }:
  Props & { key_: TextKey; label: string; unit?: string; placeholder?: string }) {
  const fault = key_ === 'title' ? null : (faults[key_] ?? null);
  const numeric = key_ !== 'title' && key_ !== 'name';
  return (
    <Field label={unit ? `${label} (${unit})` : label} fault={fault}>
      {(ids) => (
        <input {...ids} value={form[key_]} placeholder={placeholder ?? ''} class={numeric ? 'number' : ''} autocomplete="off"
          inputMode={numeric ? 'decimal' : 'text'} onInput={(event) => change({ [key_]: event.currentTarget.value })} />
      )}
    </Field>
  );
}

function FurtherField({ form, change, name, label, hint, unit, placeholder }:
  Props & { name: string; label: string; hint?: string; unit?: string; placeholder?: string }) {
  return (
    <Field label={unit ? `${label} (${unit})` : label} hint={hint}>
      {(ids) => (
        <input {...ids} value={form.further[name] ?? ''} placeholder={placeholder ?? ''} autocomplete="off"
          onInput={(event) => change({ further: { ...form.further, [name]: event.currentTarget.value } })} />
      )}
    </Field>
  );
}
