// SPDX-License-Identifier: Apache-2.0
// The one place that talks to the server.
import { actor, language } from '../settings';
import type { ErrorKind, Failure } from './types';

export class ApiError extends Error {
  constructor(readonly kind: ErrorKind | 'offline' | 'unauthorised', message: string, readonly status: number,
              readonly place: string = '') {
    super(message);
  }
}

function headers(more: Record<string, string> = {}): Record<string, string> {
  const all: Record<string, string> = { 'Accept-Language': language.value, ...more };
  if (actor.value !== '') all['X-Actor'] = encodeURIComponent(actor.value);
  return all;
}

async function answered(request: Promise<Response>): Promise<Response> {
  let response: Response;
  try {
    response = await request;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') throw error;
    throw new ApiError('offline', '', 0);
  }
  if (response.ok) return response;
  const failure = (await response.json().catch(() => null)) as Failure | null;
  const found = failure?.error;
  const place = found?.line ? `${found.line}${found.column ? `:${found.column}` : ''}` : '';
  const kind = response.status === 401 ? 'unauthorised' : (found?.kind ?? 'refused');
  throw new ApiError(kind, found?.message ?? `${response.status} ${response.statusText}`, response.status, place);
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  const response = await answered(fetch(path, { headers: headers(), signal: signal ?? null }));
  return (await response.json()) as T;
}

export async function send<T>(method: 'POST' | 'PUT', path: string, body: unknown, signal?: AbortSignal): Promise<T> {
  const response = await answered(
    fetch(path, {
      method, body: JSON.stringify(body), headers: headers({ 'Content-Type': 'application/json' }), signal: signal ?? null,
    }),
  );
  return (await response.json()) as T;
}

/** A file's bytes as they are. */
export async function upload<T>(path: string, file: File, signal?: AbortSignal): Promise<T> {
  const response = await answered(
    fetch(path, {
      method: 'POST', body: file, signal: signal ?? null,
      headers: headers({ 'Content-Type': file.type || 'application/octet-stream', 'X-File-Name': encodeURIComponent(file.name) }),
    }),
  );
  return (await response.json()) as T;
}

/** What the server makes of a request that is no JSON: a program, a sheet. */
export async function made(path: string, body: unknown, signal?: AbortSignal): Promise<Response> {
  return answered(
    fetch(path, {
      method: 'POST', body: JSON.stringify(body), headers: headers({ 'Content-Type': 'application/json' }), signal: signal ?? null,
    }),
  );
}

/** The same offered to the user as a file. */
export async function download_made(path: string, body: unknown, file_name: string): Promise<void> {
  offer(await (await made(path, body)).blob(), file_name);
}

/** Bytes that the page has, offered to the user as a file. */
export function offer(content: Blob, file_name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = file_name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** "?a=1&b=2" of what is given. */
export function query(parts: Record<string, string | number | boolean | null | undefined>): string {
  const given = Object.entries(parts).filter(([, value]) => value !== null && value !== undefined && value !== '');
  const text = new URLSearchParams(given.map(([key, value]) => [key, String(value)])).toString();
  return text === '' ? '' : `?${text}`;
}
