// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { query } from '../../api/client';
import { why_read_only } from '../../api/session';
import type { KeptCalibration } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Hash } from '../../components/hash';
import type { Options } from '../../components/evaluation_options';
import { DataTable } from '../../components/table';
import { date_or_none } from '../../components/test_date';
import { VerdictMark } from '../../components/verdict';
import { VersionList } from '../../components/versions';
import { place } from '../../router';
import { decimal, language } from '../../settings';
import './calibrations.css';
import { ComparePanel } from './comparison';
import { EditCalibration, EvaluateAgain, WithdrawCalibration } from './dialogs';
import { CalibrationHistory } from './history';
import { told_options } from './told_options';
import { CalibrationResult } from './result';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** One calibration at one of its versions: figures, findings, files, versions, and what may be done with it. */
export function CalibrationPage({ parts }: { parts: Record<string, string> }) {
  const version = place.value.query.get('version');
  const asked = use_get<KeptCalibration>(`/api/calibrations/${parts['id']}${query({ version })}`);
  const [doing, set_doing] = useState<'edit' | 'again' | 'withdraw' | null>(null);
  const found = asked.data;
  if (asked.error && !found) return <FailureNotice error={asked.error} retry={asked.reload} />;
  if (!found) return null;
  const latest = Math.max(...found.versions.map(({ version: each }) => each));
  const fixed_version = found.version !== latest || why_read_only() !== null;
  const dialog = { calibration: found, on_done: asked.set, on_close: () => set_doing(null) };
  return (
    <>
      <div class="page-head calibration-head">
        <div>
          <p class="crumb"><a href="/calibrations">{t('title')}</a></p>
          <h1 tabIndex={-1}>{found.title}</h1>
        </div>
        <div class="row no-print">
          {(['pdf', 'html', 'json'] as const).map((extension) => <ReportLink key={extension} calibration={found} extension={extension} />)}
          <button type="button" disabled={fixed_version || found.withdrawn} onClick={() => set_doing('again')}>{t('evaluate_again')}</button>
          <button type="button" disabled={fixed_version} onClick={() => set_doing('withdraw')}>{t(found.withdrawn ? 'reinstate' : 'withdraw')}</button>
          <button type="button" disabled={fixed_version || found.withdrawn} onClick={() => set_doing('edit')}>{t('edit')}</button>
        </div>
      </div>
      {asked.error && <FailureNotice error={asked.error} retry={asked.reload} />}
      {found.version !== latest && <p class="notice caution">{t('older', { n: found.version, latest })} <a href={`/calibrations/${found.id}`}>{t('to_latest')}</a></p>}
      <Facts calibration={found} />
      <CalibrationResult calibration={found} />
      <CalibrationHistory calibration={found} />
      <ComparePanel calibration={found} />
      <Files calibration={found} />
      <Versions calibration={found} />
      {doing === 'edit' && <EditCalibration {...dialog} />}
      {doing === 'again' && <EvaluateAgain {...dialog} />}
      {doing === 'withdraw' && <WithdrawCalibration {...dialog} />}
    </>
  );
}

function ReportLink({ calibration, extension }: { calibration: KeptCalibration; extension: string }) {
  const asked = query({ version: calibration.version, language: language.value, decimal: decimal.value, download: 1 });
  return <a class="button" href={`/api/calibrations/${calibration.id}/report.${extension}${asked}`} download>{t('report')} {extension.toUpperCase()}</a>;
}

function Facts({ calibration }: { calibration: KeptCalibration }) {
  const { machine, instrument, kind, measured_on, program, notes, verdict, withdrawn, serious } = calibration;
  return (
    <section class="panel">
      <dl class="fact-grid">
        <div><dt>{t('kind')}</dt><dd>{t(kind)}</dd></div>
        <div><dt>{t('machine')}</dt><dd>{machine ? <a href={`/machines/${machine.id}`}>{machine.name}</a> : t('unstated')}</dd></div>
        <div><dt>{t('instrument')}</dt><dd>{instrument ? <a href={`/instruments/${instrument.id}`}>{instrument.name}</a> : t('unstated')}</dd></div>
        <div><dt>{t('measured')}</dt><dd>{date_or_none(measured_on)}</dd></div>
        <div><dt>{t('program')}</dt><dd>{program}</dd></div>
        {verdict !== null && <div><dt>{t('verdict')}</dt><dd><VerdictMark verdict={verdict} /></dd></div>}
      </dl>
      {(withdrawn || serious > 0) && (
        <p class="row">
          {withdrawn && <span class="tag caution">{t('withdrawn')}</span>}
          {serious > 0 && <span class="tag bad">{t('serious', { n: serious })}</span>}
        </p>
      )}
      {notes !== '' && <p class="notes">{notes}</p>}
    </section>
  );
}

/** Of further files of one kind, "lengths-2", with its number. */
function role_name(role: string): string {
  const [name, number] = role.split('-');
  return `${t(`role_${name as 'lengths'}`)}${number ? ` ${number}` : ''}`;
}

function Files({ calibration }: { calibration: KeptCalibration }) {
  return (
    <section class="panel">
      <header><h2>{t('files')}</h2></header>
      <DataTable<KeptCalibration['files'][number]> caption={t('files')} rows={calibration.files} row_key={({ role }) => role} columns={[
        { key: 'role', head: t('role'), row_head: true, cell: ({ role }) => role_name(role) },
        { key: 'name', head: t('file'), cell: ({ role, name }) => <a href={`/api/calibrations/${calibration.id}/files/${role}`} download>{name}</a> },
        { key: 'sha256', head: 'SHA-256', cell: ({ sha256 }) => <Hash hash={sha256} /> },
      ]} />
      <p class="small quiet">{t('options')}{colon()} {told_options(calibration.kind, calibration.options as Options) || t('as_usual')}</p>
    </section>
  );
}

function Versions({ calibration }: { calibration: KeptCalibration }) {
  return (
    <details class="panel history">
      <summary>{t('versions')} <span class="quiet small">({calibration.versions.length})</span></summary>
      <VersionList
        versions={calibration.versions.map((one) => ({ ...one.change, version: one.version }))}
        cell={(version) => <a href={`/calibrations/${calibration.id}?version=${version}`}>{version}</a>}
      />
      <p class="small"><a href={`/audit?subject=${encodeURIComponent(`calibration ${calibration.id}`)}`}>{t('audit')}</a></p>
    </details>
  );
}
