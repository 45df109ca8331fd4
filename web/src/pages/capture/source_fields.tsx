// SPDX-License-Identifier: Apache-2.0
// Where a capture listens, and what it is told of the stream.
import type { Source, StopSign } from '../../api/types';
import { Field } from '../../components/field';
import { parsed, shortest } from '../../numbers';
import { layouts, layouts_of_readings, of_option, option_keys, t } from './texts';

type Texts = Record<string, string>;
export interface SourceForm { source: string; layout: string; options: Texts }

type Read = 'positions' | 'lengths' | 'motion';
const simulator_keys = ['speed', 'preset', 'seed', 'size'];
const simulated_stops = ['stops', 'error', 'positive', 'reading-window', 'still']; // of a motion

const presets_of = (source: Source, read: Read) =>
  ({ positions: source.presets, lengths: source.length_presets, motion: source.motion_presets })[read] ?? [];
/** One that was chosen for readings of another kind is none of these. */
const preset_of = (source: Source, read: Read, chosen: string | undefined) =>
  presets_of(source, read).find(({ id }) => id === chosen) ?? presets_of(source, read)[0];

/** Of what was typed only what concerns the source, numbers with a point; a name of digits is no number. */
export function sent(typed: Texts, source: Source, read: Read): Texts {
  const simulated = source.kind === 'simulator';
  const concerns = (key: string) =>
    key === 'part' || (simulator_keys.includes(key) ? simulated && (key !== 'size' || read === 'motion') : !simulated || (read === 'motion' && simulated_stops.includes(key)));
  const options = simulated ? { ...typed, preset: preset_of(source, read, typed['preset'])?.id ?? '' } : typed;
  const entries = Object.entries(options).filter(([key, text]) => text.trim() !== '' && concerns(key));
  return Object.fromEntries(entries.map(([key, text]) => [key, key === 'equipment' || parsed(text) === null ? text.trim() : String(parsed(text))]));
}

export function SourceChoice({ sources, source, choose }: { sources: readonly Source[]; source: Source | undefined; choose: (id: string) => void }) {
  return (
    <Field label={t('source')} hint={t('sources_hint')}>
      {(ids) => (
        <select {...ids} value={source?.id ?? ''} onChange={(event) => choose(event.currentTarget.value)}>
          {sources.map(({ id, title, kind }) => <option key={id} value={id}>{kind === 'simulator' ? title : `${title} (${t(kind)})`}</option>)}
        </select>
      )}
    </Field>
  );
}

interface OptionsProps {
  source: Source; form: SourceForm; change: (part: Partial<SourceForm>) => void; unit: string;
  of_lengths?: boolean;
  of_motion?: StopSign; // what tells its stops
  size_unit?: string;   // of its error
}

/** What the chosen source is told, or what its stream does not say itself. */
export function SourceOptions(props: OptionsProps) {
  const option = (key: string, text: string) => props.change({ options: { ...props.form.options, [key]: text } });
  return props.source.kind === 'simulator' ? <SimulatorFields {...props} option={option} /> : <StreamFields {...props} option={option} />;
}

interface FieldsProps extends OptionsProps { option: (key: string, text: string) => void }

function SimulatorFields({ source, form: { options }, option, of_lengths, of_motion, size_unit }: FieldsProps) {
  const read = of_motion ? 'motion' : of_lengths ? 'lengths' : 'positions';
  const presets = presets_of(source, read), preset = preset_of(source, read, options['preset']);
  return (
    <div class="pair">
      <Field label={t(({ motion: 'happens_to_readings', lengths: 'happens', positions: 'fault' } as const)[read])} hint={preset?.sign}>
        {(ids) => (
          <select {...ids} value={preset?.id ?? ''} onChange={(event) => option('preset', event.currentTarget.value)}>
            {presets.map(({ id, title }) => <option key={id} value={id}>{title}</option>)}
          </select>
        )}
      </Field>
      <Field label={t('speed')} hint={t('speed_hint')}>
        {(ids) => (
          <select {...ids} class="number" value={options['speed'] ?? ''} onChange={(event) => option('speed', event.currentTarget.value)}>
            {(source.speeds ?? [1]).map((speed) => <option key={speed} value={String(speed)}>{shortest(speed)}</option>)}
          </select>
        )}
      </Field>
      {of_motion && (
        <Field label={t('size', { unit: size_unit ?? '' })}>
          {(ids) => <input {...ids} class="number" inputMode="decimal" placeholder="5" value={options['size'] ?? ''} onInput={(event) => option('size', event.currentTarget.value)} />}
        </Field>
      )}
      <Field label={t('seed')}>
        {(ids) => <input {...ids} class="number" inputMode="numeric" placeholder={of_lengths ? t('of_plan') : ''} value={options['seed'] ?? ''} onInput={(event) => option('seed', event.currentTarget.value)} />}
      </Field>
    </div>
  );
}

/** Of a motion the column of its readings stands elsewhere, and only where the position tells the stops it has to rest. */
const of_a_motion = (stops: StopSign) => option_keys.filter((key) => key === 'rate' || (stops === 'position' && /rest|settling|window|datum/.test(key)));

function StreamFields({ form, change, option, unit, of_lengths, of_motion }: FieldsProps) {
  const keys = of_motion ? of_a_motion(of_motion) : option_keys.filter((key) => !(of_lengths && key === 'datum'));
  const possible = of_motion ? layouts_of_readings : layouts;
  const turns = of_motion === undefined || of_motion === 'position';
  return (
    <>
      <Field label={t('layout')}>
        {(ids) => (
          <select {...ids} value={form.layout} onChange={(event) => change({ layout: event.currentTarget.value })}>
            <option value="">{t('recognised')}</option>
            {possible.map((id) => <option key={id} value={id}>{id}</option>)}
          </select>
        )}
      </Field>
      <details>
        <summary>{t('more')}</summary>
        <div class="pair">
          {keys.map((key) => (
            <Field key={key} label={of_option(key, { unit })}>
              {(ids) => (
                <input {...ids} class="number" inputMode="decimal" placeholder={t('auto')} value={form.options[key] ?? ''}
                  onInput={(event) => option(key, event.currentTarget.value)} />
              )}
            </Field>
          ))}
        </div>
        <div class="boxes">
          {turns && (
            <label>
              <input type="checkbox" checked={form.options['reverse'] === '1'} onChange={(event) => option('reverse', event.currentTarget.checked ? '1' : '')} />
              {of_option(of_lengths ? 'reverse_lengths' : 'reverse')}
            </label>
          )}
          {!of_lengths && !of_motion && (
            <label>
              <input type="checkbox" checked={form.options['zero'] === 'first-target'} onChange={(event) => option('zero', event.currentTarget.checked ? 'first-target' : '')} />
              {of_option('zero')}
            </label>
          )}
        </div>
      </details>
    </>
  );
}
