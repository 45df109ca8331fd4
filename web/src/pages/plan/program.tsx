// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { offer } from '../../api/client';
import { as_text, use_posted } from '../../api/posted';
import type { Vocabulary } from '../../api/types';
import { CopyButton } from '../../components/copy';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { Listing, line_count } from '../../components/listing';
import { Markdown } from '../../components/markdown';
import { t } from './texts';

interface Options {
  inch: boolean; unrolled: boolean; block_numbers: boolean; stop_at_start: boolean; stop_at_lines: boolean;
  trigger: string; number: string; decimals: string; frame: 'active' | 'machine' | 'offset'; offset: string; rollover: boolean;
}
const usual: Options = {
  inch: false, unrolled: false, block_numbers: true, stop_at_start: false, stop_at_lines: false, trigger: '', number: '', decimals: '4',
  frame: 'active', offset: 'G54', rollover: false,
};

/** For controls whose file names know only letters of English: "Fräse X" becomes "Fraese-X". */
const plain_name = (name: string): string =>
  name.replace(/[äöüÄÖÜ]/g, '$&e').replaceAll('ß', 'ss').normalize('NFD').replace(/\p{Mn}/gu, '').replace(/[^\w.-]+/g, '-').replace(/^-+|-+$/g, '');

/** What the API takes: members that are left as they are usual are not sent. */
function sent(options: Options, of_lines: boolean, rotary: boolean): Record<string, unknown> {
  const whole = (text: string) => (/^\d+$/.test(text.trim()) ? Number(text) : text.trim());
  return {
    unit: options.inch ? 'inch' : 'mm', unrolled: options.unrolled, block_numbers: options.block_numbers,
    stop_at_start: options.stop_at_start, ...(of_lines ? { stop_at_lines: options.stop_at_lines } : {}), decimals: whole(options.decimals === '' ? usual.decimals : options.decimals),
    frame: options.frame === 'offset' ? options.offset.trim() : options.frame,
    ...(rotary ? { rollover: options.rollover } : {}),
    ...(options.trigger === '' ? {} : { trigger_m_code: whole(options.trigger) }),
    ...(options.number === '' ? {} : { number: whole(options.number) }),
  };
}

interface Props {
  path: string;
  subject: Record<string, unknown> | null;  // the request or the plan; null: there is none yet
  part?: number;                            // which test of a plan of several
  of_lines?: boolean;                       // lines in space, before each of which the program may stop
  stops?: boolean;                          // and does so in any case: an interferometer is aligned with each
  rotary?: boolean;                         // of a rotary axis, which may have rollover
  name: string;
  vocabulary: Vocabulary;
  step?: string;                            // of a way of several
  choice?: ComponentChildren;               // of the part, before the control
}

/** The part program of the plan as it stands in the form, saved or not. */
export function ProgramPanel({ path, subject, part = 1, of_lines = false, stops = false, rotary = false, name, vocabulary, step, choice }: Props) {
  const dialects = useMemo(() => most_used_first(vocabulary.dialects), [vocabulary]);
  const [dialect, set_dialect] = useState(() => kept_dialect(dialects));
  const [options, set_options] = useState(usual);
  const chosen = vocabulary.dialects.find(({ id }) => id === dialect);
  const body = subject === null ? null : { ...subject, dialect, options: { ...sent(options, of_lines, rotary), ...(of_lines ? {} : { part }) } };
  const program = use_posted(path, body, as_text);
  // What was made for another control or plan must not be taken along under the name of this one.
  const is_this = program.error === null && program.data !== null && JSON.stringify(program.of) === JSON.stringify(body);
  const file = `${plain_name(`${name}${part > 1 ? `-${part}` : ''}`) || 'plan'}${chosen?.extension ?? '.nc'}`;
  const choose = (id: string) => {
    set_dialect(id);
    keep_dialect(id);
  };
  return (
    <section class="panel program" aria-labelledby="program-title">
      <header>
        <h2 id="program-title">{step && <span class="step">{step}</span>}{t('program')}<span class="only-print">: {chosen?.title}</span></h2>
        <div class="row no-print">
          <CopyButton text={() => program.data ?? ''} disabled={!is_this} />
          <button type="button" disabled={!is_this}
            onClick={() => offer(new Blob([program.data ?? ''], { type: 'text/plain' }), file)}>
            {t('download')} <span class="quiet">{file}</span>
          </button>
        </div>
      </header>
      <div class="options no-print">
        <Field label={t('control')}>
          {(ids) => (
            <select {...ids} value={dialect} onChange={(event) => choose(event.currentTarget.value)}>
              {dialects.map(({ id, title }) => <option key={id} value={id}>{title}</option>)}
            </select>
          )}
        </Field>
        {choice}
        <OptionFields of_lines={of_lines && !stops} rotary={rotary} options={options} change={(part) => set_options({ ...options, ...part })} loops={chosen?.has_loops ?? true} />
      </div>
      {program.error && <FailureNotice error={program.error} retry={program.again} />}
      {program.data !== null && <ProgramText text={program.data} stale={program.error !== null} />}
      {chosen && chosen.manual !== '' && (
        <details class="no-print">
          <summary>{t('manual')}</summary>
          <div class="manual" lang="en"><Markdown source={chosen.manual} /></div>
        </details>
      )}
    </section>
  );
}

