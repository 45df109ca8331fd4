// SPDX-License-Identifier: Apache-2.0
// The temperatures before and during the test: a log that is dropped here is kept with the test and judged with it.
import { useEffect, useState } from 'preact/hooks';
import { type ApiError, as_error, query, upload } from '../../api/client';
import type { Document, FigureList, Options, Surroundings as Found, TemperatureSensors } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { texts } from '../../i18n/texts';
import { absent, fixed, marked, parsed } from '../../numbers';
import { decimal, language, screen_theme } from '../../settings';
import { type TestState } from './state';

const t = texts({
  title: 'Temperatures before and during the test',
  no_log: 'No log of temperatures.',
  hint: 'or drop it here: time and one or more sensors in columns. It is kept with the test at once.',
  add: 'Add a temperature log',
  adding: 'Adding …',
  remove: 'Without the log',
  log: 'Log: {name}',
  quantity: 'Quantity',
  measured: 'Measured',
  agreed: 'Agreed',
  standing: 'Standing',
  stated: 'stated',
  at_least: 'at least {x}',
  at_most: 'at most {x}',
  lowest_C: 'Lowest temperature of the air',
  highest_C: 'Highest temperature of the air',
  rate_C_per_h: 'Change per hour, during the test',
  rate_before_C_per_h: 'Change per hour, in the twelve hours before',
  machine_gradient_C: 'Gradient over the machine',
  kept: 'kept',
  exceeded: 'exceeded',
  not_reached: 'not reached',
  'not-measured': 'not measured',
  'not-agreed': 'no limit agreed',
  'known-in-part': 'known in part only',
  began: 'Test began',
  ended: 'Test ended',
  ended_by_readings: 'Test ended {moment} (by the times of the readings)',
  moment: 'Such as {example}',
  limit_low: 'Agreed lowest, °C',
  limit_high: 'Agreed highest, °C',
  limit_rate: 'Agreed change, °C/h',
  limit_gradient: 'Agreed gradient, °C',
  number: 'Expected: a number',
  sensor: 'Sensor {name} is of',
  by_name: 'as its name says',
  machine: ['the machine', 'sensor'],
  equipment: 'the measuring equipment',
  air: ['the air', 'sensor'],
  none: 'nothing that takes part',
});

/** All sensors of the log: of one whose names tell no role there is no result from which to take them. */
function use_sensors(state: TestState): readonly string[] {
  const hash = state.options.value.temperatures?.sha256;
  const kept = state.test.value.documents.find(({ sha256 }) => sha256 === hash);
  const asked = use_get<TemperatureSensors>(hash && kept ? `/api/documents/${kept.id}/temperature-sensors` : null);
  const found = state.evaluated.value.result.environment?.sensors ?? [];
  return [...(asked.error || !kept ? [] : asked.data?.sensors ?? []), ...found.map(({ name }) => name)];
}

type Log = NonNullable<Options['temperatures']>;
const tones = { kept: 'good', exceeded: 'bad', 'known-in-part': 'caution', 'not-measured': 'quiet', 'not-agreed': 'quiet' } as const;

export function Surroundings({ state }: { state: TestState }) {
  const [busy, set_busy] = useState(false);
  const [failure, set_failure] = useState<ApiError | null>(null);
  const log = state.options.value.temperatures;
  const found = state.evaluated.value.result.environment;
  const named = use_sensors(state);
  const newest = state.test.value.version === state.test.value.latest;
  const add = async (file: File) => {
    set_busy(true);
    set_failure(null);
    try {
      const document = await upload<Document>(`/api/tests/${state.test.value.id}/attachments`, file);
      state.test.value = { ...state.test.value, documents: [...state.test.value.documents, document] };
      state.edit();
      state.choose({ temperatures: { ...state.options.value.temperatures, sha256: document.sha256, name: document.name } });
    } catch (error) {
      set_failure(as_error(error));
    }
    set_busy(false);
  };
  // What is chosen now, not what was drawn last: two fields may change before the page is drawn again.
  const put = (part: Partial<Log>) => {
    const now = state.options.value.temperatures;
    if (now) state.choose({ temperatures: { ...now, ...part } });
  };
  const without = () => {
    const { temperatures: _, ...options } = state.options.value;
    state.edit();
    state.replace(state.changes.value, options);
  };
  return (
    <section class="panel flush surroundings-panel">
      <header>
        <h2>{t('title')}</h2>
        {log && newest && <button type="button" class="small no-print" onClick={without}>{t('remove')}</button>}
      </header>
      {failure && <FailureNotice error={failure} />}
      {newest && <div class="foot no-print"><FileDrop label={busy ? t('adding') : t('add')} hint={t('hint')} take={(file) => void add(file)} /></div>}
      {!log && !found && !newest && <p class="quiet foot">{t('no_log')}</p>}
      {log && <p class="quiet foot">{t('log', { name: log.name })}</p>}
      {found && (log ?? found.source === null) && <Quantities found={found} />}
      {found?.ended_by_readings && <p class="quiet foot">{t('ended_by_readings', { moment: found.ended_by_readings })}</p>}
      {found && found.gaps.length > 0 && <ul class="small caution foot">{found.gaps.map((gap) => <li key={gap}>{sentence(gap)}</li>)}</ul>}
      {state.test.value.options.temperatures && <Drawn state={state} />}
      {log && state.editing.value && <Agreed log={log} named={named} put={put} blame={(name, fault) => state.blame(`temperatures.${name}`, fault)} />}
    </section>
  );
}

