// SPDX-License-Identifier: Apache-2.0
import { use_get } from '../../api/use';
import type { Capture, CaptureList, PlanList } from '../../api/types';
import { ListPage } from '../../components/list_page';
import { absent, when } from '../../numbers';
import { is_over } from './live';
import { evaluation_of } from './motion';
import { t as t_motion } from './motion_texts';
import { has_table, table_of } from './table_ending';
import { t } from './texts';
import { t as t_dynamic } from '../dynamic/texts';
import './capture.css';
import { colon } from '../../i18n/colon';

export function CapturesPage() {
  const captures = use_get<CaptureList>('/api/captures');
  const plans = use_get<PlanList>('/api/plans');
  const title = ({ plan: id, lengths }: Capture) => lengths ? `${t(lengths.kind === 'lines' ? 'of_lines' : 'of_volume')}${colon()} ${lengths.title}`
    : plans.data?.plans.find((plan) => plan.id === id)?.title ?? `${t('plan')} ${id ?? ''}`;
  return (
    <ListPage<Capture>
      title={t('captures')} actions={<span class="row"><a class="button" href="/dynamic">{t_dynamic('to_page')}</a><a class="button primary" href="/captures/new">{t('new_capture')}</a></span>}
      asked={captures} rows={captures.data?.captures} none={t('none_yet')} row_key={(capture) => capture.id}
      columns={[
        { key: 'plan', head: t('plan'), row_head: true, cell: (capture) => (
          <>
            <a href={`/captures/${capture.id}`}>{title(capture)}</a>
            <span class="only-narrow quiet small">{capture.source.title} · {when(capture.started)}</span>
          </>
        ) },
        { key: 'started', head: t('started'), class: 'number-text wide-only', cell: (capture) => when(capture.started) },
        { key: 'source', head: t('source'), class: 'wide-only', cell: (capture) => capture.source.title },
        { key: 'state', head: t('state'), cell: (capture) => <State capture={capture} /> },
        { key: 'test', head: t('became'), cell: (capture) => <Became capture={capture} /> },
      ]}
    />
  );
}

function Became({ capture }: { capture: Capture }) {
  if (capture.test !== null) return <a href={`/tests/${capture.test}`}>{t('to_test')}</a>;
  const end = table_of(capture);
  if (!end) return <>{absent}</>;
  const file = (role: string) => `/api/captures/${capture.id}/files/${role}`;
  return (
    <span class="row">
      {capture.lengths && has_table(capture) && <a href={file('lengths')} download>{t('found_of', { n: end.found, all: capture.approaches })}</a>}
      {capture.motion && has_table(capture) && <a href={evaluation_of(capture)}>{t_motion('found_of', { n: end.found, all: capture.approaches })}</a>}
      {end.files.includes('raw') && <a href={file('raw')} download>{t('raw_recording')}</a>}
    </span>
  );
}

/** One that goes on, or that waits for somebody's decision, stands out. */
function State({ capture }: { capture: Capture }) {
  if (!is_over(capture)) return <strong>{t(capture.state)}</strong>;
  const tone = capture.state === 'failed' ? 'bad' : capture.state === 'interrupted' ? 'caution' : '';
  return tone === '' ? <>{t(capture.state)}</> : <span class={`tag ${tone}`}>{t(capture.state)}</span>;
}
