// SPDX-License-Identifier: Apache-2.0
// A capture of lengths while it goes on, what came of it, and the way to the next part.
import { useMemo } from 'preact/hooks';
import { query } from '../../api/client';
import type { Capture, CapturedLengths, CapturedPlan } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Scene } from '../../components/scene/scene';
import { DataTable } from '../../components/table';
import { absent, fixed, shortest, when } from '../../numbers';
import { decimal, language } from '../../settings';
import { LengthPartsPanel } from './length_parts';
import { expected_length, length_scene, type Stop } from './length_scene';
import { t } from './length_texts';
import { is_over, use_screen_on, type Caught, type Live } from './live';
import { Progress, Where } from './readout';
import { StopButton } from './stop';
import { TableEnding } from './table_ending';
import { t as t_capture } from './texts';
import { colon } from '../../i18n/colon';

interface Props { live: Live; capture: Capture; lengths: CapturedLengths; again: () => void }

export function LengthsCapture({ live, capture, lengths, again }: Props) {
  const captured = use_get<CapturedPlan>(`/api/captures/${capture.id}/plan${query({ decimal: decimal.value })}`);
  const running = !is_over(capture);
  use_screen_on(running);
  const plan = captured.data?.plan_id === lengths.plan_id ? captured.data : null;
  const subject = useMemo(() => plan && { kind: plan.kind, plan: plan.plan }, [plan]);
  const name_of = (stop: number) => plan?.stops[stop - 1]?.name ?? String(stop);
  const shared = { capture, lengths, caught: live.caught };
  return (
    <>
      <header class="page-head">
        <div>
          <h1 tabIndex={-1}>{t(lengths.kind === 'lines' ? 'part_of_lines' : 'part_of_volume')}{colon()} {lengths.title}</h1>
          <p class="crumb">{capture.source.title} · {t_capture('started')} {when(capture.started)}{running && ` · ${t_capture(capture.state)}`}</p>
        </div>
        {running && <StopButton capture={capture} what={t('stop_what', { n: capture.taken, all: capture.approaches })} stopped={live.set} />}
      </header>
      {live.error && <FailureNotice error={live.error} />}
      {captured.error && <FailureNotice error={captured.error} retry={captured.reload} />}
      {live.lost && <p class="notice caution offline" role="status">{t_capture('lost')}</p>}
      {capture.source.kind === 'simulator' && <p class="notice">{t('simulated')}</p>}
      {!running && (
        <TableEnding
          capture={capture} again={again} only_raw={t('only_raw')} table={t('table_file')} discard_what={t('discard_what')}
          kept={t('kept', { n: lengths.end?.found ?? 0, all: capture.approaches })}
        />
      )}
      {lengths.broken_before.length > 0 && (
        <div class="notice caution" role="status">
          <p class="heading">{t('broken')}</p>
          <p>{t('broken_before', { names: lengths.broken_before.map(name_of).join(', ') })}</p>
        </div>
      )}
      <div class="live of-lengths">
        {running && <LengthReadout {...shared} plan={plan} />}
        {plan && <Setup {...shared} plan={plan} />}
        {plan && <StopList {...shared} stops={plan.stops} />}
        <div class="wide"><LengthPartsPanel subject={subject} own={capture} /></div>
        <Notices notices={capture.notices} />
      </div>
      <p class="visually-hidden" aria-live="polite">{running && live.caught.length > 0 && `${name_of(live.caught[live.caught.length - 1]?.stop ?? 0)}${colon()} ${fixed(live.caught[live.caught.length - 1]?.length_mm ?? 0, 3)} mm`}</p>
    </>
  );
}

interface Shared { capture: Capture; lengths: CapturedLengths; caught: Caught }

function LengthReadout({ capture, lengths, caught, plan }: Shared & { plan: CapturedPlan | null }) {
  const { now } = capture;
  const stop = lengths.due === null ? undefined : plan?.stops[lengths.due - 1];
  const last = caught[caught.length - 1];
  const expected = plan && expected_length(plan, caught, lengths.due);
  return (
    <section class="panel readout" aria-label={t('length')}>
      {now ? <Where position={now.position} unit="mm" rest={now.at_rest} /> : <p class="where motion">{t('no_length')}</p>}
      <div class="next">
        <p class="name">{t(stop ? 'next_point' : 'last_point')}</p>
        {stop && <p class="large"><span>{stop.name}</span> <span class="unit">{stop.group}</span></p>}
        {stop && expected !== null && (
          <p class="number quiet">
            <span>{t('expected', { length: fixed(expected, 1) })}</span>
            {now && <> · <span>{t('to_go', { length: fixed(expected - now.position, 1) })}</span></>}
          </p>
        )}
        {!stop && capture.taken < capture.approaches && <p>{t('waits')}</p>}
        {!stop && last && <p class="large number">{fixed(last.length_mm, 4)} <span class="unit">mm</span></p>}
      </div>
      <Progress capture={capture} done={capture.taken} />
    </section>
  );
}

