// SPDX-License-Identifier: Apache-2.0
// The one place that talks to the server.
import { actor, language } from '../settings';
import { reachable, signed_in } from './session';
import type { ErrorKind, Failure, ImportProfile, Receipt } from './types';

export class ApiError extends Error {
  constructor(readonly kind: ErrorKind | 'offline' | 'unauthorised' | 'kept', message: string, readonly status: number,
              readonly place: string = '', readonly receipt: Receipt | null = null) {
    super(message);
  }
}

/** Whatever was thrown. */
export const as_error = (thrown: unknown): ApiError => (thrown instanceof ApiError ? thrown : new ApiError('refused', String(thrown), 0));

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
    reachable.value = false;
    throw new ApiError('offline', '', 0);
  }
  reachable.value = true;
  if (response.ok) return response;
  const failure = (await response.json().catch(() => null)) as Failure | null;
  const found = failure?.error;
  const place = found?.line ? `${found.line}${found.column ? `:${found.column}` : ''}` : '';
  const kind = response.status === 401 ? 'unauthorised' : (found?.kind ?? 'refused');
  if (response.status === 401) signed_in.value = false;
  throw new ApiError(kind, found?.message ?? `${response.status} ${response.statusText}`, response.status, place);
}

export async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  const response = await answered(fetch(path, { headers: headers(), signal: signal ?? null }));
  return (await response.json()) as T;
}

/** The bytes at this path. */
export async function bytes_of(path: string): Promise<Blob> {
  return (await answered(fetch(path, { headers: headers() }))).blob();
}

const is_receipt = (content: unknown): content is Receipt => (content as Partial<Receipt> | null)?.kept === true;

/** What was kept and cannot be shown is answered by a receipt in its place, which says so. */
async function content_of<T>(response: Response): Promise<T> {
  const content = (await response.json()) as T | Receipt;
  if (is_receipt(content)) throw new ApiError('kept', content.message, response.status, '', content);
  return content;
}

/** An answer without content is null. */
export async function send<T>(method: 'POST' | 'PUT', path: string, body: unknown, signal?: AbortSignal): Promise<T> {
  const response = await answered(
    fetch(path, {
      method, body: JSON.stringify(body), headers: headers({ 'Content-Type': 'application/json' }), signal: signal ?? null,
    }),
  );
  return response.status === 204 ? (null as T) : content_of<T>(response);
}

interface Sending { signal?: AbortSignal; progress?: (part: number) => void; profile?: ImportProfile | null }

/** A file's bytes as they are; `progress` hears what part of them has gone, 0 to 1. A profile says how it is to be read. */
export async function upload<T>(path: string, file: File, { signal, progress, profile }: Sending = {}): Promise<T> {
  const all = profile ? headers() : headers({ 'Content-Type': file.type || 'application/octet-stream', 'X-File-Name': encodeURIComponent(file.name) });
  const body = profile ? form_of(file, profile) : file;
  // Only XMLHttpRequest tells how far it is.
  const sent = progress ? with_progress(path, body, all, progress, signal) : fetch(path, { method: 'POST', body, signal: signal ?? null, headers: all });
  return content_of<T>(await answered(sent));
}

function form_of(file: File, profile: ImportProfile): FormData {
  const form = new FormData();
  form.append('profile', JSON.stringify(profile));
  form.append('file', file, file.name);
  return form;
}

function with_progress(path: string, body: File | FormData, all: Record<string, string>, progress: (part: number) => void, signal?: AbortSignal): Promise<Response> {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open('POST', path);
    for (const [name, value] of Object.entries(all)) request.setRequestHeader(name, value);
    request.upload.onprogress = (event) => { if (event.lengthComputable) progress(event.loaded / event.total); };
    request.onload = () => resolve(new Response(request.responseText, { status: request.status, statusText: request.statusText }));
    request.onerror = () => reject(new TypeError('no answer'));
    request.onabort = () => reject(new DOMException('given up', 'AbortError'));
    if (signal?.aborted) { reject(new DOMException('given up', 'AbortError')); return; }
    signal?.addEventListener('abort', () => request.abort());
    request.send(body);
  });
}

/** What the server makes of a request that is no JSON: a program, a sheet. */
export async function made(path: string, body: unknown, signal?: AbortSignal): Promise<Response> {
  return answered(
    fetch(path, {
      method: 'POST', body: JSON.stringify(body), headers: headers({ 'Content-Type': 'application/json' }), signal: signal ?? null,
    }),
  );
}

/** The same of files, as a form with their names or a single one. */
export async function made_of_files(path: string, files: FormData | File, signal?: AbortSignal): Promise<Response> {
  const named: Record<string, string> = files instanceof FormData ? {}
    : { 'Content-Type': files.type || 'application/octet-stream', 'X-File-Name': encodeURIComponent(files.name) };
  return answered(fetch(path, { method: 'POST', body: files, headers: headers(named), signal: signal ?? null }));
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
