// SPDX-License-Identifier: Apache-2.0
// The way to the 21 errors of a machine: machine, plan, programs, lengths, errors. Only captures and kept
// results are in the archive.
import { useEffect, useMemo, useState } from 'preact/hooks';
import { query } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { MachineList, Vocabulary, VolumetricDraft, VolumetricPlanRequest } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { decimal } from '../../settings';
import { LengthPartsPanel } from '../capture/length_parts';
import '../plan/plan.css';
import { ProgramPanel } from '../plan/program';
import '../tracking/tracking.css';
import { new_form, read_form, type VolumeForm } from './form';
import { volume_kept } from './kept';
import { LengthsPanel } from './lengths';
import { MachinePanel } from './machine';
import { PlanPanel, RunChoice } from './plan';
import { SinglesPanel } from './singles';
import { t } from './texts';
import './volume.css';

export function VolumePage() {
  const [form, set_form] = useState(volume_kept.load);
  const [asked, set_asked] = useState<VolumetricPlanRequest | null>(null);
  const [chosen_run, choose_run] = useState(0);
  const machines = use_get<MachineList>('/api/machines');
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const { machine, request, faults } = useMemo(() => read_form(form), [form]);
  const answer = use_posted<VolumetricDraft>(`/api/volumetric/plan${query({ decimal: decimal.value })}`, asked, as_json);
  const draft = asked === null ? null : answer.data;
  const planning = asked !== null && answer.error === null && !answer.is_current;
  useEffect(() => volume_kept.keep(form), [form]);
  const change = (part: Partial<VolumeForm>) => set_form((before) => ({ ...before, ...part }));
  const run = Math.min(chosen_run, Math.max(0, (draft?.plan.runs.length ?? 1) - 1));
  const name = `${form.machine.trim()} ${t('title')}`.trim();
  const subject = useMemo(() => draft && { plan: draft.plan }, [draft]);
  const captured = useMemo(() => draft && { kind: 'volume' as const, plan: draft.plan }, [draft]);
  const shown = draft?.plan.runs[run];
  // Where stations were proposed, lengths are held against them too.
  const proposed = form.propose ? draft?.plan.machine.stations_mm : undefined;
  const measured = useMemo(() => machine && (proposed ? { ...machine, stations_mm: proposed } : machine), [machine, proposed]);
  const fields = { form, change, faults };
  return (
    <>
      <header class="page-head">
        <h1 tabIndex={-1}>{t('title')}</h1>
        <button type="button" class="no-print" onClick={() => { set_form(new_form()); set_asked(null); }}>{t('afresh')}</button>
      </header>
      <p class="lead">{t('lead')}</p>
      <div class="tracking volume">
        <div class="stack no-print">
          <MachinePanel {...fields} machines={machines.data?.machines ?? []} machine={machine} />
        </div>
        <div class="stack">
          <PlanPanel {...fields} {...{ draft, planning, name, run, choose_run }} can_plan={request !== null}
            is_of_form={JSON.stringify(asked) === JSON.stringify(request)}
            make={() => { set_asked(request); if (answer.error) answer.again(); }}
            failure={answer.error && asked && <FailureNotice error={answer.error} retry={answer.again} />} />
          {vocabulary.error && <FailureNotice error={vocabulary.error} retry={vocabulary.reload} />}
          {vocabulary.data && draft && (
            <ProgramPanel path="/api/volumetric/plan/program" subject={subject} part={run + 1} name={`${form.machine.trim()} ${shown?.station ?? ''} ${shown?.tool ?? ''}`.trim()}
              vocabulary={vocabulary.data} step="3" choice={<RunChoice draft={draft} run={run} choose={choose_run} />} />
          )}
          {!draft && (
            <section class="panel no-print" aria-labelledby="volume-programs">
              <header><h2 id="volume-programs"><span class="step">3</span>{t('programs')}</h2></header>
              <p class="quiet">{t('no_programs')}</p>
            </section>
          )}
          <LengthPartsPanel subject={captured} step="4" />
          <LengthsPanel machine={measured} />
          <SinglesPanel machine={machine} />
        </div>
      </div>
    </>
  );
}
