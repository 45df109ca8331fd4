// SPDX-License-Identifier: Apache-2.0
// One table that was kept: the chain measured → table → measured again, what it did, and what may be done with it.
import { useMemo, useState } from 'preact/hooks';
import { query } from '../../api/client';
import { why_read_only } from '../../api/session';
import type { CompensatedControl, KeptCompensation, Test } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Hash } from '../../components/hash';
import { VersionList } from '../../components/versions';
import { absent, when } from '../../numbers';
import { place } from '../../router';
import { decimal, language } from '../../settings';
import './compensations.css';
import { AboutFormat, TableText } from './about';
import { Chain } from './chain';
import { MeansChart, TableChart } from './curves';
import { EditNotes, WithdrawTable } from './dialogs';
import { FigureTable } from './figures';
import { option_words } from './option_words';
import { RetestDialog } from './retest';
import { counting_result } from './standing';
import { t } from './texts';
import '../plan/plan.css';
import '../test/test.css';
import { test_path } from '../test/state';
import { VolumeFindings } from '../volume/findings';

type Doing = 'retest' | 'unlink' | 'notes' | 'withdraw' | null;

export function CompensationPage({ parts }: { parts: Record<string, string> }) {
  const version = place.value.query.get('version');
  const asked = use_get<KeptCompensation>(`/api/compensations/${encodeURIComponent(parts['id'] ?? '')}${query({ version, decimal: decimal.value })}`);
  const found = asked.data !== null && String(asked.data.id) === parts['id'] ? asked.data : null;
  if (asked.error && !found) return <><h1 tabIndex={-1}>{t('one_title')}</h1><FailureNotice error={asked.error} retry={asked.reload} /></>;
  if (!found) return <><h1 tabIndex={-1} class="visually-hidden">{t('one_title')}</h1><p class="slow quiet" role="status">{t('loading')}</p></>;
  return (
    <>
      {asked.error && <FailureNotice error={asked.error} retry={asked.reload} />}
      <Whole found={found} set={asked.set} />
    </>
  );
}

function Whole({ found, set }: { found: KeptCompensation; set: (found: KeptCompensation) => void }) {
  const [doing, set_doing] = useState<Doing>(null);
  const test = use_get<Test>(test_path(found.test.id, '', { version: found.test.version }));
  const retest = use_get<Test>(found.retest ? test_path(found.retest.id, '', { version: found.retest.version }) : null);
  const controls = use_get<CompensatedControl[]>('/api/controls');
  const latest = Math.max(...found.versions.map(({ version }) => version));
  const is_old = found.version !== latest || why_read_only() !== null;
  const is_fixed = is_old || found.withdrawn;
  const result = useMemo(() => counting_result(found), [found]);
  const again = found.retest !== null && retest.data?.id === found.retest.id ? retest.data : null;
  const means = useMemo(() => ({ before: result.before_means, predicted: result.predicted_means, ...(result.retest ? { retest: result.retest.means } : {}) }), [result]);
  const dialog = { found, on_done: set, on_close: () => set_doing(null) };
  const shown = test.data?.shown ?? [];
  const loading = controls.data?.find(({ id }) => id === found.control.id)?.loading ?? null;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/compensations">{t('title')}</a>{found.machine && <> / <a href={`/machines/${found.machine.id}`}>{found.machine.name}</a></>}{found.axis && <> / <a href={`/axes/${found.axis.id}`}>{t('axis', { axis: found.axis.name })}</a></>}</p>
          <h1 tabIndex={-1}>{t('heading', { id: found.id, control: found.control.title })}</h1>
        </div>
        <div class="row no-print">
          {(['pdf', 'html', 'json'] as const).map((extension) => <ReportLink key={extension} found={found} extension={extension} />)}
          <button type="button" disabled={is_old} onClick={() => set_doing('withdraw')}>{t(found.withdrawn ? 'reinstate' : 'withdraw')}</button>
          <button type="button" disabled={is_fixed} onClick={() => set_doing('notes')}>{t('edit_notes')}</button>
        </div>
      </div>
      {found.version !== latest && <p class="notice caution">{t('older', { n: found.version, latest })} <a href={`/compensations/${found.id}`}>{t('to_latest')}</a></p>}
      {found.withdrawn && <p class="notice caution">{t('is_withdrawn')}</p>}
      <Chain found={found} result={result} shown={shown} is_fixed={is_fixed} choose={() => set_doing('retest')} unlink={() => set_doing('unlink')} />
      <section class="panel flush table-results" aria-labelledby="table-result">
        <header><h2 id="table-result">{t(result.retest ? 'result_again' : 'result')}</h2></header>
        <div class="inset"><VolumeFindings findings={result.findings} /></div>
        <FigureTable result={result} test={test.data} retest={again} />
        {found.notes !== '' && <p class="notes inset">{found.notes}</p>}
      </section>
      <MeansChart means={means} shown={shown} kind={result.kind} unit={result.unit} />
      <TableChart table={result.table} existing={result.existing ?? null} kind={result.kind} unit={result.unit} />
      <TableText text={found.table} name={found.file_name} href={`/api/compensations/${found.id}/files/table`} />
      <section class="panel" aria-labelledby="table-format">
        <header><h2 id="table-format">{t('format')}</h2></header>
        <AboutFormat sign={result.sign} verified={result.verified} loading={loading} />
        <Files found={found} />
      </section>
      <Versions found={found} />
      {doing === 'notes' && <EditNotes {...dialog} />}
      {doing === 'withdraw' && <WithdrawTable {...dialog} />}
      {(doing === 'retest' || doing === 'unlink') && <RetestDialog {...dialog} unlink={doing === 'unlink'} />}
    </>
  );
}

