// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { type ApiError, as_error, download_made, offer } from '../../api/client';
import type { VolumetricDraft, VolumetricExpectation } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { sentence } from '../../components/findings';
import { Scene } from '../../components/scene/scene';
import { DataTable } from '../../components/table';
import { absent, count, fixed, shortest } from '../../numbers';
import { language } from '../../settings';
import { TripleFields } from '../tracking/fields';
import { reflectors } from '../tracking/form';
import { Obstacles } from '../tracking/more';
import { look } from '../tracking/station';
import { kind_of, motions, squarenesses } from './error_names';
import { Places, VolumeNumber, type VolumeFormProps } from './fields';
import { VolumeFindings } from './findings';
import type { PlaceForm } from './form';
import { plan_scene, reach_of } from './plan_scene';
import { t } from './texts';
import { colon, semicolon } from '../../i18n/colon';

interface Props extends VolumeFormProps {
  draft: VolumetricDraft | null;
  is_of_form: boolean;            // whether the draft is of what stands in the form
  can_plan: boolean;
  planning: boolean;
  make: () => void;
  failure: ComponentChildren;
  name: string;
  run: number;
  choose_run: (run: number) => void;
}

/** Where to stand and to measure, and what that will tell. */
export function PlanPanel(props: Props) {
  const { form, change, faults, draft, is_of_form, can_plan, planning, make, failure } = props;
  return (
    <section class="panel volume-plan" aria-labelledby="volume-plan">
      <header>
        <h2 id="volume-plan"><span class="step">2</span>{t('plan')}</h2>
        {draft && <Taken draft={draft} name={props.name} />}
      </header>
      <div class="programme no-print">
        <Field label={t('stations')}>
          {(ids) => (
            <select {...ids} value={form.propose ? 'propose' : 'given'} onChange={(event) => change(event.currentTarget.value === 'propose' ? { propose: true }
              : { propose: false, stations: form.stations.length > 0 ? form.stations : stations_of(draft) })}>
              <option value="propose">{t('proposed')}</option>
              <option value="given">{t('given')}</option>
            </select>
          )}
        </Field>
        {form.propose && <VolumeNumber {...props} name="count" label={t('how_many')} placeholder="4" />}
        <VolumeNumber {...props} name="points" label={t('points')} placeholder="100" />
        <VolumeNumber {...props} name="feed" label={t('feed')} placeholder="3000" />
        <VolumeNumber {...props} name="dwell" label={t('dwell')} placeholder="3" />
      </div>
      <div class="tracking-form no-print">
        {!form.propose && (
          <Places kind="station" told="station_n" legend={t('stations')} hint={t('stations_hint')} add={t('add_station')} least={1} most={8} places={form.stations} faults={faults} set={(stations) => change({ stations })} />
        )}
        <MorePlan {...props} />
        <div class="row">
          <button type="button" class="primary" disabled={!can_plan || planning} onClick={make}>{planning ? t('planning') : t('make_plan')}</button>
          {!can_plan && <span class="fault">{t('mend')}</span>}
          {draft && !is_of_form && can_plan && <span class="quiet small">{t('stale')}</span>}
        </div>
      </div>
      {failure}
      {draft && <Outcome draft={draft} run={props.run} choose_run={props.choose_run} change={change} is_proposed={form.propose} />}
    </section>
  );
}

const stations_of = (draft: VolumetricDraft | null): PlaceForm[] => {
  const places = Object.entries((draft?.plan.machine.stations_mm ?? {}) as Record<string, number[]>);
  return places.length === 0 ? [{ name: 'S1', at: ['0', '0', '0'] }] : places.map(([name, at]) => ({ name, at: at.map((mm) => String(mm)) }));
};

