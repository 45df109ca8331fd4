// SPDX-License-Identifier: Apache-2.0
// The readings of a capture that the address names (?capture=3).
import { type ApiError, as_error, bytes_of, get } from '../../api/client';
import type { Capture } from '../../api/types';
import { when } from '../../numbers';
import { place } from '../../router';

async function captured(id: string): Promise<File> {
  const path = `/api/captures/${encodeURIComponent(id)}`;
  const [capture, bytes] = await Promise.all([get<Capture>(path), bytes_of(`${path}/files/readings`)]);
  return new File([bytes], `${capture.motion?.error ?? id} ${when(capture.started).replace(':', '')}.csv`);
}

export function take_captured(take: (files: readonly File[]) => void, failed: (error: ApiError) => void): void {
  const id = place.value.query.get('capture') ?? '';
  if (id === '') return;
  captured(id).then(
    (file) => take([file]),
    (failure: unknown) => failed(as_error(failure)),
  );
}
