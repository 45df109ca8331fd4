// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { type ApiError, as_error, send } from '../../api/client';
import { use_get } from '../../api/use';
import type { Capture, Plan } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { sentence } from '../../components/findings';
import { position_unit, unit_sign, when } from '../../numbers';
import { LiveChart, LiveTable } from './filling';
import { LengthsCapture } from './lengths';
import { directions_of, is_over, use_live, use_screen_on } from './live';
import { MotionCapture } from './motion';
import { Readout } from './readout';
import { SoFar } from './so_far';
import { StopButton } from './stop';
import { t } from './texts';
import { Events, Said } from './told';
import './capture.css';

/** A capture while it goes on, and what came of it. */
export function CapturePage({ parts }: { parts: Record<string, string> }) {
  const [turn, set_turn] = useState(0);
  const live = use_live(parts['id'] ?? '', turn);
  const { capture, readings } = live;
  const plan = use_get<Plan>(capture === null || capture.plan === null ? null : `/api/plans/${capture.plan}`);
  const running = capture !== null && !is_over(capture);
  use_screen_on(running);
  const deviation_unit = unit_sign(capture?.unit ?? 'um');
  const shared = {
    readings, targets: capture?.targets ?? plan.data?.targets ?? [], unit: position_unit(capture?.kind ?? 'linear'), deviation_unit,
    runs: Math.max(runs_of(plan.data, capture), ...readings.map(({ run }) => run)),
  };
  const directions = directions_of(capture?.approaches ?? 0, shared.targets.length, shared.runs);
  if (capture?.lengths) return <LengthsCapture live={live} capture={capture} lengths={capture.lengths} again={() => set_turn(turn + 1)} />;
  if (capture?.motion) return <MotionCapture live={live} capture={capture} motion={capture.motion} plan={plan.data} again={() => set_turn(turn + 1)} />;
  return (
    <>
      <header class="page-head">
        <div>
          <h1 tabIndex={-1}>{plan.data?.title ?? t('capture')}</h1>
          {capture && <p class="crumb">{capture.source.title} · {t('started')} {when(capture.started)}{running && ` · ${t(capture.state)}`}</p>}
        </div>
        {capture && running && <StopButton capture={capture} what={t('stop_what', { n: readings.length, all: capture.approaches })} stopped={live.set} />}
      </header>
      {live.error && <FailureNotice error={live.error} />}
      {plan.error && <FailureNotice error={plan.error} retry={plan.reload} />}
      {live.lost && <p class="notice caution offline" role="status">{t('lost')}</p>}
      {capture && is_over(capture) && <Ending capture={capture} again={() => set_turn(turn + 1)} />}
      {capture && shared.targets.length > 0 && (
        <div class="live">
          <Readout capture={capture} {...shared} />
          <LiveChart {...shared} due={capture.due} />
          <aside class="stack">
            <SoFar evaluated={capture.so_far} directions={directions} running={running} runs={shared.runs} />
            <Events capture={capture} />
          </aside>
          <LiveTable {...shared} due={capture.due} directions={directions} />
        </div>
      )}
      <Said readings={readings} unit={deviation_unit} />
    </>
  );
}

/** Of the plan, or of the part of it that is captured. */
function runs_of(plan: Plan | null, capture: Capture | null): number {
  const chosen = plan?.plan;
  const part = capture?.part ?? 1;
  return (part === 1 ? chosen?.runs : chosen?.further?.[part - 2]?.runs) ?? 1;
}

function Ending({ capture, again }: { capture: Capture; again: () => void }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const after = (request: Promise<Capture>) =>
    void request.then(again, (failure: unknown) => set_error(as_error(failure)));
  const tone = capture.state === 'failed' ? 'bad' : capture.state === 'complete' ? 'good' : 'caution';
  return (
    <div class={`notice ${tone} ending`} role="status">
      <div>
        <h2>{t(capture.state)}</h2>
        {capture.error !== null && <p>{sentence(capture.error)}</p>}
        <p>{t(capture.state === 'interrupted' ? 'broken_off' : capture.test === null ? 'nothing_kept' : 'kept')}</p>
        {error && <FailureNotice error={error} />}
      </div>
      {capture.state === 'interrupted' && (
        <div class="row">
          <button type="button" onClick={() => after(send<Capture>('POST', `/api/captures/${capture.id}/stop`, {}))}>{t('keep_so_far')}</button>
          <button type="button" class="primary" onClick={() => after(send<Capture>('POST', '/api/captures', { resume: capture.id }))}>{t('resume')}</button>
        </div>
      )}
      {capture.test !== null && <a class="button primary" href={`/tests/${capture.test}`}>{t('to_test')}</a>}
    </div>
  );
}
