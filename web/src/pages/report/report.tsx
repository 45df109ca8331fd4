// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, query, send } from '../../api/client';
import { why_read_only } from '../../api/session';
import { use_get } from '../../api/use';
import type { Document, Test, Vocabulary } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { Withdrawn } from '../../components/withdrawn';
import { language_choices } from '../../i18n/languages';
import { bytes, when } from '../../numbers';
import { place } from '../../router';
import { decimal, language, type Decimal, type Language } from '../../settings';
import { t, units } from './texts';
import './report.css';
import { colon } from '../../i18n/colon';

/** What is mostly wanted comes first. */
const usual = ['pdf', 'html', 'csv', 'svg', 'png'];
const rank = (extension: string): number => (usual.includes(extension) ? usual.indexOf(extension) : usual.length);

interface Choice { language: Language; decimal: Decimal; unit: string }

/** The report of one version of a test: as it will look, in every format, and what has been issued. */
export function ReportPage({ parts }: { parts: Record<string, string> }) {
  const id = parts['id'] ?? '';
  const version = place.value.query.get('version');
  const test = use_get<Test>(`/api/tests/${id}${query({ version })}`);
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const [choice, set_choice] = useState<Choice>({ language: language.value, decimal: decimal.value, unit: '' });
  const shown = test.data;
  if (!shown) return <><h1 tabIndex={-1}>{t('report')}</h1>{test.error && <FailureNotice error={test.error} retry={test.reload} />}</>;
  const asked = { version: shown.version, language: choice.language, decimal: choice.decimal, unit: choice.unit };
  const path = (extension: string, download: boolean) =>
    `/api/tests/${id}/report.${extension}${query({ ...asked, download: download ? 1 : null })}`;
  const writers = [...(vocabulary.data?.writers ?? [])].sort((a, b) => rank(a.extension) - rank(b.extension));
  return (
    <>
      <header class="page-head">
        <div>
          <h1 tabIndex={-1}>{t('report')}{colon()} {shown.title} <Withdrawn test={shown} /></h1>
          <p class="crumb">
            <a href={`/tests/${id}`}>{t('to_test')}</a> · {t('version')} {shown.version}
            {shown.version !== shown.latest && ` (${t('not_latest', { n: shown.latest })})`}
          </p>
        </div>
        <a class="button no-print" href={path('html', false)} target="_blank" rel="noopener">{t('print')}</a>
      </header>
      {test.error && <FailureNotice error={test.error} retry={test.reload} />}
      {vocabulary.error && <FailureNotice error={vocabulary.error} retry={vocabulary.reload} />}
      <div class="report-page">
        <div class="stack no-print">
          <section class="panel report-choices" aria-labelledby="choices">
            <h2 id="choices">{t('appearance')}</h2>
            <Choices choice={choice} change={set_choice} unit={shown.result.unit} />
          </section>
          <section class="panel" aria-labelledby="downloads">
            <h2 id="downloads">{t('download')}</h2>
            <ul class="downloads">
              {writers.map(({ extension, title }) => (
                <Download key={extension} href={path(extension, true)} title={title} extension={extension} />
              ))}
              {!writers.some(({ extension }) => extension === 'json') && <Download href={path('json', true)} title={t('as_json')} extension="json" />}
              <Download href={`/api/tests/${id}/raw`} title={t('raw')} extension={shown.file.name} />
            </ul>
          </section>
          <Issued test={shown} choice={choice} writers={writers} writable={why_read_only() === null && !shown.withdrawn} reload={test.reload} />
        </div>
        <section class="preview" aria-label={t('preview')}>
          {/* Nothing in a report may run: the frame allows nothing at all. */}
          <iframe title={t('preview')} src={path('html', false)} sandbox="" />
        </section>
      </div>
    </>
  );
}

function Choices({ choice, change, unit }: { choice: Choice; change: (choice: Choice) => void; unit: 'um' | 'arcsec' }) {
  const row = <K extends keyof Choice>(key: K, label: string, all: readonly (readonly [Choice[K], string])[]) => (
    <Field label={label}>
      {(ids) => (
        <select {...ids} value={choice[key]} onChange={(event) => change({ ...choice, [key]: event.currentTarget.value })}>
          {all.map(([value, title]) => <option key={value} value={value}>{title}</option>)}
        </select>
      )}
    </Field>
  );
  return (
    <>
      {row('language', t('language'), language_choices)}
      {row('decimal', t('decimal'), [['point', t('point')], ['comma', t('comma')]])}
      {row('unit', t('unit'), [['', units(unit)], ...(unit === 'um' ? (['mm', 'nm'] as const) : (['deg'] as const)).map((one) => [one, units(one)] as const)])}
    </>
  );
}

function Download({ href, title, extension }: { href: string; title: string; extension: string }) {
  return (
    <li>
      <a href={href} download>{title}</a> <span class="quiet small mono">{extension}</span>
    </li>
  );
}

/** Issued reports stay as they are for good; a later version of the test gets its own. */
function Issued({ test, choice, writers, writable, reload }:
  { test: Test; choice: Choice; writers: Vocabulary['writers']; writable: boolean; reload: () => void }) {
  const [extension, set_extension] = useState('pdf');
  const [busy, set_busy] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  const [said, set_said] = useState('');
  const issued = test.documents.filter(({ kind }) => kind === 'report');
  const issue = () => {
    set_busy(true);
    set_error(null);
    send<Document>('POST', `/api/tests/${test.id}/reports`, { extension, version: test.version, ...choice, unit: choice.unit === '' ? null : choice.unit }).then(
      (document) => {
        set_busy(false);
        set_said(t('now_issued', { name: document.name }));
        reload();
      },
      (failure: unknown) => {
        set_busy(false);
        set_error(as_error(failure));
      },
    );
  };
  return (
    <section class="panel" aria-labelledby="issued">
      <h2 id="issued">{t('issued')}</h2>
      <p class="quiet small">{t('issue_what')}</p>
      <div class="row">
        <select aria-label={t('format')} value={extension} onChange={(event) => set_extension(event.currentTarget.value)}>
          {(writers.length > 0 ? writers : [{ extension: 'pdf', title: 'PDF' }]).map((one) => (
            <option key={one.extension} value={one.extension}>{one.extension.toUpperCase()}</option>
          ))}
        </select>
        <button type="button" class="primary" disabled={busy || !writable} onClick={issue}>{t(busy ? 'issuing' : 'issue')}</button>
        {!writable && <span class="quiet small">{t('read_only')}</span>}
      </div>
      <p class="visually-hidden" role="status">{said}</p>
      {error && <FailureNotice error={error} retry={issue} />}
      {issued.length === 0 ? <p class="quiet issued-none">{t('none_issued')}</p> : (
        <ul class="issued">
          {issued.map((document) => (
            <li key={document.id}>
              <a href={`/api/documents/${document.id}`} target="_blank" rel="noopener">{document.name}</a>
              <span class="quiet small">
                {' '}{t('version')} {document.version} · {when(document.change.at)}
                {document.change.actor !== '' && ` · ${document.change.actor}`} · {bytes(document.size)}
              </span>
              <span class="quiet small mono hash">SHA-256 {document.sha256}</span>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
