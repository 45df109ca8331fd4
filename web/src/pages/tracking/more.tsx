// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import { TextNumber, TripleFields, type FormProps } from './fields';
import { is_aligned, reflectors, text_keys, type Faults, type ObstacleForm } from './form';
import { t } from './texts';

const empty: ObstacleForm = { name: '', low: ['', '', ''], high: ['', '', ''] };
const of_limits = text_keys.slice(text_keys.indexOf('range_least'));
const of_aligned = text_keys.slice(text_keys.indexOf('constant'));

/** What most set-ups need not say. */
export function MoreFields(props: FormProps) {
  const { form, change } = props;
  const keys = is_aligned(form) ? of_aligned : of_limits;
  const given = form.obstacles.length + (is_aligned(form) || form.reflector === '' ? 0 : 1) + keys.filter((key) => form.texts[key].trim() !== '').length;
  return (
    <details class="more">
      <summary>{t(is_aligned(form) ? 'more_aligned' : 'more')}{given > 0 && <span class="quiet small"> · {given}</span>}</summary>
      <div class="tracking-form">
        <Obstacles obstacles={form.obstacles} set={(obstacles) => change({ obstacles })} faults={props.faults} />
        {!is_aligned(form) && <TrackerLimits {...props} />}
        <fieldset class="triple">
          <legend>{t('uncertainty')}</legend>
          <div class="pair">
            <TextNumber {...props} name="constant" label="µm" placeholder="0.2" />
            <TextNumber {...props} name="per_length" label="+ µm/m" placeholder="0.3" />
          </div>
        </fieldset>
      </div>
    </details>
  );
}

/** What a tracking instrument and its reflector can do; an aligned interferometer has no such limits. */
function TrackerLimits(props: FormProps) {
  const { form, change } = props;
  return (
    <>
        <Field label={t('reflector')}>
          {(ids) => (
            <select {...ids} value={form.reflector} onChange={(event) => change({ reflector: event.currentTarget.value })}>
              <option value="">{t('auto')}</option>
              {reflectors.map(([name]) => <option key={name} value={name}>{name}</option>)}
            </select>
          )}
        </Field>
        <div class="pair">
          <TextNumber {...props} name="range_least" label={`${t('range_least')} (mm)`} placeholder="200" />
          <TextNumber {...props} name="range_most" label={`${t('to')} (mm)`} placeholder="15000" />
          <TextNumber {...props} name="elevation_lowest" label={`${t('elevation_lowest')} (°)`} placeholder="−20" />
          <TextNumber {...props} name="elevation_highest" label={`${t('to')} (°)`} placeholder="90" />
        </div>
        <TextNumber {...props} name="incidence" label={`${t('incidence')} (°)`} placeholder="60" />
        <div class="pair">
          <TextNumber {...props} name="safe_radius" label={`${t('safe_radius')} (mm)`} placeholder="120" />
          <TextNumber {...props} name="line_least" label={`${t('line_least')} (mm)`} placeholder="100" />
        </div>
    </>
  );
}

/** Boxes that stand in the way; faults are those of "obstacle.K.low" and "obstacle.K.high". */
export function Obstacles({ obstacles, set, faults }: { obstacles: ObstacleForm[]; set: (obstacles: ObstacleForm[]) => void; faults: Faults }) {
  const change = (at: number, part: Partial<ObstacleForm>) => set(obstacles.map((one, k) => (k === at ? { ...one, ...part } : one)));
  return (
    <fieldset class="triple">
      <legend>{t('obstacles')}</legend>
      <p class="hint">{t('obstacles_hint')}</p>
      {obstacles.map((obstacle, k) => (
        <div key={k} class="obstacle" role="group" aria-label={t('obstacle', { n: k + 1 })}>
          <div class="with-button">
            <Field label={t('machine_name')}>
              {(ids) => <input {...ids} value={obstacle.name} autocomplete="off" onInput={(event) => change(k, { name: event.currentTarget.value })} />}
            </Field>
            <button type="button" onClick={() => set(obstacles.filter((_, i) => i !== k))}>{t('remove')}</button>
          </div>
          <TripleFields legend={t('from', { axis: '' }).trim()} name={`obstacle.${k}.low`} values={obstacle.low} faults={faults} set={(low) => change(k, { low })} />
          <TripleFields legend={t('to')} name={`obstacle.${k}.high`} values={obstacle.high} faults={faults} set={(high) => change(k, { high })} />
        </div>
      ))}
      <div><button type="button" onClick={() => set([...obstacles, empty])}>{t('add_obstacle')}</button></div>
    </fieldset>
  );
}
