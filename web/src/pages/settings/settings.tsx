// SPDX-License-Identifier: Apache-2.0
import type { Signal } from '@preact/signals';
import { health } from '../../api/session';
import { Field } from '../../components/field';
import { language_choices } from '../../i18n/languages';
import { bytes, count } from '../../numbers';
import { actor, decimal, due_months, language, theme } from '../../settings';
import { sign_out } from '../../sign_out';
import './settings.css';
import { t } from './texts';

/** What one chooses for this browser, what the keys do, and what this program is. */
export function SettingsPage() {
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <div class="row">
          <a class="button" href="/audit">{t('audit')}</a>
          {health.value?.token && <button type="button" onClick={() => void sign_out()}>{t('sign_out')}</button>}
        </div>
      </div>
      <div class="settings-columns">
        <Choices />
        <Keyboard />
        <About />
      </div>
    </>
  );
}

function Choice<T extends string>({ label, value, options }: { label: string; value: Signal<T>; options: readonly (readonly [T, string])[] }) {
  return (
    <Field label={label}>
      {(ids) => (
        <select {...ids} value={value.value} onChange={(event) => { value.value = event.currentTarget.value as T; }}>
          {options.map(([key, text]) => <option key={key} value={key}>{text}</option>)}
        </select>
      )}
    </Field>
  );
}

function Choices() {
  return (
    <section class="panel">
      <h2>{t('here')} <span class="quiet small">{t('here_more')}</span></h2>
      <div class="choices">
        <Choice label={t('language')} value={language} options={language_choices} />
        <Choice label={t('decimal')} value={decimal} options={[['point', t('point')], ['comma', t('comma')]]} />
        <Choice label={t('theme')} value={theme} options={[['system', t('system')], ['light', t('light')], ['dark', t('dark')]]} />
        <Choice
          label={t('due')} value={due_months}
          options={['3', '6', '12', '18', '24', '36', '0'].map((n) => [n, n === '0' ? t('never') : t('months', { n })] as const)}
        />
        <Field label={t('actor')} hint={t('actor_hint')}>
          {(ids) => <input {...ids} autoComplete="name" maxLength={80} value={actor.value} onInput={(event) => { actor.value = event.currentTarget.value; }} />}
        </Field>
      </div>
    </section>
  );
}

function Keyboard() {
  const rows = [
    ['/', t('key_search')], ['Tab', t('key_tab')], ['←  →', t('key_arrows')], ['↑  ↓', t('key_series')], ['+  −  0', t('key_zoom')],
    [t('ctrl_wheel'), t('key_wheel')], ['Enter', t('key_open')], ['Esc', t('key_escape')],
  ];
  return (
    <section class="panel">
      <h2>{t('keyboard')}</h2>
      <table class="keys">
        <tbody>{rows.map(([key, what]) => <tr key={key}><th scope="row"><kbd>{key}</kbd></th><td>{what}</td></tr>)}</tbody>
      </table>
    </section>
  );
}

function About() {
  const now = health.value;
  if (!now) return null;
  const { counts } = now.store;
  const numbers = Object.fromEntries(Object.entries(counts).map(([key, n]) => [key, count(n)]));
  return (
    <section class="panel">
      <h2>{t('about')}</h2>
      <dl class="about">
        <dt>{t('version')}</dt><dd>Axiometry {now.program.version}</dd>
        <dt>{t('store')}</dt><dd>{now.store.kind === 'sqlite' ? 'SQLite' : 'PostgreSQL'}, {now.store.location}</dd>
        <dt>{t('schema')}</dt><dd class="number">{now.store.schema}</dd>
        <dt>{t('contents')}</dt><dd>{t('counted', { ...numbers, size: bytes(counts.content_bytes) })}</dd>
        <dt>{t('upload')}</dt><dd>{bytes(now.limits.upload_bytes)}</dd>
        <dt>{t('licence')}</dt><dd>{t('licence_text')} <a href="/licenses.txt" target="_blank" rel="noopener">{t('licence_link')}</a></dd>
        <dt>{t('api')}</dt><dd><a href="/api/openapi.json" target="_blank" rel="noopener">OpenAPI</a></dd>
      </dl>
    </section>
  );
}
