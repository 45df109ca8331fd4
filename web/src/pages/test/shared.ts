// SPDX-License-Identifier: Apache-2.0

/** `next`, with every part that equals its place in `before` taken from there: what is the same is not drawn again. */
export function shared<T>(before: T, next: T): T {
  if (Object.is(before, next)) return before;
  if (typeof before !== 'object' || typeof next !== 'object' || before === null || next === null) return next;
  if (Array.isArray(before) !== Array.isArray(next)) return next;
  const [old, now] = [before as Record<string, unknown>, next as Record<string, unknown>];
  const keys = Object.keys(now);
  let same = keys.length === Object.keys(old).length;
  for (const key of keys) {
    now[key] = shared(old[key], now[key]);
    same &&= key in old && Object.is(old[key], now[key]);
  }
  return same ? before : next;
}
