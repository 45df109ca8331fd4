// SPDX-License-Identifier: Apache-2.0
// Readings of several stations to points: lengths alone, or with angles.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files, query } from '../../api/client';
import type { Multilateration, PolarResult, Vocabulary } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { use_settled } from '../../components/settled';
import { decimal, language } from '../../settings';
import { CoordinatesResult } from './coordinates_result';
import { file_of, multilateration_options, new_coordinates, polar_options, type CoordinatesFile, type CoordinatesForm } from './coordinates_form';
import { t } from './coordinates_texts';
import { t as t_page } from './texts';
import { colon } from '../../i18n/colon';

const most_bytes = { multilateration: 7_500_000, polar: 1_900_000 };  // of all files together, as the server takes

/** What was sent, so that reports and tables are of the same. */
export interface SentReadings { way: 'multilateration' | 'polar'; readings: readonly File[]; points: File | null; options: string }
export type Coordinates = Multilateration | PolarResult;

export function readings_form({ way, readings, points, options }: SentReadings): FormData {
  const form = new FormData();
  form.append('options', options);
  for (const file of readings) form.append(way === 'polar' ? 'readings' : 'ranges', file, file.name);
  if (points) form.append('points', points, points.name);
  return form;
}

async function found_by(sent: SentReadings, signal: AbortSignal): Promise<Coordinates> {
  const size = [...sent.readings, ...(sent.points ? [sent.points] : [])].reduce((sum, file) => sum + file.size, 0);
  const most = most_bytes[sent.way];
  if (size > most) throw new ApiError('refused', t_page('too_large', { n: Math.round(size / 1000), most: most / 1000 }), 0);
  return (await made_of_files(`/api/tracking/${sent.way}${query({ decimal: decimal.value })}`, readings_form(sent), signal)).json() as Promise<Coordinates>;
}

export function CoordinatesPanel({ vocabulary }: { vocabulary: Vocabulary | null }) {
  const [files, set_files] = useState<readonly CoordinatesFile[]>([]);
  const [form, set_form] = useState<CoordinatesForm>(new_coordinates);
  const [lengths_alone, set_lengths_alone] = useState(false);
  const [found, set_found] = useState<{ sent: SentReadings; result: Coordinates } | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const readings = files.filter(({ kind }) => kind !== 'nominal');
  const nominal = files.find(({ kind }) => kind === 'nominal')?.file ?? null;
  const has_angles = readings.some(({ kind }) => kind === 'angles');
  const way = has_angles && !lengths_alone ? 'polar' : 'multilateration';
  const stations = useMemo(() => [...new Set(readings.flatMap((one) => one.stations))], [files]);
  const { options: of_lengths, faults } = multilateration_options(form);
  const options = way === 'polar' ? polar_options(form, stations, nominal !== null) : of_lengths;
  const told = options && JSON.stringify(options);
  // All of it settles together: what a file is decides the way, and what is asked of it.
  const sent = use_settled(useMemo((): SentReadings | null =>
    (readings.length === 0 || told === null ? null : { way, readings: readings.map(({ file }) => file), points: nominal, options: told }), [files, way, told]));
  const spoken = language.value;
  useEffect(() => {
    set_error(null);
    if (sent === null) { set_found(null); return undefined; }
    const abort = new AbortController();
    set_busy(true);
    found_by(sent, abort.signal).then(
      (result) => { if (!abort.signal.aborted) { set_found({ sent, result }); set_busy(false); } },
      (thrown: unknown) => {
        if (abort.signal.aborted) return;
        set_found(null);
        set_error(as_error(thrown));
        set_busy(false);
      },
    );
    return () => { abort.abort(); set_busy(false); };
  }, [sent, spoken]);
  // There is one file of nominal points; a file of a name that is there already takes the place of the other.
  const take = async (dropped: readonly File[]) => {
    const more = await Promise.all(dropped.map(file_of));
    const last = more.filter(({ kind }) => kind === 'nominal').pop();
    const kept = more.filter((one) => one.kind !== 'nominal' || one === last);
    set_files((before) => [...before.filter((one) => !(last && one.kind === 'nominal') && !kept.some(({ file }) => file.name === one.file.name)), ...kept]);
  };
  const change = (part: Partial<CoordinatesForm>) => set_form((before) => ({ ...before, ...part }));
  const fields = { form, change };
  return (
    <section class="panel" aria-labelledby="tracking-coordinates">
      <header><h2 id="tracking-coordinates">{t('title')}</h2></header>
      <div class="tracking-form no-print">
        <p class="hint">{t('how')}</p>
        <FileDrop label={t('choose')} hint={t('drop')} accept=".csv,.txt,text/csv" take={{ all: (dropped) => void take(dropped) }} />
        {files.length > 0 && (
          <ul class="taken-files">
            {files.map(({ file, kind }) => (
              <li key={file.name}>
                <span class="mono small">{file.name}</span> <span class="quiet small">{t(kind === 'angles' ? 'with_angles' : kind === 'ranges' ? 'readings_of' : 'nominal')}</span>
                <button type="button" class="plain small" aria-label={`${t('remove')}${colon()} ${file.name}`} onClick={() => set_files(files.filter((one) => one.file !== file))}>{t('remove')}</button>
              </li>
            ))}
          </ul>
        )}
        {files.length > 0 && readings.length === 0 && <p class="notice">{t('no_readings')}</p>}
        {has_angles && (
          <Field label={t('way')}>
            {(ids) => (
              <select {...ids} value={lengths_alone ? 'lengths' : 'polar'} onChange={(event) => set_lengths_alone(event.currentTarget.value === 'lengths')}>
                <option value="polar">{t('polar')}</option>
                <option value="lengths">{t('lengths_alone')}</option>
              </select>
            )}
          </Field>
        )}
        {readings.length > 0 && (way === 'polar'
          ? <PolarFields {...fields} {...{ stations, vocabulary }} has_nominal={nominal !== null} />
          : <LengthFields {...fields} prior_fault={faults.prior ?? null} />)}
      </div>
      {busy && <p class="quiet" role="status">{t('adjusting')}</p>}
      {error && <FailureNotice error={error} />}
      {found && <CoordinatesResult {...found} try_lengths={stations.length >= 4 ? () => set_lengths_alone(true) : null} />}
    </section>
  );
}