function ReportLink({ found, extension }: { found: KeptCompensation; extension: string }) {
  const asked = query({ version: found.version, language: language.value, decimal: decimal.value, download: 1 });
  return <a class="button" href={`/api/compensations/${found.id}/report.${extension}${asked}`} download>{t('report')} {extension.toUpperCase()}</a>;
}

function Files({ found }: { found: KeptCompensation }) {
  return (
    <dl class="fact-grid table-files">
      <div><dt>{t('file')}</dt><dd><a href={`/api/compensations/${found.id}/files/table`} download={found.file_name}>{found.file_name}</a> <Hash hash={found.table_sha256} /></dd></div>
      <div>
        <dt>{t('existing')}</dt>
        <dd>{found.existing ? <><a href={`/api/compensations/${found.id}/files/existing`} download={found.existing.name}>{found.existing.name}</a> <Hash hash={found.existing.sha256} /></> : absent}</dd>
      </div>
      <div><dt>{t('made_by')}</dt><dd>{found.program}</dd></div>
      <div><dt>{t('made_at')}</dt><dd class="number">{when(found.made_at)}</dd></div>
      <div class="whole"><dt>{t('options')}</dt><dd><Options found={found} /></dd></div>
    </dl>
  );
}

/** Those that are not as usual. */
function Options({ found }: { found: KeptCompensation }) {
  const words = option_words(found.options, found.result.kind);
  return words.length === 0 ? <>{t('all_usual')}</> : <ul class="chosen-options">{words.map((line) => <li key={line}>{line}</li>)}</ul>;
}

function Versions({ found }: { found: KeptCompensation }) {
  return (
    <details class="panel history">
      <summary>{t('versions')} <span class="quiet small">({found.versions.length})</span></summary>
      <VersionList
        versions={found.versions.map((one) => ({ ...one.change, version: one.version }))}
        cell={(version) => <a href={`/compensations/${found.id}?version=${version}`}>{version}</a>}
      />
      <p class="small"><a href={`/audit?subject=${encodeURIComponent(`compensation ${found.id}`)}`}>{t('audit')}</a></p>
    </details>
  );
}
