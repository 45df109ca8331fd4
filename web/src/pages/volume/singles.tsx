// SPDX-License-Identifier: Apache-2.0
// Errors that were measured one by one: files, where the axes stood meanwhile, and the model that they make together.
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { ApiError, as_error, made_of_files, query } from '../../api/client';
import type { VolumetricAssembly, VolumetricMachine } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { use_settled } from '../../components/settled';
import { fixed } from '../../numbers';
import { decimal, language } from '../../settings';
import { AssemblyResult } from './assembly';
import { axes, kind_of, motions, squarenesses, type Axis } from './error_names';
import { t as t_result } from './result_texts';
import { error_names, errors_of, is_motion, new_singles, read_singles, unit_of, type SingleRow, type SinglesForm, type SinglesRead } from './singles_form';
import { t } from './singles_texts';
import { colon } from '../../i18n/colon';

const most_bytes = 7_500_000;  // of all files, as the server takes

/** What was sent, so that reports are of the same. */
export interface SentSingles { files: readonly File[]; machine: string; options: string }

export function singles_form_data({ files, machine, options }: SentSingles): FormData {
  const form = new FormData();
  form.append('options', options);
  form.append('machine', new File([machine], 'machine.json', { type: 'application/json' }), 'machine.json');
  for (const file of files) form.append('errors', file, file.name);
  return form;
}

async function assembled(sent: SentSingles, signal: AbortSignal): Promise<VolumetricAssembly> {
  const size = sent.files.reduce((sum, file) => sum + file.size, sent.machine.length);
  if (size > most_bytes) throw new ApiError('refused', t_result('too_large', { n: fixed(size / 1e6, 1), most: most_bytes / 1e6 }), 0);
  const answer = await made_of_files(`/api/volumetric/assembly${query({ decimal: decimal.value })}`, singles_form_data(sent), signal);
  return (await answer.json()) as VolumetricAssembly;
}

export function SinglesPanel({ machine }: { machine: VolumetricMachine | null }) {
  const [form, set_form] = useState<SinglesForm>(new_singles);
  const [error, set_error] = useState<ApiError | null>(null);
  const [busy, set_busy] = useState(false);
  const [made, set_made] = useState<{ sent: SentSingles; result: VolumetricAssembly } | null>(null);
  const next_key = useRef(0);
  const change = (part: Partial<SinglesForm>) => set_form((before) => ({ ...before, ...part }));
  const read = useMemo(() => read_singles(form, machine ?? { tools_mm: {}, travel_mm: { X: [0, 0], Y: [0, 0], Z: [0, 0] } }), [form, machine, language.value]);
  const asked = read.options && JSON.stringify(read.options);
  const text = machine && JSON.stringify(machine);
  const files = useMemo(() => [...new Set(form.rows.filter((row) => row.error !== '').map((row) => row.file))], [form.rows]);
  // All of it settles together: files and what is said of them belong to each other, and a file may take the place of another.
  const sent = use_settled(useMemo((): SentSingles | null => (text && asked ? { files, machine: text, options: asked } : null), [files, text, asked]));
  const spoken = language.value;
  useEffect(() => {
    set_error(null);
    if (!sent) { set_made(null); return undefined; }
    const abort = new AbortController();
    set_busy(true);
    assembled(sent, abort.signal).then(
      (result) => { if (!abort.signal.aborted) { set_made({ sent, result }); set_busy(false); } },
      (thrown: unknown) => {
        if (abort.signal.aborted) return;
        set_made(null);
        set_error(as_error(thrown));
        set_busy(false);
      },
    );
    return () => { abort.abort(); set_busy(false); };
  }, [sent, spoken]);
  // A file of a name that is there already takes the place of the other.
  const take = async (dropped: readonly File[]) => {
    const found: SingleRow[] = [];
    for (const file of dropped) {
      const errors = await errors_of(file);
      for (const name of errors.length > 0 ? errors : ['']) found.push({ key: next_key.current++, file, error: name, a: '', b: '' });
    }
    set_form((before) => ({ ...before, rows: [...before.rows.filter(({ file }) => !dropped.some(({ name }) => name === file.name)), ...found] }));
  };
  const change_row = (key: number, part: Partial<SingleRow>) => change({ rows: form.rows.map((row) => (row.key === key ? { ...row, ...part } : row)) });
  return (
    <>
      <section class="panel no-print singles" aria-labelledby="volume-singles">
        <header><h2 id="volume-singles">{t('singles')}</h2></header>
        <div class="tracking-form">
          <p class="hint">{t('how')}</p>
          <FileDrop label={t('choose')} hint={t('drop')} take={{ all: (dropped) => void take(dropped) }} />
          {form.rows.length > 0 && (
            <fieldset class="triple singles-files">
              <legend>{t('files')}</legend>
              <p class="hint">{t('instrument_hint')}</p>
              {form.rows.map((row) => (
                <FileRow key={row.key} row={row} faults={read.faults} change={(part) => change_row(row.key, part)}
                  remove={() => change({ rows: form.rows.filter(({ key }) => key !== row.key) })}
                  also={() => change({ rows: form.rows.flatMap((one) => (one.key === row.key ? [one, { key: next_key.current++, file: row.file, error: '', a: '', b: '' }] : [one])) })} />
              ))}
            </fieldset>
          )}
          <Squares form={form} change={change} faults={read.faults} />
          {axes.filter((axis) => [...read.given].some((name) => is_motion(name) && name.endsWith(axis)))
            .map((axis) => <StandFields key={axis} axis={axis} {...{ form, change, machine }} faults={read.faults} />)}
          {read.given.size > 0 && (
            <Field label={t('reversal')}>
              {(ids) => (
                <select {...ids} value={form.reversal} onChange={(event) => change({ reversal: event.currentTarget.value === 'none' ? 'none' : 'curves' })}>
                  <option value="curves">{t('curves')}</option>
                  <option value="none">{t('none')}</option>
                </select>
              )}
            </Field>
          )}
          {read.given.size > 0 && <Matched given={read.given} />}
          {read.given.size > 0 && machine === null && <p class="notice caution">{t('no_machine')}</p>}
        </div>
        {busy && <p class="quiet" role="status">{t('assembling')}</p>}
        {error && <FailureNotice error={error} />}
      </section>
      {made && <AssemblyResult result={made.result} sent={made.sent} />}
    </>
  );
}

