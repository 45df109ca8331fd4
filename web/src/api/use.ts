// SPDX-License-Identifier: Apache-2.0
import { useCallback, useEffect, useState } from 'preact/hooks';
import { language } from '../settings';
import { type ApiError, as_error, get } from './client';
import { returned } from './session';

export interface Loaded<T> {
  data: T | null;
  error: ApiError | null;
  loading: boolean;
  reload: () => void;
  set: (data: T) => void; // after a change that answers with the whole
}

/**
 * What the server says at this path, asked again when the path or the language changes, and when a lost server is back.
 * null asks nothing. Until a new answer is there, the old one stays.
 */
export function use_get<T>(path: string | null): Loaded<T> {
  const [data, set_data] = useState<T | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const [loading, set_loading] = useState(path !== null);
  const [turn, set_turn] = useState(0);
  const spoken = language.value;
  const back = returned.value;
  useEffect(() => {
    if (path === null) return;
    const abort = new AbortController();
    set_loading(true);
    get<T>(path, abort.signal).then(
      (answer) => { set_data(answer); set_error(null); set_loading(false); },
      (failure: unknown) => {
        if (abort.signal.aborted) return;
        set_error(as_error(failure));
        set_loading(false);
      },
    );
    return () => abort.abort();
  }, [path, spoken, turn, back]);
  const reload = useCallback(() => set_turn((n) => n + 1), []);
  return { data, error, loading, reload, set: set_data };
}