function MorePlan(props: Props) {
  const { form, change, faults } = props;
  return (
    <details class="more">
      <summary>{t('more')}</summary>
      <div class="tracking-form">
        {form.propose && (
          <>
            <TripleFields legend={`${t('room')}${colon()} ${t('from', { axis: '' }).trim()}`} name="room_low" values={form.room_low} faults={faults} set={(room_low) => change({ room_low })} />
            <TripleFields legend={`${t('room')}${colon()} ${t('to')}`} hint={t('room_hint')} name="room_high" values={form.room_high} faults={faults} set={(room_high) => change({ room_high })} />
          </>
        )}
        <Field label={t('reflector')}>
          {(ids) => (
            <select {...ids} value={form.reflector} onChange={(event) => change({ reflector: event.currentTarget.value })}>
              {reflectors.map(([name]) => <option key={name} value={name}>{name}</option>)}
            </select>
          )}
        </Field>
        <div class="pair">
          <VolumeNumber {...props} name="incidence" label={t('incidence')} placeholder="60" />
          <VolumeNumber {...props} name="safe_radius" label={t('safe_radius')} placeholder="120" />
          <VolumeNumber {...props} name="range_least" label={t('range_least')} placeholder="200" />
          <VolumeNumber {...props} name="range_most" label={t('range_most')} placeholder="15000" />
          <VolumeNumber {...props} name="elevation_lowest" label={t('elevation_lowest')} placeholder="−20" />
          <VolumeNumber {...props} name="elevation_highest" label={t('elevation_highest')} placeholder="90" />
        </div>
        <Obstacles obstacles={form.obstacles} set={(obstacles) => change({ obstacles })} faults={faults} />
      </div>
    </details>
  );
}

/** Buttons that take the plan along. */
function Taken({ draft, name }: { draft: VolumetricDraft; name: string }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const sheet = (extension: string) => {
    set_error(null);
    download_made(`/api/volumetric/plan/sheet.${extension}${look()}`, { plan: draft.plan }, `${name}.${extension}`)
      .catch((thrown: unknown) => set_error(as_error(thrown)));
  };
  return (
    <div class="row no-print">
      <button type="button" onClick={() => offer(new Blob([`${JSON.stringify(draft.plan)}\n`], { type: 'application/json' }), `${name}.plan.json`)}>{t('plan_file')} JSON</button>
      <button type="button" onClick={() => offer(new Blob([draft.csv], { type: 'text/csv' }), `${name}.points.csv`)}>{t('points_file')}</button>
      {['pdf', 'html'].map((extension) => <button key={extension} type="button" onClick={() => sheet(extension)}>{t('sheet')} {extension.toUpperCase()}</button>)}
      {error && <FailureNotice error={error} />}
    </div>
  );
}

interface OutcomeProps { draft: VolumetricDraft; run: number; choose_run: (run: number) => void; change: VolumeFormProps['change']; is_proposed: boolean }

function Outcome({ draft, run, choose_run, change, is_proposed }: OutcomeProps) {
  const [way, set_way] = useState(false);
  const { plan, expected } = draft;
  const scene = useMemo(() => plan_scene(plan, run, way), [plan, run, way, language.value]);
  const told = told_of(draft, run);
  return (
    <>
      <Told expected={expected} />
      {expected.findings.length === 0 ? <p class="quiet">{t('no_findings')}</p> : <VolumeFindings findings={expected.findings} />}
      <div class="field-controls no-print">
        <RunChoice draft={draft} run={run} choose={choose_run} />
        <label class="all-arrows"><input type="checkbox" checked={way} onChange={(event) => set_way(event.currentTarget.checked)} />{t('way')}</label>
        {is_proposed && <button type="button" onClick={() => change({ propose: false, stations: stations_of(draft) })}>{t('take_stations')}</button>}
      </div>
      <Scene model={scene} name={t('picture')} description={told} height={460} />
      <p class="small quiet">{told}</p>
      <Expected expected={expected} />
    </>
  );
}

