// SPDX-License-Identifier: Apache-2.0
import { ApiError, get, send } from '../../api/client';
import type { CompensationRevision, KeptCompensation } from '../../api/types';

/**
 * A new version. A conflict is somebody else's version only where there is one: the program also refuses where it would
 * make another table of the test today, and then its own words are all that is to be said.
 */
export async function revise(found: KeptCompensation, revision: Omit<CompensationRevision, 'base_version'>): Promise<KeptCompensation> {
  const path = `/api/compensations/${found.id}`;
  try {
    return await send<KeptCompensation>('POST', `${path}/versions`, { ...revision, base_version: found.version });
  } catch (error) {
    if (!(error instanceof ApiError) || error.kind !== 'conflict') throw error;
    const latest = await get<KeptCompensation>(path).catch(() => null);
    throw latest !== null && latest.version > found.version ? error : new ApiError('refused', error.message, error.status, error.place);
  }
}
