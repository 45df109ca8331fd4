// SPDX-License-Identifier: Apache-2.0
// Dates as the archive writes them, "2026-11-22"; what cannot be read as one is text that only a person understands.

/** Seconds since 1970 at the beginning of that day in UTC; null when the text is no date. */
export function day_seconds(text: string): number | null {
  const parts = /^(\d{4})-(\d{2})-(\d{2})/.exec(text.trim());
  if (!parts) return null;
  const time = Date.UTC(Number(parts[1]), Number(parts[2]) - 1, Number(parts[3]));
  return Number.isNaN(time) ? null : time / 1000;
}

export const today = (): string => new Date(Date.now() - new Date().getTimezoneOffset() * 60_000).toISOString().slice(0, 10);

/** The same day so many months later; the last of the month where there is no such day. */
export function months_later(text: string, months: number): string | null {
  const seconds = day_seconds(text);
  if (seconds === null) return null;
  const date = new Date(seconds * 1000);
  const last = new Date(Date.UTC(date.getUTCFullYear(), date.getUTCMonth() + months + 1, 0)).getUTCDate();
  return new Date(Date.UTC(date.getUTCFullYear(), date.getUTCMonth() + months, Math.min(date.getUTCDate(), last))).toISOString().slice(0, 10);
}

/** Whole days from today; negative in the past; null when the text is no date. */
export function days_until(text: string): number | null {
  const [then, now] = [day_seconds(text), day_seconds(today())];
  return then === null || now === null ? null : Math.round((then - now) / 86_400);
}
