// SPDX-License-Identifier: Apache-2.0
// What is typed on a page stays in this browser: a measurement takes hours, and the page may be closed meanwhile.

export interface KeptForm<T> {
  load: () => T;
  keep: (typed: T) => void;
  forget: () => void;     // when somebody signs out
}

/** Under that name; `whole` makes it of what is kept, with what is `fresh` for what that lacks, or null where it is none of its kind. */
export function kept_form<T>(name: string, fresh: () => T, whole: (kept: T, fresh: T) => T | null): KeptForm<T> {
  const key = `axiometry.${name}`;
  const load = (): T => {
    const anew = fresh();
    try {
      const kept = JSON.parse(localStorage.getItem(key) ?? 'null') as T | null;
      return (kept === null ? null : whole(kept, anew)) ?? anew;
    } catch {
      return anew; // a browser may forbid it, or another program have written there
    }
  };
  const change = (act: () => void): void => {
    try {
      act();
    } catch {
      // see above
    }
  };
  return { load, keep: (typed) => change(() => localStorage.setItem(key, JSON.stringify(typed))), forget: () => change(() => localStorage.removeItem(key)) };
}