interface FieldsProps { form: CoordinatesForm; change: (part: Partial<CoordinatesForm>) => void }

function TextField({ label, hint, value, set, fault = null, placeholder = '' }: { label: string; hint?: string; value: string; set: (text: string) => void; fault?: string | null; placeholder?: string }) {
  return (
    <Field label={label} hint={hint} fault={fault}>
      {(ids) => <input {...ids} autocomplete="off" placeholder={placeholder} value={value} onInput={(event) => set(event.currentTarget.value)} />}
    </Field>
  );
}

function LengthFields({ form, change, prior_fault }: FieldsProps & { prior_fault: string | null }) {
  return (
    <div class="coordinate-fields">
      <Field label={t('scale')}>
        {(ids) => (
          <select {...ids} value={form.scale} onChange={(event) => change({ scale: event.currentTarget.value as CoordinatesForm['scale'] })}>
            {(['fixed', 'common', 'free'] as const).map((scale) => <option key={scale} value={scale}>{t(scale)}</option>)}
          </select>
        )}
      </Field>
      {form.scale !== 'fixed' && <TextField label={t('prior')} value={form.prior} fault={prior_fault} set={(prior) => change({ prior })} />}
      <TextField label={t('ranging')} hint={t('ranging_hint')} value={form.ranging} placeholder="0.2um+0.3um/m" set={(ranging) => change({ ranging })} />
      <TextField label={t('repeatability')} hint={t('repeatability_hint')} value={form.repeatability} placeholder="0um" set={(repeatability) => change({ repeatability })} />
      <label class="check"><input type="checkbox" checked={form.find_breaks} onChange={(event) => change({ find_breaks: event.currentTarget.checked })} /> {t('find_breaks')}</label>
    </div>
  );
}

function PolarFields({ form, change, stations, vocabulary, has_nominal }: FieldsProps & { stations: readonly string[]; vocabulary: Vocabulary | null; has_nominal: boolean }) {
  const kinds = vocabulary?.trackers ?? [];
  const choice = (label: string, hint: string | null, none: string, value: string, set: (id: string) => void) => (
    <Field key={label} label={label} hint={hint}>
      {(ids) => (
        <select {...ids} value={value} onChange={(event) => set(event.currentTarget.value)}>
          <option value="">{none}</option>
          {kinds.map(({ id, title }) => <option key={id} value={id}>{title}</option>)}
        </select>
      )}
    </Field>
  );
  return (
    <div class="coordinate-fields">
      {choice(t('instrument'), t('instrument_hint'), t('as_rows'), form.instrument, (instrument) => change({ instrument }))}
      {stations.length > 1 && stations.map((station) => choice(t('instrument_of', { station }), null, t('as_all'), form.of_station[station] ?? '',
        (id) => change({ of_station: { ...form.of_station, [station]: id } })))}
      <TextField label={t('ranging')} hint={t('polar_ranging_hint')} value={form.polar_ranging} set={(polar_ranging) => change({ polar_ranging })} />
      <TextField label={t('angles')} hint={t('angles_hint')} value={form.angles} set={(angles) => change({ angles })} />
      {has_nominal && <label class="check"><input type="checkbox" checked={form.in_station} onChange={(event) => change({ in_station: event.currentTarget.checked })} /> {t('in_station')}</label>}
    </div>
  );
}
