// SPDX-License-Identifier: Apache-2.0
// The lengths of captures that the address names (?captures=3,5), with the plan that they are of.
import { useEffect, useState } from 'preact/hooks';
import { type ApiError, as_error, get, made } from '../../api/client';
import type { CapturedPlan } from '../../api/types';
import { place } from '../../router';
import { t } from './length_texts';

export interface TakenLengths { file: File; plan: CapturedPlan['plan']; is_simulated: boolean; n: number }

const ids_of = (text: string): number[] => text.split(',').map(Number).filter((id) => Number.isInteger(id) && id > 0);

async function taken(ids: readonly number[], kind: CapturedPlan['kind'], signal: AbortSignal): Promise<TakenLengths | null> {
  const [table, captured] = await Promise.all([
    made('/api/captures/lengths', { captures: ids }, signal).then((answer) => answer.text()),
    get<CapturedPlan>(`/api/captures/${ids[0]}/plan`, signal),
  ]);
  if (captured.kind !== kind) return null;
  const is_simulated = table.includes('# Simulated, not measured');
  const name = `${t('from_captures', { n: ids.length })} ${ids.join('+')}.csv`;
  return { file: new File([table], name, { type: 'text/csv' }), plan: captured.plan, is_simulated, n: ids.length };
}

export function use_taken_lengths(kind: CapturedPlan['kind']): { taken: TakenLengths | null; error: ApiError | null } {
  const [found, set_found] = useState<TakenLengths | null>(null);
  const [error, set_error] = useState<ApiError | null>(null);
  const named = place.value.query.get('captures') ?? '';
  useEffect(() => {
    const ids = ids_of(named);
    set_error(null);
    if (ids.length === 0) return set_found(null);
    const abort = new AbortController();
    taken(ids, kind, abort.signal).then(
      (lengths) => { if (!abort.signal.aborted) set_found(lengths); },
      (failure: unknown) => { if (!abort.signal.aborted) set_error(as_error(failure)); },
    );
    return () => abort.abort();
  }, [named, kind]);
  return { taken: found, error };
}
