// SPDX-License-Identifier: Apache-2.0
// A capture as it goes on: asked again and again, readings gathered.
import { useEffect, useState } from 'preact/hooks';
import { ApiError, get } from '../../api/client';
import type { Capture } from '../../api/types';

export type Reading = Capture['readings'][number];
export const is_over = (capture: Capture): boolean => ['complete', 'stopped', 'failed'].includes(capture.state);

export interface Live {
  capture: Capture | null;
  readings: Reading[];
  lost: boolean; // the program does not answer; what is shown is the last that was known
  error: ApiError | null; // it answered that it cannot
  set: (capture: Capture) => void;
}

const often_ms = 200;
const hidden_ms = 2000;
const longest_wait_ms = 5000;

export function use_live(id: string): Live {
  const [known, set_known] = useState<{ capture: Capture; readings: Reading[] } | null>(null);
  const [lost, set_lost] = useState(false);
  const [error, set_error] = useState<ApiError | null>(null);
  useEffect(() => {
    const abort = new AbortController();
    let timer = 0;
    let revision = 0;
    let restarts = 0;
    let failures = 0;
    let readings: Reading[] = [];
    const later = (wait: number) => {
      timer = window.setTimeout(ask, wait);
    };
    const take = (answer: Capture): void => {
      const begun_again = answer.events.filter(({ kind }) => kind === 'restarted').length;
      if (revision > 0 && (answer.revision < revision || begun_again !== restarts)) {
        // Readings that were known are void: all of them are asked for.
        [revision, readings, restarts] = [0, [], begun_again];
        return later(0);
      }
      restarts = begun_again;
      if (answer.readings.length > 0) readings = [...readings, ...answer.readings];
      revision = answer.revision;
      set_known({ capture: answer, readings });
      if (!is_over(answer) || answer.revision < answer.readings.length) later(document.hidden ? hidden_ms : often_ms);
    };
    const ask = () => {
      get<Capture>(`/api/captures/${id}?after=${revision}`, abort.signal).then(
        (answer) => {
          failures = 0;
          set_lost(false);
          set_error(null);
          take(answer);
        },
        (failure: unknown) => {
          if (abort.signal.aborted) return;
          if (failure instanceof ApiError && failure.kind !== 'offline' && failure.kind !== 'unavailable') return set_error(failure);
          failures += 1;
          set_lost(true);
          later(Math.min(longest_wait_ms, often_ms * 2 ** failures));
        },
      );
    };
    const seen = () => {
      if (document.hidden) return;
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
  }, [id]);
  return {
    capture: known?.capture ?? null, readings: known?.readings ?? [], lost, error,
    set: (capture) => set_known((before) => ({ capture, readings: before?.readings ?? [] })),
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
