// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from 'preact/hooks';
import { offer } from '../../api/client';
import type { AskedTable, ImportProfile } from '../../api/types';
import { sentence } from '../../components/findings';
import { Field } from '../../components/field';
import { as_said_of, direction_rules, has, meaning_of, meanings, open_in, readings_of, same_columns, with_meaning, with_rule, type Open } from './columns';
import { incoming, is_asked, read_by, type Incoming } from './incoming';
import { t } from './texts';

const units: Record<'linear' | 'rotary', Record<string, string>> = {
  linear: { mm: 'mm', um: 'µm', nm: 'nm', m: 'm', in: 'in', uin: 'µin' },
  rotary: { deg: '°', arcsec: '″', mdeg: 'm°', rad: 'rad', mrad: 'mrad', urad: 'µrad' },
};

/** How a table of unknown make is read, and the way to say it otherwise; open where something has to be said. */
export function HowRead({ one, table }: { one: Incoming; table: AskedTable }) {
  const refused = one.preview?.refused != null;
  const due = refused && (is_asked(one) || one.profile !== null);
  const [wish, set_wish] = useState({ of: one.preview, open: due });  // holds until the file is read again
  const open = wish.of === one.preview ? wish.open : due;
  const set_open = (to: boolean) => set_wish({ of: one.preview, open: to });
  const change = useRef<HTMLButtonElement>(null);
  const was_open = useRef(open);
  useEffect(() => {
    if (was_open.current && !open) change.current?.focus();  // what had the focus is gone
    was_open.current = open;
  }, [open]);
  if (open) return <AskedColumns one={one} table={table} on_close={due ? null : () => set_open(false)} />;
  return (
    <p class="how-read quiet small">
      {!refused && <>{t(one.profile ? 'columns_as_said' : 'columns_guessed')} </>}
      <button ref={change} type="button" class="link small" onClick={() => set_open(true)}>{t(refused ? 'columns_say' : 'columns_change')}</button>
      {!refused && <> <DownloadProfile one={one} profile={table.profile} /></>}
    </p>
  );
}

/** For the command line, which reads the next files of the instrument by it. */
function DownloadProfile({ one, profile }: { one: Incoming; profile: ImportProfile }) {
  const name = `${one.file.name.replace(/\.[^.]*$/, '')}-profile.json`;
  const text = `${JSON.stringify(profile, null, 2)}\n`;
  return <button type="button" class="link small" onClick={() => offer(new Blob([text], { type: 'application/json' }), name)}>{t('profile_download')}</button>;
}

/** The first rows with what each column means, and what else has to be known to read them. */
function AskedColumns({ one, table, on_close }: { one: Incoming; table: AskedTable; on_close: (() => void) | null }) {
  const [said, set_said] = useState({ of: table, profile: table.profile });
  const profile = said.of === table ? said.profile : table.profile;
  const set_profile = (to: ImportProfile) => set_said({ of: table, profile: to });
  const open = open_in(profile);
  const busy = one.state === 'reading' || one.state === 'keeping';
  const like = incoming.value.find((other) => other.key !== one.key && other.profile !== null && other.preview?.refused === null && same_columns(other.profile, table.profile));
  return (
    <form class="asked" aria-label={t('columns_of', { name: one.file.name })} onSubmit={(event) => { event.preventDefault(); if (open.length === 0 && !busy) read_by(one.key, profile); }}>
      {one.profile === null && table.questions.length > 0 && (
        <div class="notice caution">
          <p><strong>{t('questions')}</strong></p>
          <ul>{table.questions.map((question, i) => <li key={i}>{question.key === 'direction' ? t('rule_question') : sentence(question.text)}</li>)}</ul>
        </div>
      )}
      <Rows file={one.file.name} table={table} profile={profile} on_meaning={(c, meaning) => set_profile(with_meaning(profile, c, meaning, table.rows.map((row) => row[c] ?? '')))} />
      <Answers table={table} profile={profile} open={open} on_change={(to) => set_profile({ ...profile, ...to })} />
      <div class="row">
        <button type="submit" class="primary" disabled={open.length > 0 || busy}>{t('columns_preview')}</button>
        {like?.profile && <button type="button" disabled={busy} onClick={() => like.profile && read_by(one.key, as_said_of(like.profile, table.profile))}>{t('columns_like', { name: like.file.name })}</button>}
        {on_close && <button type="button" class="plain" onClick={on_close}>{t('columns_close')}</button>}
        <span class="quiet small" aria-live="polite">{open.length > 0 && t('still_open', { list: open.map((key) => t(`open_${key}`)).join(', ') })}</span>
        <span class="end"><DownloadProfile one={one} profile={profile} /></span>
      </div>
    </form>
  );
}

