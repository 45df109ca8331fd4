// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them: the user's decimal mark, a true minus sign, never "−0.0".
import { decimal } from './settings';

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

/**
 * Decimals of a parameter among others: one, and more where it would lose its two leading digits, as 0.012 µm of a stage;
 * but none beyond those of its uncertainty.
 */
export function figure_decimals(value: number, U: number | null): number {
  const needed = (x: number) => (x === 0 ? 1 : Math.min(4, Math.max(1, 1 - Math.floor(Math.log10(Math.abs(x))))));
  return U === null ? needed(value) : Math.min(needed(value), needed(U));
}

/** Decimals of a number as it is written, with either mark. */
export const decimals_of = (text: string): number => /[.,](\d+)$/.exec(text)?.[1]?.length ?? 0;

export const unit_sign = (unit: 'um' | 'arcsec'): string => (unit === 'um' ? 'µm' : '″');
export const position_unit = (kind: 'linear' | 'rotary'): string => (kind === 'linear' ? 'mm' : '°');

/** "2026-11-22" stays what it is; a time of the archive becomes local, to the minute: "2026-11-22 10:30". */
export function when(text: string): string {
  const time = new Date(text);
  if (!text.includes('T') || Number.isNaN(time.getTime())) return text;
  return new Date(time.getTime() - time.getTimezoneOffset() * 60_000).toISOString().slice(0, 16).replace('T', ' ');
}

export function bytes(size: number): string {
  if (size < 1000) return `${size} B`;
  const step = size < 1e6 ? 1e3 : size < 1e9 ? 1e6 : 1e9;
  return `${fixed(size / step, 1)} ${step === 1e3 ? 'kB' : step === 1e6 ? 'MB' : 'GB'}`;
}

/** "100 000": groups of three parted by a narrow space that does not break. */
export const count = (n: number): string => String(n).replace(/\B(?=(\d{3})+(?!\d))/g, '\u202f');
