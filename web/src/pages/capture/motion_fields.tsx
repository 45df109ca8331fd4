// SPDX-License-Identifier: Apache-2.0
// What a capture of a straightness or a rotation is told before it begins.
import type { PlanFile, StopSign } from '../../api/types';
import { Field } from '../../components/field';
import { t } from './motion_texts';

type Texts = Record<string, string>;
interface Props {
  plan: PlanFile; options: Texts; option: (key: string, text: string) => void;
  simulated: boolean; // so that nothing is to be said of a stream and an instrument
}

const signs = ['keys', 'trigger', 'readings', 'position'] as const satisfies readonly StopSign[];
const of_lengths = ['um', 'mm', 'nm', 'in'], of_angles = ['urad', 'arcsec', 'mrad', 'deg'];

const sign_of: Texts = { um: 'µm', urad: 'µrad', arcsec: '″', deg: '°' };

/** Of the plan's errors those that are no positions. */
const motions_of = ({ errors }: PlanFile): string[] => (errors ?? []).filter((name) => name[1] !== name[2]);
const is_rotation = (error: string): boolean => 'ABC'.includes(error[1] ?? '');

/** What is read: another plan may not have what was chosen for the one before, nor its units. */
const error_of = (plan: PlanFile, options: Texts): string => {
  const errors = motions_of(plan);
  return errors.find((name) => name === options['error']) ?? errors[0] ?? '';
};
const units_of = (error: string): readonly string[] => (is_rotation(error) ? of_angles : of_lengths);

export const stops_of = (options: Texts): StopSign => signs.find((sign) => sign === options['stops']) ?? 'keys';

export const size_unit_of = (plan: PlanFile, options: Texts): string => (is_rotation(error_of(plan, options)) ? 'µrad' : 'µm');

/** Only what the chosen stops have a use for; the rest of the options is that of every stream. */
export function motion_options(plan: PlanFile, options: Texts, simulated: boolean): Texts {
  const stops = stops_of(options);
  const error = error_of(plan, options);
  const useless = [
    'part', 'zero', ...(stops === 'position' ? [] : ['datum', 'reverse', 'target-window']),
    ...(stops === 'trigger' || stops === 'position' ? [] : ['stop-column']),
    ...(stops === 'keys' || stops === 'trigger' ? [] : ['reading-window']), ...(stops === 'readings' ? ['still'] : []),
    ...(motions_of(plan).length > 1 ? [] : ['error']), ...(units_of(error).includes(options['unit'] ?? '') ? [] : ['unit']),
    ...(simulated ? of_a_stream : []),
  ];
  const said = { ...options, stops, ...(error ? { error } : {}) };
  return Object.fromEntries(Object.entries(said).filter(([key]) => !useless.includes(key)));
}
const of_a_stream = ['unit', 'stream-axis', 'stop-column', 'equipment'];
const only_of_motions = ['stops', 'stop-column', 'error', 'unit', 'positive', 'reading-window', 'still', 'equipment', 'size'];
export const without_motion = (options: Texts): Texts => Object.fromEntries(Object.entries(options).filter(([key]) => !only_of_motions.includes(key)));

export function MotionFields({ plan, options, option, simulated }: Props) {
  const errors = motions_of(plan);
  const stops = stops_of(options);
  const error = error_of(plan, options);
  const units = units_of(error);
  const typed = (key: string, label: string, hint: string, numeric: boolean) => (
    <Field label={label} hint={hint}>
      {(ids) => (
        <input {...ids} class={numeric ? 'number' : ''} inputMode={numeric ? 'decimal' : 'text'} spellcheck={false} value={options[key] ?? ''}
          onInput={(event) => option(key, event.currentTarget.value)} />
      )}
    </Field>
  );
  return (
    <>
      <Field label={t('stops')} hint={t('stops_hint', { errors: errors.join(', ') })}>
        {(ids) => (
          <select {...ids} value={stops} onChange={(event) => option('stops', event.currentTarget.value)}>
            {signs.map((sign) => <option key={sign} value={sign}>{t(sign)}</option>)}
          </select>
        )}
      </Field>
      <div class="pair">
        {errors.length > 1 && (
          <Field label={t('error')}>
            {(ids) => (
              <select {...ids} value={error} onChange={(event) => option('error', event.currentTarget.value)}>
                {errors.map((name) => <option key={name} value={name}>{name}</option>)}
              </select>
            )}
          </Field>
        )}
        {!simulated && (
          <Field label={t('unit')}>
            {(ids) => (
              <select {...ids} value={units.find((unit) => unit === options['unit']) ?? ''} onChange={(event) => option('unit', event.currentTarget.value)}>
                <option value="">{t('unit_named')}</option>
                {units.map((unit) => <option key={unit} value={unit}>{sign_of[unit] ?? unit}</option>)}
              </select>
            )}
          </Field>
        )}
        {!simulated && typed('stream-axis', t('reading_column'), t('column_hint'), true)}
        {!simulated && (stops === 'trigger' || stops === 'position') && typed('stop-column', t('stop_column'), t('column_hint'), true)}
        {typed('positive', t('positive'), t('positive_hint'), false)}
        {(stops === 'keys' || stops === 'trigger') && typed('reading-window', t('reading-window'), '', true)}
        {stops !== 'readings' && typed('still', t('still'), '', true)}
      </div>
      {!simulated && typed('equipment', t('equipment'), t('equipment_hint'), false)}
    </>
  );
}
