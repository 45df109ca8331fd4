// SPDX-License-Identifier: Apache-2.0
// The way of a test with a tracking interferometer: machine, station, lines, program, lengths, results. All of it stands
// on one page, and of it only captures and kept results are in the archive.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, download_made, offer, query } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { MachineList, TrackingDraft, TrackingPoints, Vocabulary } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { decimal } from '../../settings';
import { LengthPartsPanel } from '../capture/length_parts';
import { ProgramPanel } from '../plan/program';
import '../plan/plan.css';
import './tracking.css';
import { CoordinatesPanel } from './coordinates';
import { is_aligned, new_form, request_of, type LocatedStation, type TrackingForm } from './form';
import { tracking_kept } from './kept';
import { LengthsPanel } from './lengths';
import { LinesPanel } from './lines';
import { MachinePanel } from './machine';
import { look, StationPanel } from './station';
import { t } from './texts';

export function TrackingPage() {
  const [{ form, located }, set_page] = useState(tracking_kept.load);
  const [points, set_points] = useState<TrackingPoints | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const machines = use_get<MachineList>('/api/machines');
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const { request, faults } = request_of(form, located);
  const draft = use_posted<TrackingDraft>(`/api/tracking/lines${query({ decimal: decimal.value })}`, request && { request }, as_json);
  useEffect(() => tracking_kept.keep({ form, located }), [form, located]);
  const change = (part: Partial<TrackingForm>) => set_page((before) => ({ ...before, form: { ...before.form, ...part } }));
  const locate = (found: LocatedStation | null) => set_page((before) => ({ ...before, located: found }));
  const is_of_request = draft.error === null && draft.data !== null && JSON.stringify(draft.of) === JSON.stringify({ request });
  const plan = is_of_request && draft.data ? draft.data.plan : null;
  const captured = useMemo(() => plan && { kind: 'lines' as const, plan }, [plan]);
  const settled = is_of_request ? (draft.data?.request ?? null) : null;
  const name = `${form.machine.trim()} ${t('lines')}`.trim();
  const sheet = (extension: string) => {
    set_error(null);
    download_made(`/api/tracking/lines/sheet.${extension}${look()}`, { request: settled }, `${name}.${extension}`)
      .catch((thrown: unknown) => set_error(as_error(thrown)));
  };
  const fields = { form, change, faults };
  return (
    <>
      <header class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <button type="button" class="no-print" onClick={() => { set_page({ form: new_form(), located: null }); set_points(null); }}>{t('afresh')}</button>
      </header>
      <p class="lead">{t('lead')}</p>
      <div class="tracking">
        <div class="stack no-print">
          <MachinePanel {...fields} machines={machines.data?.machines ?? []} />
          <StationPanel {...fields} {...{ request, located, locate, points, set_points }} />
        </div>
        <div class="stack">
          <LinesPanel {...fields} {...{ request, points, is_of_request }} draft={draft.data}
            failure={<>{draft.error && <FailureNotice error={draft.error} retry={draft.again} />}{error && <FailureNotice error={error} />}</>}
            taken={(
              <>
                <button type="button" disabled={plan === null} onClick={() => offer(new Blob([`${JSON.stringify(plan, null, 2)}\n`], { type: 'application/json' }), `${name}.plan.json`)}>{t('plan_file')}</button>
                {['pdf', 'html'].map((extension) => (
                  <button key={extension} type="button" disabled={settled === null} onClick={() => sheet(extension)}>{t('sheet')} {extension.toUpperCase()}</button>
                ))}
              </>
            )} />
          {vocabulary.error && <FailureNotice error={vocabulary.error} retry={vocabulary.reload} />}
          {vocabulary.data && <ProgramPanel path="/api/tracking/lines/program" subject={settled && { request: settled }} of_lines stops={is_aligned(form)} name={name} vocabulary={vocabulary.data} step="4" />}
          <LengthPartsPanel subject={captured} step="5" />
          <LengthsPanel plan={plan} located={is_aligned(form) ? null : located} />
          <CoordinatesPanel vocabulary={vocabulary.data} />
        </div>
      </div>
    </>
  );
}
