// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { query } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import { use_get } from '../../api/use';
import type { Machine, MachineList, Plan, PlanDraft, PlanRequest, Vocabulary } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { position_unit } from '../../numbers';
import { place } from '../../router';
import { decimal, language, screen_theme } from '../../settings';
import { PlanFields } from './fields';
import { form_of, new_form, request_of, type PlanForm } from './form';
import { Keep, PlanFile } from './keep';
import { Outcome, TargetTable } from './outcome';
import { ProgramPanel } from './program';
import { t } from './texts';
import './plan.css';

/** How figures of the server look like the page around them. */
const look = () => query({ decimal: decimal.value, theme: screen_theme.value });

/** Paper is white: beside a dark page its figures are asked for a second time, as nothing is fetched while a page prints. */
const look_on_paper = () => (screen_theme.value === 'light' ? null : query({ decimal: decimal.value, theme: 'light' }));

/** A new plan, or one of the store to look at and go on with. */
export function PlanPage({ parts }: { parts: Record<string, string> }) {
  const id = parts['id'] ?? null;
  const plan = use_get<Plan>(id === null ? null : `/api/plans/${id}${look()}`);
  const machines = use_get<MachineList>('/api/machines');
  const vocabulary = use_get<Vocabulary>('/api/vocabulary');
  const wanted_axis = id === null ? place.value.query.get('axis') : null;
  if (plan.error) return <><h1 tabIndex={-1}>{t('plan')}</h1><FailureNotice error={plan.error} retry={plan.reload} /></>;
  if ((id !== null && plan.data?.id !== Number(id)) || (machines.loading && !machines.data)) return <h1 tabIndex={-1}>{t('plan')}</h1>;
  return (
    <>
      {vocabulary.error && <FailureNotice error={vocabulary.error} retry={vocabulary.reload} />}
      {id !== null && plan.data?.request === null
        ? <WholePlan plan={plan.data} vocabulary={vocabulary.data} />
        : <Editor kept={plan.data} keep={plan.set} machines={machines.data?.machines ?? []}
            vocabulary={vocabulary.data} axis={wanted_axis} />}
    </>
  );
}

interface EditorProps {
  kept: Plan | null;
  keep: (plan: Plan) => void;
  machines: Machine[];
  vocabulary: Vocabulary | null;
  axis: string | null;
}

function Editor({ kept, keep, machines, vocabulary, axis }: EditorProps) {
  const [form, set_form] = useState<PlanForm>(() => first_form(kept, machines, axis));
  const [touched, set_touched] = useState(false);
  const { request, faults } = request_of(form);
  const draft = use_posted<PlanDraft>(`/api/plans/draft${look()}`, request === null ? null : { request }, as_json);
  const paper = look_on_paper();
  const drawn = draft.data?.request ?? null; // with its seed, so that both figures are of one plan
  const on_paper = use_posted<PlanDraft>(`/api/plans/draft${paper ?? ''}`, paper === null || drawn === null ? null : { request: drawn }, as_json);
  const shown = draft.data ?? kept;
  const unit = position_unit(form.kind);
  const title = form.title.trim() === '' ? usual_title(form, unit) : form.title.trim();
  const change = (part: Partial<PlanForm>) => {
    set_form((before) => ({ ...before, ...part }));
    set_touched(true);
  };
  return (
    <>
      <Keep {...{ form, title, request, kept, touched }} rename={(name) => change({ title: name })}
        done={(plan) => {
          set_touched(false);
          keep(plan);
        }}
        replace={(plan) => {
          if (plan.request) set_form(form_of(plan.title, plan.axis, plan.request));
          set_touched(false);
          keep(plan);
        }} />
      <div class="planner">
        <section class="panel no-print" aria-label={t('plan')}>
          <PlanFields {...{ form, change, machines, vocabulary }} faults={faults ?? {}}
            chosen={shown?.plan ?? null} />
        </section>
        <PlanView draft={shown} on_paper={paper === null ? null : on_paper.data} unit={unit} title={title} vocabulary={vocabulary} plan={null}
          request={draft.data && !draft.error ? (draft.of as { request: PlanRequest }).request : (kept?.request ?? null)}
          failure={draft.error && <FailureNotice error={draft.error} retry={draft.again} />}
          note={(draft.error || faults) && <p class="quiet small">{t('last_good')}</p>} />
      </div>
    </>
  );
}

