// SPDX-License-Identifier: Apache-2.0
// Plans that `axiometry plan` wrote, or another archive: chosen or dropped, and kept as they are.
import { useEffect, useRef, useState } from 'preact/hooks';
import { ApiError, as_error, send } from '../../api/client';
import { why_read_only } from '../../api/session';
import type { Plan } from '../../api/types';
import { go } from '../../router';
import { t } from './texts';

export interface Refused { name: string; error: ApiError }

const largest_plan = 4_000_000;   // bytes; what is longer is no plan, and need not be read

export async function keep_plan(file: File): Promise<Plan> {
  if (file.size > largest_plan) throw new ApiError('refused', t('no_plan_file', { n: Math.round(file.size / 1e6) }), 0);
  return send<Plan>('POST', '/api/plans', { title: '', axis: null, plan: await file.text() });
}

/** A button that takes plan files, and the page below it, on which they may be dropped. */
export function ImportPlans({ refused, done }: { refused: (files: Refused[]) => void; done: () => void }) {
  const input = useRef<HTMLInputElement>(null);
  const [busy, set_busy] = useState(false);
  const take = async (files: readonly File[]) => {
    if (files.length === 0) return;
    set_busy(true);
    const wrong: Refused[] = [];
    let last: Plan | null = null;
    for (const file of files) {
      try {
        last = await keep_plan(file);
      } catch (failure) {
        wrong.push({ name: file.name, error: as_error(failure) });
      }
    }
    set_busy(false);
    refused(wrong);
    if (last !== null && files.length === 1) go(`/plans/${last.id}`);
    else done();
  };
  useEffect(() => {
    const end = new AbortController();
    document.addEventListener('drop', (event) => {
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length === 0) return;
      event.preventDefault();   // the shell would take them for tests
      void take(files);
    }, end);
    return () => end.abort();
  }, []);
  const why = why_read_only();
  return (
    <>
      <button type="button" disabled={busy || why !== null} onClick={() => input.current?.click()}>{t('import')}</button>
      <input
        ref={input} type="file" multiple hidden accept=".json,application/json" aria-label={t('import')}
        onChange={(event) => {
          void take([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = '';   // the same file again is a new choice
        }}
      />
    </>
  );
}
