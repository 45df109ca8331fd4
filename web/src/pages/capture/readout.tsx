// SPDX-License-Identifier: Apache-2.0
// What is read from two metres away: where the axis is, whether it rests, where it goes next.
import type { ComponentChildren } from 'preact';
import type { Capture } from '../../api/types';
import { fixed } from '../../numbers';
import { lasting } from '../plan/outcome';
import { is_over, type Reading } from './live';
import { t } from './texts';

export const arrow = (direction: 'up' | 'down'): string => (direction === 'up' ? '↑' : '↓');

interface Props {
  capture: Capture; readings: Reading[]; targets: number[]; runs: number; unit: string; deviation_unit: string;
  where?: ComponentChildren; // in place of the position
}

export function Readout({ capture, readings, targets, runs, unit, deviation_unit, where }: Props) {
  const { now, due } = capture;
  const target = due ? (due.position ?? targets[due.target - 1]) : undefined;
  const last = readings[readings.length - 1];
  return (
    <section class={`panel readout ${now === null && is_over(capture) ? 'ended' : ''}`} aria-label={t('position')}>
      {where !== undefined ? where : now
        ? <Where position={now.position} unit={unit} rest={now.at_rest} />
        : !is_over(capture) && <p class="where motion">{t('no_position')}</p>}
      <div class="next">
        <p class="name">{t(due ? 'next' : 'last')}</p>
        {due && target !== undefined && (
          <>
            <p class="large number"><span>{due.target} {arrow(due.direction)}</span> <span class="unit">{fixed(target, 3)} {unit}</span></p>
            <p class="number quiet">
              <span>{t('run_of', { run: due.run, runs })}</span>
              {now && <> · <span>{t('to_go')} {fixed(target - now.position, 3)} {unit}</span></>}
            </p>
          </>
        )}
        {!due && last && (
          <p class="large number"><span>{last.target} {arrow(last.direction)}</span> <span class="unit">{fixed(last.deviation, 2)} {deviation_unit}</span></p>
        )}
      </div>
      <Progress capture={capture} done={readings.length} />
    </section>
  );
}

export function Where({ position, unit, rest }: { position: number; unit: string; rest: boolean }) {
  return (
    <div class="where">
      <p class="position number">{fixed(position, 3)}<span class="unit"> {unit}</span></p>
      <p class={`motion ${rest ? 'rest' : 'moving'}`}>
        <svg viewBox="0 0 24 24" aria-hidden="true">
          {rest ? <path d="M5 5h14v14H5z" fill="currentColor" /> : <path d="M3 12h15M12 5l7 7-7 7" fill="none" stroke="currentColor" stroke-width="3" />}
        </svg>
        {t(rest ? 'at_rest' : 'moving')}
      </p>
    </div>
  );
}

export function Progress({ capture, done }: { capture: Capture; done: number }) {
  const elapsed_s = (Date.now() - Date.parse(capture.started)) / 1000;
  const left = capture.approaches - done;
  const tells = capture.state === 'running' && done >= 5 && left > 0;
  return (
    <div class="progress">
      <p class="row spread number">
        <span>{t('readings')} <strong>{t('done', { n: done, all: capture.approaches })}</strong></span>
        <span class="quiet">{tells ? t('left', { time: lasting((elapsed_s / done) * left) }) : !is_over(capture) && t(capture.state)}</span>
      </p>
      <progress aria-label={t('progress')} max={capture.approaches} value={done} />
    </div>
  );
}
