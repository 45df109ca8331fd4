// SPDX-License-Identifier: Apache-2.0
import { Field } from '../../components/field';
import { NumberField, TripleFields } from '../tracking/fields';
import type { Faults } from '../tracking/form';
import type { PlaceForm, TextKey, VolumeForm } from './form';
import { t } from './texts';
import { colon } from '../../i18n/colon';

export interface VolumeFormProps { form: VolumeForm; change: (part: Partial<VolumeForm>) => void; faults: Faults }

export function VolumeNumber({ form, change, faults, name, label, placeholder }: VolumeFormProps & { name: TextKey; label: string; placeholder?: string }) {
  return (
    <NumberField label={label} value={form.texts[name]} fault={faults[name] ?? null} placeholder={placeholder ?? ''}
      set={(text) => change({ texts: { ...form.texts, [name]: text } })} />
  );
}

interface PlacesProps {
  legend: string; hint: string; add: string;
  told: 'tool_n' | 'station_n';
  kind: 'tool' | 'station';
  places: PlaceForm[];
  least: number; most: number;
  faults: Faults;
  set: (places: PlaceForm[]) => void;
}

/** Names with X, Y and Z: tools or stations. */
export function Places({ legend, hint, add, told, kind, places, least, most, faults, set }: PlacesProps) {
  const change = (at: number, part: Partial<PlaceForm>) => set(places.map((one, k) => (k === at ? { ...one, ...part } : one)));
  const next = (): PlaceForm => {
    const letter = kind === 'tool' ? 'T' : 'S';
    const free = Array.from({ length: most + 1 }, (_, k) => `${letter}${k + 1}`).find((name) => !places.some((one) => one.name === name)) ?? letter;
    return { name: free, at: [...(places[places.length - 1]?.at ?? ['0', '0', '0'])] };
  };
  return (
    <fieldset class="triple places">
      <legend>{legend} (mm)</legend>
      <p class="hint">{hint}</p>
      {places.map((place, k) => (
        <div key={k} class="obstacle" role="group" aria-label={t(told, { name: place.name })}>
          <div class="with-button">
            <Field label={t('machine_name')} fault={faults[`${kind}.${k}.name`] ?? null}>
              {(ids) => <input {...ids} value={place.name} autocomplete="off" onInput={(event) => change(k, { name: event.currentTarget.value })} />}
            </Field>
            {places.length > least && <button type="button" aria-label={`${t('remove')}${colon()} ${place.name}`} onClick={() => set(places.filter((_, i) => i !== k))}>{t('remove')}</button>}
          </div>
          <TripleFields legend={t(told, { name: place.name })} unit="" name={`${kind}.${k}`} values={place.at} faults={faults} set={(at) => change(k, { at })} />
        </div>
      ))}
      {places.length < most && <div><button type="button" onClick={() => set([...places, next()])}>{add}</button></div>}
    </fieldset>
  );
}