export function RunChoice({ draft, run, choose }: { draft: VolumetricDraft; run: number; choose: (run: number) => void }) {
  return (
    <Field label={t('run')}>
      {(ids) => (
        <select {...ids} value={run} onChange={(event) => choose(Number(event.currentTarget.value))}>
          {draft.plan.runs.map(({ station, tool }, k) => <option key={k} value={k}>{t('run_of', { n: k + 1, station, tool })}</option>)}
        </select>
      )}
    </Field>
  );
}

function told_of({ plan }: VolumetricDraft, run: number): string {
  const { station, tool, stops } = plan.runs[run] ?? { station: '', tool: '', stops: [] };
  const { low, high } = reach_of(plan, tool);
  const ends = (k: 0 | 1 | 2) => `${shortest(low[k], 1)} … ${shortest(high[k], 1)}`;
  const stations = Object.entries(plan.machine.stations_mm as Record<string, number[]>)
    .map(([name, at]) => `${name} (${at.map((mm) => shortest(mm, 0)).join(semicolon())})`).join(', ');
  return t('picture_told', { tool, x: ends(0), y: ends(1), z: ends(2), stations, n: stops.length, run: t('run_of', { n: run + 1, station, tool }) });
}

function Told({ expected }: { expected: VolumetricExpectation }) {
  const { rank, unseen, reasons, volume } = expected;
  const figures: [string, string, string][] = [
    [t('figure_points'), count(expected.points), ''],
    [t('figure_runs'), String(expected.runs.length), ''],
    [t('figure_rank'), t('of', { n: rank.rank, all: rank.unknowns }), ''],
    [t('figure_u'), volume.u_rms_um === null ? t('not_told') : fixed(volume.u_rms_um, 2), volume.u_rms_um === null ? '' : `µm, ${t('at_most', { u: fixed(volume.u_max_um, 2) })}`],
  ];
  return (
    <>
      <div class={`notice ${unseen.length === 0 ? 'good' : 'caution'}`}>
        <p class="heading">{unseen.length === 0 ? t('all_told') : t('some_told', { n: 21 - unseen.length })}</p>
        {unseen.length > 0 && <p>{t('will_not', { names: unseen.join(', ') })}</p>}
        {reasons.map((reason, k) => <p key={k}>{sentence(reason)}</p>)}
      </div>
      <dl class="figures">
        {figures.map(([name, value, unit]) => <div key={name}><dt>{name}</dt><dd class="number">{value} {unit && <span class="unit">{unit}</span>}</dd></div>)}
      </dl>
    </>
  );
}

interface Row { name: string; kind: string; unit: string; u_mean: number | null; u_max: number | null }

function Expected({ expected }: { expected: VolumetricExpectation }) {
  const rows: Row[] = [
    ...motions.map((motion) => ({ name: motion.name, kind: `${motion.axis}${colon()} ${kind_of(motion)}`, unit: motion.unit as string })),
    ...squarenesses.map(([name, a, b]) => ({ name, kind: `${a} ⟂ ${b}`, unit: 'µrad' })),
  ].map((row) => ({ ...row, ...(expected.errors[row.name] ?? { u_mean: null, u_max: null }) }));
  const number = (key: 'u_mean' | 'u_max', head: string) =>
    ({ key, head, number: true, cell: (row: Row) => (row[key] === null ? (key === 'u_mean' ? t('not_told') : absent) : fixed(row[key], 2)) });
  return (
    <details class="all-errors">
      <summary>{t('expected')}</summary>
      <DataTable caption={t('expected')} rows={rows} row_key={({ name }) => name} columns={[
        { key: 'name', head: t('error'), row_head: true, cell: ({ name }) => name },
        { key: 'kind', head: t('kind'), cell: ({ kind }) => kind },
        { key: 'unit', head: t('unit'), cell: ({ unit }) => unit },
        number('u_mean', t('u_mean')), number('u_max', t('u_most')),
      ]} />
      <p class="quiet small">{t('expected_note')}</p>
    </details>
  );
}