type Faults = SinglesRead['faults'];

function FileRow({ row, faults, change, remove, also }: { row: SingleRow; faults: Faults; change: (part: Partial<SingleRow>) => void; remove: () => void; also: () => void }) {
  const { key, file, error, a, b } = row;
  const unit = unit_of(error);
  const number = (of: 'a' | 'b', label: string, value: string) => (
    <Field label={label} fault={faults[`${of}.${key}`] ?? null}>
      {(ids) => <input {...ids} class="number" inputMode="decimal" autocomplete="off" value={value} onInput={(event) => change({ [of]: event.currentTarget.value })} />}
    </Field>
  );
  return (
    <div class="obstacle" role="group" aria-label={file.name}>
      <div class="single-file">
        <span class="mono small">{file.name}</span>
        <span class="row">
          <button type="button" class="plain small" aria-label={`${t('also')}${colon()} ${file.name}`} onClick={also}>{t('also')}</button>
          <button type="button" class="plain small" aria-label={`${t('remove')}${colon()} ${error} ${file.name}`} onClick={remove}>{t('remove')}</button>
        </span>
      </div>
      <div class="single-fields">
        <Field label={t('error_of', { file: file.name })} fault={faults[`row.${key}`] ?? null}>
          {(ids) => (
            <select {...ids} value={error} onChange={(event) => change({ error: event.currentTarget.value })}>
              <option value="">{t('choose_error')}</option>
              {motions.map((motion) => <option key={motion.name} value={motion.name}>{motion.name} · {kind_of(motion)}</option>)}
              {squarenesses.map(([name, one, other]) => <option key={name} value={name}>{name} · {t_result('squareness_of', { a: one, b: other })}</option>)}
            </select>
          )}
        </Field>
        {is_motion(error) && number('a', t('instrument_a', { name: error, unit }), a)}
        {is_motion(error) && number('b', t('instrument_b', { unit: `${unit}/m` }), b)}
      </div>
    </div>
  );
}