function Rows({ file, table, profile, on_meaning }: { file: string; table: AskedTable; profile: ImportProfile; on_meaning: (c: number, meaning: string) => void }) {
  const width = Math.max(profile.columns.length, ...table.rows.map((row) => row.length));
  const across = profile.layout === 'transposed';
  return (
    <div class="table-frame" tabIndex={0} role="region" aria-label={t('first_rows', { name: file })}>
      <table>
        <thead>
          <tr>
            {profile.columns.map((column, c) => {
              const rest = across && c === profile.columns.length - 1;
              const head = rest ? t('columns_rest') : table.names[c] || t('column', { n: c + 1 });
              return (
                <th key={c} scope="col" colSpan={rest ? width - c : 1}>
                  <div class={rest ? 'rest' : 'name'} title={head}>{head}</div>
                  <select class={column.role === 'ignore' ? 'quiet' : ''} aria-label={head} value={meaning_of(column)} onChange={(event) => on_meaning(c, event.currentTarget.value)}>
                    {meanings(profile, c).map((meaning) => <option key={meaning} value={meaning}>{meaning_text(meaning)}</option>)}
                  </select>
                </th>
              );
            })}
          </tr>
        </thead>
        <tbody>
          {table.rows.map((row, r) => (
            <tr key={r} class={across && r === 0 ? 'targets' : undefined}>
              {Array.from({ length: width }, (_, c) => (
                <td key={c} class={profile.columns[Math.min(c, profile.columns.length - 1)]?.role === 'ignore' ? 'quiet' : undefined}>{row[c] ?? ''}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function meaning_text(meaning: string): string {
  const [role, direction] = meaning.split('/') as ['target', string | undefined];
  return `${t(`role_${role}`)}${direction ? (direction === 'up' ? ' ↑' : ' ↓') : ''}`;
}

function Answers({ table, profile, open, on_change }: {
  table: AskedTable; profile: ImportProfile; open: readonly Open[]; on_change: (to: Partial<ImportProfile>) => void;
}) {
  const rule = profile.direction;
  const words = unknown_words(table, profile);
  const by_column = readings_of(profile).length > 0 && readings_of(profile).every((column) => column.unit);
  return (
    <div class="answers">
      <UnitOf label={t('unit_targets')} value={profile.target_unit} open={open.includes('target_unit')} beside={by_column ? null : profile.reading_unit} on_change={(target_unit) => on_change({ target_unit })} />
      {!by_column && <UnitOf label={t('unit_readings')} value={profile.reading_unit} open={open.includes('reading_unit')} beside={profile.target_unit} on_change={(reading_unit) => on_change({ reading_unit })} />}
      <Choice label={t('rule')} value={rule ?? ''} options={['', ...direction_rules(profile)].map((value) => [value, value === '' ? t('choose_one') : t(`rule_${value as 'up'}`)])}
        on_change={(value) => on_change(with_rule(profile, (value || null) as ImportProfile['direction']))} />
      {(rule === 'visits' || rule === 'run-parity') && (
        <Choice label={t('rule_first')} value={profile.first_direction} options={[['up', '↑'], ['down', '↓']]} on_change={(value) => on_change({ first_direction: value as 'up' })} />
      )}
      {words && (['up_words', 'down_words'] as const).map((key) => (
        <Field key={key} label={t(key)} hint={t('words_here', { list: words.join(', ') })}>
          {(ids) => <input {...ids} value={profile[key].join(', ')} onChange={(event) => on_change({ [key]: event.currentTarget.value.split(',').map((word) => word.trim()).filter(Boolean) })} />}
        </Field>
      ))}
      {has(profile, 'deviation') && (
        <Choice label={t('sign')} value={String(profile.sign)} options={[['1', t('sign_measured')], ['-1', t('sign_target')]]} on_change={(value) => on_change({ sign: value === '1' ? 1 : -1 })} />
      )}
      <Choice label={t('decimal_mark')} value={profile.decimal_mark} options={[['point', t('mark_point')], ['comma', t('mark_comma')]]} on_change={(value) => on_change({ decimal_mark: value as 'point' })} />
    </div>
  );
}

/** The words in a column of directions that are not known to say one; null where they are. */
function unknown_words(table: AskedTable, profile: ImportProfile): string[] | null {
  const c = profile.columns.findIndex((column) => column.role === 'direction');
  const known = table.profile.columns[c]?.role === 'direction' && !table.questions.some(({ key }) => key === 'up_words');
  if (c < 0 || (known && profile.up_words.length + profile.down_words.length === 0)) return null;
  return [...new Set(table.rows.map((row) => row[c] ?? ''))].filter(Boolean).slice(0, 5);
}

function Choice({ label, value, options, on_change }: { label: string; value: string; options: readonly (readonly [string, string])[]; on_change: (value: string) => void }) {
  return (
    <Field label={label}>
      {(ids) => (
        <select {...ids} class={value === '' ? 'open' : ''} value={value} onChange={(event) => on_change(event.currentTarget.value)}>
          {options.map(([key, text]) => <option key={key} value={key}>{text}</option>)}
        </select>
      )}
    </Field>
  );
}

/** Units of the kind that `beside` has: a table is of an axis that moves straight, or of one that turns. */
type Unit = ImportProfile['target_unit'];

function UnitOf({ label, value, open, beside, on_change }: { label: string; value: Unit; open: boolean; beside: Unit; on_change: (unit: Unit) => void }) {
  const kinds = (['linear', 'rotary'] as const).filter((kind) => beside === null || beside in units[kind]);
  return (
    <Field label={label}>
      {(ids) => (
        <select {...ids} class={open ? 'open' : ''} value={value ?? ''} onChange={(event) => on_change((event.currentTarget.value || null) as Unit)}>
          <option value="">{t('choose_one')}</option>
          {kinds.map((kind) => <optgroup key={kind} label={t(kind)}>{Object.entries(units[kind]).map(([key, sign]) => <option key={key} value={key}>{sign}</option>)}</optgroup>)}
        </select>
      )}
    </Field>
  );
}
