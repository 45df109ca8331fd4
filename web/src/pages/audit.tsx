// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import { type ApiError, as_error, get, query } from '../api/client';
import type { AuditEntry, AuditTrail } from '../api/types';
import { use_get } from '../api/use';
import { FailureNotice } from '../components/failure';
import { Hash } from '../components/hash';
import { DataTable } from '../components/table';
import { when } from '../numbers';
import { place } from '../router';
import { action_text, detail_name, subject_path, subject_text } from './settings/actions';
import './settings/settings.css';
import { t } from './settings/texts';

const page_size = 100;

/** Who did what, when and why: of everything, or of one thing ("?subject=test 12"). */
export function AuditPage() {
  const subject = place.value.query.get('subject') ?? '';
  const first = use_get<AuditTrail>(`/api/audit${query({ subject, limit: page_size })}`);
  const [older, set_older] = useState<AuditEntry[]>([]);
  const [error, set_error] = useState<ApiError | null>(null);
  const [ended, set_ended] = useState(false);
  useEffect(() => { set_older([]); set_ended(false); }, [first.data]);
  const entries = [...(first.data?.entries ?? []), ...older];
  const more = async () => {
    set_error(null);
    try {
      const answer = await get<AuditTrail>(`/api/audit${query({ subject, before: entries[entries.length - 1]?.id, limit: page_size })}`);
      set_older([...older, ...answer.entries]);
      set_ended(answer.entries.length < page_size);
    } catch (failure) {
      set_error(as_error(failure));
    }
  };
  const failed = first.error ?? error;
  const may_have_more = !ended && entries.length >= page_size;
  return (
    <>
      <div class="page-head">
        <div>
          <h1 tabIndex={-1}>{subject === '' ? t('audit') : t('audit_of', { subject: subject_text(subject) })}</h1>
          <p class="crumb">{t('audit_why')}</p>
        </div>
        {subject !== '' && <a class="button" href="/audit">{t('all')}</a>}
      </div>
      {failed && <FailureNotice error={failed} retry={first.error ? first.reload : () => void more()} />}
      {first.data && (
        <section class="panel flush audit">
          {entries.length === 0 ? <p class="quiet nothing">{t('none')}</p> : <Entries entries={entries} subject={subject} />}
          {may_have_more && <div class="more"><button type="button" onClick={() => void more()}>{t('more')}</button></div>}
        </section>
      )}
    </>
  );
}

function Entries({ entries, subject }: { entries: AuditEntry[]; subject: string }) {
  return (
    <DataTable<AuditEntry>
      caption={t('audit')} rows={entries} row_key={(row) => row.id}
      columns={[
        { key: 'id', head: '№', number: true, class: 'quiet', cell: (row) => row.id },
        { key: 'at', head: t('at'), class: 'number-text at', cell: (row) => <time dateTime={row.change.at} title={row.change.at}>{when(row.change.at)}</time> },
        { key: 'actor', head: t('actor_head'), class: 'actor', cell: (row) => row.change.actor },
        { key: 'action', head: t('action'), class: 'action', cell: (row) => action_text(row.action) },
        ...(subject === '' ? [{ key: 'subject', head: t('subject'), class: 'subject', cell: (row: AuditEntry) => <Subject subject={row.subject} /> }] : []),
        { key: 'reason', head: t('reason'), class: 'reason', cell: (row) => row.change.reason },
        { key: 'detail', head: t('detail'), class: 'detail small', cell: (row) => (
          Object.entries(row.detail).map(([key, value]) => <span key={key}><span class="quiet">{detail_name(key)}</span> <Value value={value} /></span>)
        ) },
        { key: 'hash', head: t('hash'), class: 'chained', cell: (row) => <Hash hash={row.sha256} /> },
      ]}
    />
  );
}

function Value({ value }: { value: unknown }) {
  const text = typeof value === 'string' ? value : JSON.stringify(value);
  return /^[0-9a-f]{64}$/.test(text) ? <Hash hash={text} /> : <>{text}</>;
}

function Subject({ subject }: { subject: string }) {
  const path = subject_path(subject);
  return path ? <a class="quiet-link" href={path}>{subject_text(subject)}</a> : <>{subject_text(subject)}</>;
}
