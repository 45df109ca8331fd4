// SPDX-License-Identifier: Apache-2.0
// What a user chooses for this browser: language, decimal mark, theme, and the name that changes are made under.
import { computed, effect, signal, type Signal } from '@preact/signals';
import type { Language } from './api/types';
import { language_of, languages } from './i18n/languages';

export type { Language } from './api/types';
export type Theme = 'system' | 'light' | 'dark';
export type Decimal = 'point' | 'comma';

function kept<T extends string>(key: string, first: T, allowed: readonly T[] | null): Signal<T> {
  const stored = read(key) as T | null;
  const value = signal<T>(stored !== null && (allowed === null || allowed.includes(stored)) ? stored : first);
  effect(() => write(key, value.value));
  return value;
}

/** A browser may forbid to keep anything: then choices last as long as the page. */
function read(key: string): string | null {
  try {
    return localStorage.getItem(`axiometry.${key}`);
  } catch {
    return null;
  }
}
function write(key: string, value: string): void {
  try {
    if (value === '') localStorage.removeItem(`axiometry.${key}`);
    else localStorage.setItem(`axiometry.${key}`, value);
  } catch {
    // see read()
  }
}

const browser_language = language_of(navigator.language);

export const language = kept<Language>('language', browser_language, languages);
export const decimal = kept<Decimal>('decimal', browser_language === 'en' ? 'point' : 'comma', ['point', 'comma']);
export const theme = kept<Theme>('theme', 'system', ['system', 'light', 'dark']);
export const actor = kept<string>('actor', '', null);
/** Months after which each axis of a machine is due for its next test; "0": never. */
export const due_months = kept<string>('due_months', '12', ['0', '3', '6', '12', '18', '24', '36']);

const dark_system = window.matchMedia('(prefers-color-scheme: dark)');
const system_is_dark = signal(dark_system.matches);
dark_system.addEventListener('change', (event) => (system_is_dark.value = event.matches));

/** The theme on the screen, whether or not the page is printed just now. */
export const screen_theme = computed<'light' | 'dark'>(() => (theme.value === 'system' ? (system_is_dark.value ? 'dark' : 'light') : theme.value));

/** The theme that is shown; charts and figures that are pictures ask for it. */
export const shown_theme = signal<'light' | 'dark'>('light');

// Paper is white: charts and figures are drawn for it while the page is printed.
export const printing = signal(false);
window.addEventListener('beforeprint', () => (printing.value = true));
window.addEventListener('afterprint', () => (printing.value = false));

effect(() => {
  shown_theme.value = printing.value ? 'light' : screen_theme.value;
  document.documentElement.dataset['theme'] = shown_theme.value;
  document.documentElement.lang = language.value;
});
