// SPDX-License-Identifier: Apache-2.0
// Pages by path; links are plain anchors, so that everything a browser does with links works.
import { signal } from '@preact/signals';
import type { ComponentChild } from 'preact';

export const place = signal({ path: location.pathname, query: new URLSearchParams(location.search) });

/** A page with unsaved work says so here; it is asked before it is left. */
export const unsaved = signal<string | null>(null);

function look(): void {
  place.value = { path: location.pathname, query: new URLSearchParams(location.search) };
}

export function go(to: string, how: 'push' | 'replace' = 'push'): void {
  if (how === 'push' && unsaved.value !== null && !confirm(unsaved.value)) return;
  if (how === 'push') unsaved.value = null;
  history[how === 'push' ? 'pushState' : 'replaceState'](null, '', to);
  const moved = location.pathname !== place.value.path;
  look();
  if (moved && how === 'push') window.scrollTo(0, 0);
}

window.addEventListener('popstate', () => {
  if (unsaved.value !== null && location.pathname !== place.value.path) {
    const left = new URL(place.value.path + (place.value.query.size > 0 ? `?${place.value.query}` : ''), location.origin);
    if (!confirm(unsaved.value)) { history.pushState(null, '', left); return; }
    unsaved.value = null;
  }
  look();
});
window.addEventListener('beforeunload', (event) => {
  if (unsaved.value !== null) event.preventDefault();
});
document.addEventListener('click', (event) => {
  if (event.defaultPrevented || event.button !== 0 || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
  const link = (event.target as Element).closest('a');
  if (!link || link.target || link.hasAttribute('download') || link.origin !== location.origin) return;
  if (link.pathname.startsWith('/api/')) return;
  if (link.hash !== '' && link.pathname === location.pathname && link.search === location.search) return;
  event.preventDefault();
  go(link.pathname + link.search + link.hash);
});

/** The path with these parts of its query changed; null takes one away. The browser's history keeps one entry. */
export function set_query(parts: Record<string, string | null>): void {
  const query = new URLSearchParams(place.value.query);
  for (const [key, value] of Object.entries(parts)) {
    if (value === null || value === '') query.delete(key);
    else query.set(key, value);
  }
  const text = query.toString();
  go(place.value.path + (text === '' ? '' : `?${text}`), 'replace');
}

export type Page = (props: { parts: Record<string, string> }) => ComponentChild;

/** The page whose pattern ("/tests/:id") fits the path, with its parts. */
export function routed(routes: readonly (readonly [string, Page])[], path: string): { page: Page; parts: Record<string, string> } | null {
  const given = path.split('/').filter((segment) => segment !== '');
  for (const [pattern, page] of routes) {
    const wanted = pattern.split('/').filter((segment) => segment !== '');
    if (wanted.length !== given.length) continue;
    const parts: Record<string, string> = {};
    const fits = wanted.every((segment, i) => {
      if (!segment.startsWith(':')) return segment === given[i];
      parts[segment.slice(1)] = given[i] as string;
      return true;
    });
    if (fits) return { page, parts };
  }
  return null;
}
