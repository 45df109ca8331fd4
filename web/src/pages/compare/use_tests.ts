// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from 'preact/hooks';
import { type ApiError, as_error, get } from '../../api/client';
import type { Test } from '../../api/types';
import { decimal, language } from '../../settings';
import { test_path } from '../test/state';

export interface LoadedTest { id: number; test: Test | null; error: ApiError | null }

/** The tests of these numbers, each asked for once; those that are there stay while others come. */
export function use_tests(ids: readonly number[]): LoadedTest[] {
  const known = useRef(new Map<number, LoadedTest>());
  const asked = useRef(new Set<number>());
  const [, set_turn] = useState(0);
  const spoken = `${language.value} ${decimal.value}`;
  const list = ids.join();
  useEffect(() => {
    asked.current.clear();
  }, [spoken]);
  useEffect(() => {
    for (const id of ids) {
      if (asked.current.has(id)) continue;
      asked.current.add(id);
      const keep = (loaded: Omit<LoadedTest, 'id'>) => {
        known.current.set(id, { id, ...loaded });
        if (loaded.error) asked.current.delete(id);
        set_turn((n) => n + 1);
      };
      get<Test>(test_path(id)).then(
        (test) => keep({ test, error: null }),
        (error: unknown) => keep({ test: known.current.get(id)?.test ?? null, error: as_error(error) }),
      );
    }
  }, [list, spoken]);
  return ids.map((id) => known.current.get(id) ?? { id, test: null, error: null });
}