interface FieldsProps { options: Options; change: (part: Partial<Options>) => void; loops: boolean; of_lines: boolean; rotary: boolean }

function OptionFields({ options, change, loops, of_lines, rotary }: FieldsProps) {
  const text = (key: 'trigger' | 'number' | 'decimals', label: string) => (
    <Field label={label}>
      {(ids) => (
        <input {...ids} class="number short" inputMode="numeric" autocomplete="off" value={options[key]}
          placeholder={key === 'decimals' ? usual.decimals : t('none')} onInput={(event) => change({ [key]: event.currentTarget.value })} />
      )}
    </Field>
  );
  const box = (key: 'inch' | 'unrolled' | 'block_numbers' | 'stop_at_start' | 'stop_at_lines' | 'rollover', disabled = false) => (
    <label>
      <input type="checkbox" checked={options[key]} disabled={disabled} onChange={(event) => change({ [key]: event.currentTarget.checked })} />
      {t(key)}
    </label>
  );
  return (
    <>
      {text('trigger', t('trigger'))}
      {text('number', t('number'))}
      {text('decimals', t('decimals'))}
      <Field label={t('frame')}>
        {(ids) => (
          <select {...ids} value={options.frame} onChange={(event) => change({ frame: event.currentTarget.value as Options['frame'] })}>
            <option value="active">{t('frame_active')}</option>
            <option value="machine">{t('frame_machine')}</option>
            <option value="offset">{t('frame_offset')}</option>
          </select>
        )}
      </Field>
      {options.frame === 'offset' && (
        <Field label={t('frame_offset')}>
          {(ids) => (
            <input {...ids} class="short" autocomplete="off" value={options.offset} placeholder={usual.offset}
              onInput={(event) => change({ offset: event.currentTarget.value })} />
          )}
        </Field>
      )}
      <div class="boxes">
        {box('inch')}
        {box('unrolled', !loops)}
        {box('block_numbers')}
        {box('stop_at_start')}
        {of_lines && box('stop_at_lines')}
        {rotary && box('rollover')}
      </div>
    </>
  );
}

function ProgramText({ text, stale }: { text: string; stale: boolean }) {
  return (
    <>
      <Listing text={text} label={t('program_text')} stale={stale} />
      <p class="quiet small">{t('lines', { n: line_count(text) })}</p>
    </>
  );
}

/** The controls that most machines have, then the others by their names. */
function most_used_first(dialects: Vocabulary['dialects']): Vocabulary['dialects'] {
  const most_used = ['siemens-840d', 'heidenhain', 'fanuc', 'linuxcnc'];
  const rank = (id: string) => (most_used.includes(id) ? most_used.indexOf(id) : most_used.length);
  return [...dialects].sort((a, b) => rank(a.id) - rank(b.id) || a.title.localeCompare(b.title));
}

// A workshop has mostly one control: the one chosen last is the first next time.
const key = 'axiometry.dialect';
function kept_dialect(dialects: Vocabulary['dialects']): string {
  let kept: string | null = null;
  try {
    kept = localStorage.getItem(key);
  } catch {
    // a browser may forbid it
  }
  return dialects.find(({ id }) => id === kept)?.id ?? dialects[0]?.id ?? '';
}
function keep_dialect(id: string): void {
  try {
    localStorage.setItem(key, id);
  } catch {
    // a browser may forbid it
  }
}
