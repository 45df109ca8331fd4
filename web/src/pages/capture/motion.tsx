// SPDX-License-Identifier: Apache-2.0
// A capture of a straightness or a rotation while it goes on: the target that is due, the running value, what a person says.
import { useEffect, useRef, useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import type { Capture, CapturedMotion, Plan, StopKey } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { fixed, unit_sign, when } from '../../numbers';
import { go } from '../../router';
import { LiveChart, LiveTable } from './filling';
import { directions_of, is_over, use_screen_on, type Live } from './live';
import { t } from './motion_texts';
import { Readout } from './readout';
import { StopButton } from './stop';
import { has_table, TableEnding } from './table_ending';
import { t as t_capture } from './texts';
import { Events, Said } from './told';

type Key = StopKey['key'];
interface Props { live: Live; capture: Capture; motion: CapturedMotion; plan: Plan | null; again: () => void }

export const evaluation_of = (capture: Capture): string => `/motions?capture=${capture.id}`;

export function MotionCapture({ live, capture, motion, plan, again }: Props) {
  const running = !is_over(capture);
  use_screen_on(running);
  use_evaluation_opened(capture);
  const unit = unit_sign(capture.unit);
  const { readings } = live;
  const runs = Math.max(plan?.plan.runs ?? 1, capture.due?.run ?? 1, ...readings.map(({ run }) => run));
  const shared = { readings, targets: capture.targets, unit: 'mm', deviation_unit: unit, runs };
  const directions = directions_of(capture.approaches, capture.targets.length, runs);
  return (
    <>
      <header class="page-head">
        <div>
          <h1 tabIndex={-1}>{t('title', { error: motion.error })}</h1>
          <p class="crumb">{plan && `${plan.title} · `}{capture.source.title} · {t_capture('started')} {when(capture.started)}{running && ` · ${t_capture(capture.state)}`}</p>
        </div>
        {running && <StopButton capture={capture} what={t('stop_what', { n: capture.taken, all: capture.approaches })} stopped={live.set} />}
      </header>
      {live.error && <FailureNotice error={live.error} />}
      {live.lost && <p class="notice caution offline" role="status">{t_capture('lost')}</p>}
      {capture.source.kind === 'simulator' && (
        <p class="notice">{t('simulated')}{running && motion.stops === 'keys' && ` ${t('axis_waits')}`}</p>
      )}
      {!running && (
        <TableEnding
          capture={capture} again={again} only_raw={t('only_raw')} table={t('table_file')} discard_what={t('discard_what')}
          kept={t('kept', { n: motion.end?.found ?? 0, all: capture.approaches })}
        >
          {has_table(capture) && <a class="button primary" href={evaluation_of(capture)}>{t('evaluate')}</a>}
        </TableEnding>
      )}
      <div class="live">
        <Readout capture={capture} {...shared} where={running && <RunningValue motion={motion} axis={capture.now} unit={unit} />} />
        {running && <StopKeys capture={capture} motion={motion} />}
        <LiveChart {...shared} due={capture.due} read={motion.error} />
        <aside class="stack"><Events capture={capture} /></aside>
        <LiveTable {...shared} due={capture.due} directions={directions} />
      </div>
      <Said readings={readings} unit={unit} />
    </>
  );
}

/** Who watches it to its end is led on to what its readings come to. */
function use_evaluation_opened(capture: Capture): void {
  const seen_running = useRef(false);
  const opens = capture.state === 'complete' && has_table(capture) && capture.taken === capture.approaches;
  useEffect(() => {
    if (!is_over(capture)) seen_running.current = true;
    else if (opens && seen_running.current) go(evaluation_of(capture));
  }, [capture.state, opens]);
}

function RunningValue({ motion: { now, is_reading, waits_for_key }, axis, unit }: { motion: CapturedMotion; axis: Capture['now']; unit: string }) {
  if (now === null) return <p class="where motion">{t('no_reading')}</p>;
  return (
    <div class="where">
      <p class="position number">{fixed(now, 2)}<span class="unit"> {unit}</span></p>
      <p class={`motion ${is_reading ? 'rest' : 'moving'}`} role="status">{t(is_reading ? 'is_reading' : waits_for_key ? 'waits' : 'running_value')}</p>
      {axis && <p class="quiet number simulated-axis">{axis.at_rest ? t('axis_stands', { position: fixed(axis.position, 3) }) : t('axis_moves')}</p>}
    </div>
  );
}

/** Enter takes a reading where it does nothing else. */
const is_free_enter = (event: KeyboardEvent): boolean =>
  event.key === 'Enter' && !event.repeat && !event.ctrlKey && !event.altKey && !event.metaKey && !document.querySelector('dialog[open]')
  && !(event.target instanceof Element && event.target.closest('a, button, input, select, textarea, summary, dialog'));

function StopKeys({ capture, motion }: { capture: Capture; motion: CapturedMotion }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const by_keys = motion.stops === 'keys';
  const all_read = by_keys && capture.due === null;
  const may_take = (by_keys || motion.waits_for_key) && !motion.is_reading && capture.due !== null;
  const say = (key: Key) => {
    set_error(null);
    send<Capture>('POST', `/api/captures/${capture.id}/keys`, { key }).catch((failure: unknown) =>
      set_error(as_error(failure)));
  };
  useEffect(() => {
    if (!may_take) return;
    const pressed = (event: KeyboardEvent) => {
      if (!is_free_enter(event)) return;
      event.preventDefault();
      say('take');
    };
    document.addEventListener('keydown', pressed);
    return () => document.removeEventListener('keydown', pressed);
  }, [may_take, capture.id]);
  if (motion.stops === 'position') return null;
  return (
    <section class="panel stop-keys" aria-label={t('what_is_said')}>
      {motion.waits_for_key && <p class="notice caution" role="status">{t('waits_what')}</p>}
      <div class="row">
        {(by_keys || motion.waits_for_key) && (
          <button type="button" class="primary" disabled={!may_take} onClick={() => say('take')}>{t(motion.waits_for_key ? 'is_this' : 'take')}</button>
        )}
        <button type="button" disabled={capture.due === null} onClick={() => say('skip')}>{t('skip')}</button>
        <button type="button" disabled={capture.taken === 0 && !motion.is_reading && capture.events.length === 0} onClick={() => say('undo')}>{t('undo')}</button>
      </div>
      {by_keys && !all_read && <p class="small quiet">{t('take_hint')}</p>}
      {all_read && <p class="small" role="status">{t('all_read')}</p>}
      {error && <FailureNotice error={error} />}
    </section>
  );
}
