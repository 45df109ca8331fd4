// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them: the user's decimal mark, a true minus sign, never "−0.0".
import { decimal, language } from './settings';

export const absent = '–';

export function fixed(value: number | null | undefined, decimals: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return absent;
  return marked(value.toFixed(decimals));
}

/** As many decimals as the number needs, at most that many: a target "12.5", not "12.500". */
export function shortest(value: number | null | undefined, decimals = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return absent;
  return marked(String(Number(value.toFixed(decimals))));
}

/** A number that the program wrote with a decimal point, in the user's decimal mark. */
export function marked(text: string): string {
  const positive_zero = /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
  const minus = positive_zero.replace(/^-/, '\u2212');
  return decimal.value === 'comma' ? minus.replace('.', ',') : minus;
}

/** The number that a user typed with either decimal mark; null when it is none. */
export function parsed(text: string): number | null {
  const plain = text.trim().replace('\u2212', '-').replace(',', '.');
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : null;
}

/** A number as the user would type it; nothing for none. */
export const typed = (value: number | null | undefined): string =>
  value === null || value === undefined ? '' : decimal.value === 'comma' ? String(value).replace('.', ',') : String(value);

/** Decimals that leave a size so many leading digits as it is then shown: 0.0996 has two of them in 0.10. */
export function decimals_for(size: number, digits: number): number {
  if (!(size > 0)) return 0;
  const needed = (x: number) => Math.min(Math.max(digits - 1 - Math.floor(Math.log10(x)), 0), 9);
  const first = needed(size);
  const shown = Math.round(size * 10 ** first) / 10 ** first;
  return shown > 0 ? Math.min(needed(shown * (1 + 1e-12)), first) : first;
}

/** Decimals of a number as it is written, with either mark. */
export const decimals_of = (text: string): number => /[.,](\d+)$/.exec(text)?.[1]?.length ?? 0;

export const unit_sign = (unit: 'um' | 'arcsec' | 'urad'): string => (unit === 'um' ? 'µm' : unit === 'urad' ? 'µrad' : '″');
export const position_unit = (kind: 'linear' | 'rotary'): string => (kind === 'linear' ? 'mm' : '°');

/** "2026-11-22" stays what it is; a time of the archive becomes local, to the minute: "2026-11-22 10:30". */
export function when(text: string): string {
  const time = new Date(text);
  if (!text.includes('T') || Number.isNaN(time.getTime())) return text;
  return new Date(time.getTime() - time.getTimezoneOffset() * 60_000).toISOString().slice(0, 16).replace('T', ' ');
}

export function bytes(size: number): string {
  const byte = language.value === 'fr' ? 'o' : 'B';
  if (size < 1000) return `${size} ${byte}`;
  const step = size < 1e6 ? 1e3 : size < 1e9 ? 1e6 : 1e9;
  return `${fixed(size / step, 1)} ${step === 1e3 ? 'k' : step === 1e6 ? 'M' : 'G'}${byte}`;
}

/** "100 000": groups of three separated by a narrow space that does not break. */
export const count = (n: number): string => String(n).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
