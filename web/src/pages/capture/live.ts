// SPDX-License-Identifier: Apache-2.0
// A capture as it goes on: asked again and again, readings gathered.
import { useEffect, useState } from 'preact/hooks';
import { ApiError, get } from '../../api/client';
import type { Capture } from '../../api/types';

export type Reading = Capture['readings'][number];
export type Caught = NonNullable<NonNullable<Capture['lengths']>['caught']>;
export type Direction = Reading['direction'];
export const is_over = (capture: Capture): boolean => ['complete', 'stopped', 'failed', 'interrupted'].includes(capture.state);

/** In which the targets are approached: as many approaches as targets and runs leave one direction only. */
export const directions_of = (approaches: number, targets: number, runs: number): readonly Direction[] =>
  approaches > targets * runs ? ['up', 'down'] : ['up'];

export interface Live {
  capture: Capture | null;
  readings: Reading[];
  caught: Caught;  // of lengths
  lost: boolean; // the program does not answer; what is shown is the last that was known
  error: ApiError | null; // it answered that it cannot
  set: (capture: Capture) => void;
}

const often_ms = 200;
const hidden_ms = 2000;
const longest_wait_ms = 5000;

/** `turn`: another number begins again, as after an interruption. */
export function use_live(id: string, turn: number): Live {
  const [known, set_known] = useState<{ capture: Capture; readings: Reading[]; caught: Caught } | null>(null);
  const [lost, set_lost] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  useEffect(() => {
    const abort = new AbortController();
    let timer = 0;
    let asking = false;
    let revision = 0;
    let failures = 0;
    let readings: Reading[] = [];
    let caught: Caught = [];
    const later = (wait: number) => {
      timer = window.setTimeout(ask, wait);
    };
    const take = (answer: Capture): void => {
      if (answer.revision < revision) {
        // Another run of the program, which counts from the beginning.
        [revision, readings, caught] = [0, [], []];
        return later(0);
      }
      if (answer.anew === true) readings = answer.readings;
      else if (answer.readings.length > 0) readings = [...readings, ...answer.readings];
      caught = answer.lengths?.caught ?? caught;
      revision = answer.revision;
      set_known({ capture: answer, readings, caught });
      if (!is_over(answer)) return later(document.hidden ? hidden_ms : often_ms);
      if (answer.state !== 'interrupted') return;
      revision = 0; // somebody else may go on with it, which counts from the beginning
      later(hidden_ms);
    };
    const ask = () => {
      asking = true;
      get<Capture>(`/api/captures/${id}?after=${revision}`, abort.signal).then(
        (answer) => {
          asking = false;
          failures = 0;
          set_lost(false);
          set_error(null);
          take(answer);
        },
        (failure: unknown) => {
          asking = false;
          if (abort.signal.aborted) return;
          if (failure instanceof ApiError && failure.kind !== 'offline' && failure.status < 500) return set_error(failure);
          failures += 1;
          set_lost(true);
          later(Math.min(longest_wait_ms, often_ms * 2 ** failures));
        },
      );
    };
    const seen = () => {
      if (document.hidden || asking) return;
      window.clearTimeout(timer);
      ask();
    };
    ask();
    document.addEventListener('visibilitychange', seen);
    return () => {
      abort.abort();
      window.clearTimeout(timer);
      document.removeEventListener('visibilitychange', seen);
    };
  }, [id, turn]);
  return {
    capture: known?.capture ?? null, readings: known?.readings ?? [], caught: known?.caught ?? [], lost, error,
    set: (capture) => set_known((before) => ({ capture, readings: before?.readings ?? [], caught: capture.lengths?.caught ?? before?.caught ?? [] })),
  };
}

/** The screen stays on while this is true, where the browser can. */
export function use_screen_on(wanted: boolean): void {
  useEffect(() => {
    if (!wanted || !('wakeLock' in navigator)) return;
    let held: WakeLockSentinel | null = null;
    let over = false;
    const hold = () => {
      if (document.hidden) return;
      navigator.wakeLock.request('screen').then(
        (lock) => {
          if (over) void lock.release();
          held = lock;
        },
        () => undefined, // low battery: then the screen does as it always does
      );
    };
    hold();
    document.addEventListener('visibilitychange', hold);
    return () => {
      over = true;
      document.removeEventListener('visibilitychange', hold);
      void held?.release();
    };
  }, [wanted]);
}
