// SPDX-License-Identifier: Apache-2.0
import { useLayoutEffect, useState } from 'preact/hooks';
import { language } from '../settings';
import { type ApiError, as_error, made } from './client';
import { returned } from './session';

export interface Posted<T> {
  data: T | null;
  of: unknown; // the body that `data` answers
  is_current: boolean; // whether that says the same as the body of now, and nothing was refused
  error: ApiError | null;
  again: () => void;
}

/**
 * What the server makes of a body that changes while someone types: asked at once, and what is overtaken is given up.
 * The last good answer stays while the next is made or refused. null asks nothing.
 */
export function use_posted<T>(path: string, body: unknown, read: (response: Response) => Promise<T>): Posted<T> {
  const [answer, set_answer] = useState<{ data: T; of: unknown; key: string } | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const [turn, set_turn] = useState(0);
  const key = body === null ? null : JSON.stringify(body);
  const spoken = language.value;
  const back = returned.value;
  // Before the screen is drawn: a frame's time is a third of what a change may take.
  useLayoutEffect(() => {
    if (key === null) return;
    const abort = new AbortController();
    made(path, body, abort.signal).then(read).then(
      (data) => {
        if (abort.signal.aborted) return;
        set_answer({ data, of: body, key });
        set_error(null);
      },
      (failure: unknown) => {
        if (!abort.signal.aborted) set_error(as_error(failure));
      },
    );
    return () => abort.abort();
  }, [path, key, spoken, back, turn]);
  const is_current = answer !== null && error === null && answer.key === key;
  return { data: answer?.data ?? null, of: answer?.of ?? null, is_current, error, again: () => set_turn((n) => n + 1) };
}

export const as_json = <T,>(response: Response): Promise<T> => response.json() as Promise<T>;
export const as_text = (response: Response): Promise<string> => response.text();
