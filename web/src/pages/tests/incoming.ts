// SPDX-License-Identifier: Apache-2.0
// Files that were chosen and are looked at, before anything is kept. They stay while other pages are visited.
import { effect, signal, untracked } from '@preact/signals';
import { ApiError, as_error, upload } from '../../api/client';
import { ask_health, health, returned } from '../../api/session';
import type { ImportProfile, Preview, Received } from '../../api/types';
import { bytes } from '../../numbers';
import { t } from './texts';

export interface Incoming {
  key: number;
  file: File;
  state: 'waiting' | 'reading' | 'ready' | 'keeping' | 'kept';
  part: number;                // of the bytes that have gone, 0 to 1
  profile: ImportProfile | null;  // what was said of its columns
  preview: Preview | null;
  received: Received | null;
  error: ApiError | null;      // of the last request; what was before it stays. Of what was kept: that it cannot be shown
}

export const incoming = signal<readonly Incoming[]>([]);
/** Goes up when something was kept: the list is asked again. */
export const kept_count = signal(0);

const running = new Map<number, AbortController>();
let next_key = 1;
const at_once = 2;  // reading a large file keeps the server busy; others of the team use it too

function change(key: number, to: Partial<Incoming>): void {
  incoming.value = incoming.value.map((one) => (one.key === key ? { ...one, ...to } : one));
}

export function add_files(files: readonly File[]): void {
  incoming.value = [
    ...incoming.value,
    ...files.map((file): Incoming => ({ key: next_key++, file, state: 'waiting', part: 0, profile: null, preview: null, received: null, error: hopeless(file) })),
  ];
  read_next();
}

/** What need not be sent to know that it will be refused. */
function hopeless(file: File): ApiError | null {
  if (file.size === 0) return new ApiError('bad_input', t('empty_file'), 422);
  const limit = health.value?.limits.upload_bytes ?? Infinity;
  return file.size > limit ? new ApiError('bad_input', t('too_large', { size: bytes(file.size), limit: bytes(limit) }), 413) : null;
}

function read_next(): void {
  const busy = incoming.value.filter((one) => one.state === 'reading').length;
  const due = incoming.value.filter((one) => one.state === 'waiting' && one.error === null).slice(0, Math.max(0, at_once - busy));
  for (const one of due) void read(one);
}

async function transfer<T>(one: Incoming, path: string): Promise<T | ApiError | null> {
  const abort = new AbortController();
  running.set(one.key, abort);
  let last = 0;
  try {
    const progress = (part: number) => {
      if (part - last < 0.02 && part < 1) return;
      last = part;
      change(one.key, { part });
    };
    return await upload<T>(path, one.file, { signal: abort.signal, progress, profile: one.profile });
  } catch (failure) {
    if (abort.signal.aborted) return null;
    return as_error(failure);
  } finally {
    running.delete(one.key);
  }
}

async function read(one: Incoming): Promise<void> {
  change(one.key, { state: 'reading', error: null, part: 0 });
  const answer = await transfer<Preview>(one, '/api/preview');
  if (answer instanceof ApiError) change(one.key, { state: 'waiting', error: answer });
  else if (answer !== null) change(one.key, { state: 'ready', preview: answer });
  read_next();
}

/** Reads a file again, by what is said of its columns. */
export function read_by(key: number, profile: ImportProfile): void {
  change(key, { profile });
  const one = incoming.value.find((other) => other.key === key);
  if (one) void read(one);
}

/** Whether nothing is wrong with a file but that a person has to say something about it. A table of a known format that
    is refused has a fault, which is said first. */
export const is_asked = (one: Incoming): boolean =>
  one.preview?.refused != null && (one.preview.format?.id ?? 'generic') === 'generic' && one.profile === null && (one.preview.table?.questions.length ?? 0) > 0;

/** Not yet in the archive under another name. */
export const is_new = (one: Incoming): boolean => one.preview === null || one.preview.same_content.length === 0;

/** Whether trying again may help: the same bytes are refused again. */
export const may_retry = (one: Incoming): boolean =>
  one.state === 'waiting' && one.error !== null && ['offline', 'unavailable', 'unauthorised', 'full'].includes(one.error.kind);

/** Asks again for a file whose preview failed. */
export function retry(key: number): void {
  const one = incoming.value.find((other) => other.key === key);
  if (one) void read(one);
}

/** Gives what the server answered; null when it failed or cannot show what it kept, which the file's entry then says. */
export async function keep(key: number): Promise<Received | null> {
  const one = incoming.value.find((other) => other.key === key);
  if (!one || one.state !== 'ready') return null;
  change(key, { state: 'keeping', error: null, part: 0 });
  const answer = await transfer<Received>(one, '/api/tests');
  if (answer === null || (answer instanceof ApiError && answer.kind !== 'kept')) {
    change(key, { state: 'ready', error: answer });
    return null;
  }
  const shown = answer instanceof ApiError ? { received: null, error: answer } : { received: answer, error: null };
  change(key, { state: 'kept', ...shown });
  kept_count.value += 1;
  void ask_health();
  return shown.received;
}

/** All that is new, one after the other, so that their order in the list is that of the files. */
export async function keep_all(): Promise<void> {
  for (const one of incoming.value.filter((file) => can_be_kept(file) && is_new(file))) await keep(one.key);
}

export const can_be_kept = (one: Incoming): boolean => one.state === 'ready' && one.preview !== null && one.preview.refused === null;

export function remove(key: number): void {
  running.get(key)?.abort();
  incoming.value = incoming.value.filter((one) => one.key !== key);
  read_next();
}

export function remove_all(): void {
  for (const one of incoming.value) running.get(one.key)?.abort();
  incoming.value = [];
}

// A lost server is back: what it could not answer is no longer wrong, and what waited for it goes on.
effect(() => {
  if (returned.value === 0) return;
  untracked(() => {
    incoming.value = incoming.value.map((one) => (one.error?.kind === 'offline' || one.error?.kind === 'unauthorised' ? { ...one, error: null } : one));
    read_next();
  });
});
