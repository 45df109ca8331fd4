// SPDX-License-Identifier: Apache-2.0
// Whether the server answers and knows this browser; what it says of its store.
import { effect, signal } from '@preact/signals';
import { language } from '../settings';
import type { Health, HealthStatus } from './types';

/** False while the last request got no answer. */
export const reachable = signal(true);

/** False when the server wants a token that this browser has not given. */
export const signed_in = signal(true);

/** Goes up when the server is back, has let this browser in, or has kept what it could not show: what is shown is asked
    for again. */
export const returned = signal(0);

export const health = signal<Health | null>(null);

/** Why nothing can be kept, in words of the server; null where it can. */
export const why_read_only = (): string | null => {
  const store = health.value?.store;
  return store && !store.writable ? (store.why_not ?? '') : null;
};

/** Asks how the server is, past the client: this must not look like one more lost connection. */
export async function ask_health(): Promise<void> {
  try {
    const response = await fetch('/api/health', { headers: { 'Accept-Language': language.value } });
    if (response.ok) {
      // Who has not shown the token is told the status alone.
      const told = (await response.json()) as Health | HealthStatus;
      health.value = 'program' in told ? told : null;
      signed_in.value = health.value !== null;
    }
    const back = !reachable.value;
    reachable.value = true;
    if (back) returned.value += 1;
  } catch {
    reachable.value = false;
  }
}

// A lost server is asked for every two seconds until it is back; the network's own signal is faster where there is one.
let timer: ReturnType<typeof setInterval> | null = null;
effect(() => {
  if (!reachable.value && timer === null) timer = setInterval(() => void ask_health(), 2000);
  if (reachable.value && timer !== null) { clearInterval(timer); timer = null; }
});
window.addEventListener('online', () => void ask_health());
effect(() => { void language.value; void ask_health(); });