const place_text = ([x, y, z]: readonly number[]): string => `X ${shortest(x ?? 0, 1)}, Y ${shortest(y ?? 0, 1)}, Z ${shortest(z ?? 0, 1)}`;

function Setup({ lengths, caught, plan, capture }: Shared & { plan: CapturedPlan }) {
  const scene = useMemo(() => length_scene(plan, caught, lengths.due), [plan, caught, lengths.due, language.value]);
  const stop = lengths.due === null ? undefined : plan.stops[lengths.due - 1];
  const told = t('setup_told', {
    all: plan.stops.length, part: lengths.title, n: is_over(capture) ? (lengths.end?.found ?? capture.taken) : caught.length,
    due: stop ? t('due_at', { name: stop.name, place: place_text(stop.reflector_mm) }) : t('none_due'),
  });
  return (
    <section class="panel" aria-labelledby="length-setup">
      <h2 id="length-setup">{t('setup')}</h2>
      <Scene model={scene} name={t('setup')} description={told} height={420} />
      <p class="small quiet">{told} {t('legend')}</p>
    </section>
  );
}

interface Row { k: number; stop: Stop; caught: Caught[number] | undefined }
const most_rows = 400;

function StopList({ lengths, caught, stops, capture }: Shared & { stops: readonly Stop[] }) {
  const found = new Map(caught.map((one) => [one.stop, one]));
  const last = caught.reduce((most, { stop }) => Math.max(most, stop), 0);
  const first = stops.length <= most_rows ? 0 : Math.min(Math.max(0, (lengths.due ?? last) - most_rows / 2), stops.length - most_rows);
  const rows = stops.slice(first, first + most_rows).map((stop, i): Row => ({ k: first + i + 1, stop, caught: found.get(first + i + 1) }));
  const state = (row: Row) => {
    if (row.caught) return row.caught.begins_segment ? t('new_path') : t('is_caught');
    if (row.k === lengths.due) return <strong>{t('is_due')}</strong>;
    return <span class="quiet">{row.k < last || is_over(capture) ? t('passed_over') : t('to_come')}</span>;
  };
  // Of one that ended in another life of the program only the table is known.
  if (is_over(capture) && caught.length === 0) return null;
  return (
    <section class="panel stop-list" aria-labelledby="length-list">
      <h2 id="length-list">{t('list')}</h2>
      {rows.length < stops.length && <p class="small quiet">{t('shown_about', { n: rows.length, all: stops.length })}</p>}
      <DataTable caption={t('lengths')} rows={rows} row_key={({ k }) => k} row_class={({ k }) => (k === lengths.due ? 'is-shown' : '')} columns={[
        { key: 'point', head: t('point'), row_head: true, cell: ({ stop }) => <>{stop.name} {lengths.kind === 'lines' && <span class="quiet small">{stop.group}</span>}</> },
        { key: 'length', head: `${t('length')} (mm)`, number: true, cell: (row) => (row.caught ? fixed(row.caught.length_mm, 4) : absent) },
        { key: 'scatter', head: `${t('scatter')} (µm)`, number: true, cell: (row) => (row.caught ? fixed(row.caught.scatter_um, 2) : absent) },
        { key: 'state', head: t('state'), cell: state },
      ]} />
      {!is_over(capture) && <p class="small quiet">{t('caught_as')}</p>}
    </section>
  );
}

function Notices({ notices }: { notices: readonly string[] }) {
  if (notices.length === 0) return null;
  return (
    <section class="panel wide" aria-labelledby="events">
      <h2 id="events">{t_capture('events')}</h2>
      <ul class="event-list" tabIndex={0} aria-labelledby="events">{notices.map((notice, k) => <li key={k}>{notice}</li>)}</ul>
    </section>
  );
}