function first_form(kept: Plan | null, machines: Machine[], axis: string | null): PlanForm {
  if (kept?.request) return form_of(kept.title, kept.axis, kept.request);
  const form = new_form();
  const machine = machines.find((one) => one.axes.some(({ id }) => String(id) === axis));
  const found = machine?.axes.find(({ id }) => String(id) === axis);
  if (!machine || !found) return form;
  return {
    ...form, axis: found.id, name: found.name, kind: found.kind, to: found.kind === 'linear' ? '500' : '360',
    further: { machine: machine.name },
  };
}

const usual_title = (form: PlanForm, unit: string): string =>
  `${form.further['machine'] ? `${form.further['machine']} ` : ''}${form.name.trim()} ${form.from.trim()}…${form.to.trim()} ${unit}`;

/** A plan that came as a file: shown, not edited. */
function WholePlan({ plan, vocabulary }: { plan: Plan; vocabulary: Vocabulary | null }) {
  const paper = look_on_paper();
  const on_paper = use_get<Plan>(paper === null ? null : `/api/plans/${plan.id}${paper}`);
  const kind = plan.plan.axis.kind ?? 'linear';
  return (
    <>
      <header class="page-head">
        <h1 tabIndex={-1}>{plan.title}</h1>
        <div class="row no-print">
          {['pdf', 'html'].map((extension) => (
            <a key={extension} class="button" download={`${plan.title}.${extension}`}
              href={`/api/plans/${plan.id}/sheet.${extension}${query({ language: language.value, decimal: decimal.value, download: 1 })}`}>
              {t('sheet')} {extension.toUpperCase()}
            </a>
          ))}
          <PlanFile id={plan.id} />
          <a class="button primary" href={`/captures/new?plan=${plan.id}`}>{t('capture_with')}</a>
        </div>
      </header>
      <p class="notice">{t('whole_plan')}</p>
      <div class="planner whole">
        <PlanView draft={plan} on_paper={paper === null ? null : on_paper.data} unit={position_unit(kind)} title={plan.title}
          vocabulary={vocabulary} plan={plan.plan} request={null} />
      </div>
    </>
  );
}

interface ViewProps {
  draft: PlanDraft | null;
  on_paper: PlanDraft | null; // its figures for white, where those of `draft` are for a dark page
  unit: string;
  title: string;
  vocabulary: Vocabulary | null;
  request: PlanRequest | null;
  plan: unknown; // the whole one, instead of a request
  failure?: ComponentChildren;
  note?: ComponentChildren;
}

/** What comes of a plan: programme, part program and targets, of one of its tests where it has several. */
function PlanView({ draft, on_paper, unit, title, vocabulary, request, plan, failure, note }: ViewProps) {
  const [wanted, set_wanted] = useState(1);
  const parts = draft?.parts ?? [];
  const part = parts[wanted - 1] ?? parts[0] ?? null;
  const figure_on_paper = on_paper && (on_paper.parts?.[(part?.part ?? 1) - 1]?.figure_svg ?? on_paper.figure_svg);
  return (
    <>
      <div class="stack">
        {failure}
        {draft && <Outcome draft={draft} figure_on_paper={figure_on_paper} unit={unit} part={part} choose={set_wanted}>{note}</Outcome>}
        {vocabulary && draft && <ProgramPanel path="/api/plans/draft/program" subject={request ? { request } : plan !== null ? { plan } : null} part={part?.part ?? 1} rotary={unit === position_unit('rotary')} name={title} vocabulary={vocabulary} />}
      </div>
      {draft && <TargetTable targets={part?.targets ?? draft.targets} unit={unit} />}
    </>
  );
}