function Quantities({ found }: { found: Found }) {
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
      <table>
        <thead>
          <tr><th scope="col">{t('quantity')}</th><th scope="col" class="number">{t('measured')}</th><th scope="col">{t('agreed')}</th><th scope="col">{t('standing')}</th></tr>
        </thead>
        <tbody>
          {found.quantities.map((row) => (
            <tr key={row.key}>
              <th scope="row">{t(row.key)}</th>
              <td class="number">{row.measured === null ? absent : `${fixed(row.measured, decimals_of(row))} ${row.unit}${row.stated ? ` (${t('stated')})` : ''}`}</td>
              <td>{row.agreed === null ? absent : t(row.limit === 'lowest' ? 'at_least' : 'at_most', { x: `${marked(String(row.agreed))} ${row.unit}` })}</td>
              <td class={tones[row.standing]}>{t(row.standing === 'exceeded' && row.limit === 'lowest' ? 'not_reached' : row.standing)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** As the report has it: more where two would show the limit itself. */
const decimals_of = ({ measured, agreed }: Found['quantities'][number]) =>
  measured !== null && agreed !== null && Math.abs(measured - agreed) < 0.01 ? 4 : 2;

const sentence = (words: string) => `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;

/** As the report has it: of the kept version. */
function Drawn({ state }: { state: TestState }) {
  const test = state.test.value;
  const list = use_get<FigureList>(`/api/tests/${test.id}/figures${query({ version: test.version, language: language.value })}`);
  const figure = list.data?.figures.find(({ title }) => title === t('title'));
  if (figure === undefined || state.edited.value) return null;
  const path = `/api/tests/${test.id}/figures/${figure.id}.svg${query({ version: test.version, theme: screen_theme.value, language: language.value, decimal: decimal.value })}`;
  return <div class="figure-frame" tabIndex={0} role="region" aria-label={figure.title}><img class="library-figure" src={path} alt={figure.title} /></div>;
}

const limits = [['lowest_C', 'limit_low'], ['highest_C', 'limit_high'], ['rate_C_per_h', 'limit_rate'], ['gradient_C', 'limit_gradient']] as const;

/** When the test was, and what the parties agreed on. */
function Agreed({ log, named, put, blame }: { log: Log; named: readonly string[]; put: (part: Partial<Log>) => void; blame: (name: string, fault: string | null) => void }) {
  return (
    <div class="sampling-fields">
      {(['began', 'ended'] as const).map((name) => (
        <Field key={name} label={t(name)} hint={t('moment', { example: name === 'began' ? '2026-03-02T09:00' : '2026-03-02T10:10' })}>
          {(ids) => <Entry ids={ids} value={log[name] ?? ''} take={(text) => put({ [name]: text.trim() || undefined })} />}
        </Field>
      ))}
      {limits.map(([name, label]) => <Limit key={name} label={t(label)} value={log[name]} put={(x) => put({ [name]: x })} blame={(fault) => blame(name, fault)} />)}
      <SensorRoles log={log} named={named} put={put} />
    </div>
  );
}

type Role = NonNullable<Log['sensors']>[number]['role'];
const sensor_roles: readonly Role[] = ['machine', 'equipment', 'air', 'none'];

/** What each sensor is of where its name does not say it, or wrongly; one that takes no part stays to be chosen. */
function SensorRoles({ log, named, put }: { log: Log; named: readonly string[]; put: (part: Partial<Log>) => void }) {
  const stated = log.sensors ?? [];
  const names = [...new Set([...named, ...stated.map(({ name }) => name)])].sort();
  const choose = (name: string, role: Role | undefined) => {
    const chosen = [...stated.filter((other) => other.name !== name), ...(role ? [{ name, role }] : [])];
    put({ ['sensors' as string]: chosen.length > 0 ? chosen : undefined });
  };
  return (
    <>
      {names.map((name) => (
        <Field key={name} label={t('sensor', { name })}>
          {(ids) => (
            <select {...ids} value={stated.find((one) => one.name === name)?.role ?? ''}
              onChange={(event) => choose(name, sensor_roles.find((role) => role === event.currentTarget.value))}>
              <option value="">{t('by_name')}</option>
              {sensor_roles.map((role) => <option key={role} value={role}>{t(role)}</option>)}
            </select>
          )}
        </Field>
      ))}
    </>
  );
}

/** A number, with its unit or without. */
const number_of = (text: string) => parsed(text.trim().replace(/\s*(°\s*C|K)(\/h)?$/i, ''));

function Limit({ label, value, put, blame }: { label: string; value: number | undefined; put: (x: number | undefined) => void; blame: (fault: string | null) => void }) {
  const [fault, set_fault] = useState<string | null>(null);
  const take = (text: string) => {
    const x = number_of(text);
    const empty = text.trim() === '';
    const told = empty || x !== null ? null : t('number');
    set_fault(told);
    blame(told);
    if (empty || x !== null) put(empty ? undefined : x ?? undefined);
  };
  return (
    <Field label={label} fault={fault}>
      {(ids) => <Entry ids={ids} decimal value={value === undefined ? '' : marked(String(value))} take={take} />}
    </Field>
  );
}

/** What is typed stays while the page is drawn again for another field. */
function Entry({ ids, value, take, decimal: is_decimal = false }: { ids: object; value: string; take: (text: string) => void; decimal?: boolean }) {
  const [text, set_text] = useState(value);
  useEffect(() => set_text(value), [value]);
  return (
    <input {...ids} type="text" inputMode={is_decimal ? 'decimal' : undefined} autoComplete="off" value={text}
      onInput={(event) => set_text(event.currentTarget.value)} onChange={(event) => take(event.currentTarget.value)} />
  );
}