interface PartProps { form: SinglesForm; change: (part: Partial<SinglesForm>) => void; faults: Faults }

function Squares({ form: { squares }, change, faults }: PartProps) {
  const field = (name: string, of: 'value' | 'U', label: string) => (
    <Field label={label} fault={faults[`${of}.${name}`] ?? null}>
      {(ids) => (
        <input {...ids} class="number" inputMode="text" autocomplete="off" value={squares[name]?.[of] ?? ''}
          onInput={(event) => change({ squares: { ...squares, [name]: { value: '', U: '', ...squares[name], [of]: event.currentTarget.value } } })} />
      )}
    </Field>
  );
  const filled = Object.values(squares).some(({ value, U }) => value !== '' || U !== '');
  return (
    <details class="more" open={filled || undefined}>
      <summary>{t('squareness_as')}</summary>
      <div class="tracking-form">
        <p class="hint">{t('squareness_hint')}</p>
        {squarenesses.map(([name]) => (
          <div key={name} class="pair">{field(name, 'value', t('value_of', { name }))}{field(name, 'U', t('U_of', { name }))}</div>
        ))}
      </div>
    </details>
  );
}

function StandFields({ axis, form, change, faults, machine }: PartProps & { axis: Axis; machine: VolumetricMachine | null }) {
  const stand = form.stands[axis];
  const set = (part: Partial<typeof stand>) => change({ stands: { ...form.stands, [axis]: { ...stand, ...part } } });
  const replaced = <T,>(list: readonly T[], at: number, value: T): T[] => list.map((one, k) => (k === at ? value : one));
  const tools = Object.keys(machine?.tools_mm ?? {});
  return (
    <fieldset class="triple stand">
      <legend>{t('stand', { axis })}</legend>
      <p class="hint">{t('stand_hint')}</p>
      <div class="stand-fields">
        {axes.map((other, k) => other !== axis && (
          <>
            <Field key={`${other}-at`} label={t('stood_at', { axis: other })} fault={faults[`stand.${axis}.${k}`] ?? null}>
              {(ids) => <input {...ids} class="number" inputMode="text" autocomplete="off" value={stand.at[k]} onInput={(event) => set({ at: replaced(stand.at, k, event.currentTarget.value) })} />}
            </Field>
            <Field key={`${other}-came`} label={t('came', { axis: other })}>
              {(ids) => (
                <select {...ids} value={stand.came[k]} onChange={(event) => set({ came: replaced(stand.came, k, event.currentTarget.value as '' | 'up' | 'down') })}>
                  <option value="">{t('not_stated')}</option>
                  <option value="up">{t('up')}</option>
                  <option value="down">{t('down')}</option>
                </select>
              )}
            </Field>
          </>
        ))}
        {tools.length > 1 && (
          <Field label={t('tool')}>
            {(ids) => <select {...ids} value={tools.includes(stand.tool) ? stand.tool : tools[0]} onChange={(event) => set({ tool: event.currentTarget.value })}>{tools.map((name) => <option key={name} value={name}>{name}</option>)}</select>}
          </Field>
        )}
      </div>
    </fieldset>
  );
}

/** Which of the 21 are there, by axis. */
function Matched({ given }: { given: ReadonlySet<string> }) {
  const row = (names: readonly string[]) => names.map((name) => (
    <li key={name} class={given.has(name) ? 'there' : 'absent'}>
      <span aria-hidden="true">{given.has(name) ? '✓' : '–'}</span> {name} <span class="visually-hidden">{t(given.has(name) ? 'given' : 'missing')}</span>
    </li>
  ));
  return (
    <section class="matched" aria-label={t('matched')}>
      <h3>{t('matched')} <span class="quiet small">{t('told', { n: error_names.filter((name) => given.has(name)).length })}</span></h3>
      <dl>
        {axes.map((axis) => (
          <div key={axis}><dt>{t('of_axis', { axis })}</dt><dd><ul>{row(motions.filter((motion) => motion.axis === axis).map(({ name }) => name))}</ul></dd></div>
        ))}
        <div><dt>{t('squareness')}</dt><dd><ul>{row(squarenesses.map(([name]) => name))}</ul></dd></div>
      </dl>
    </section>
  );
}
