// SPDX-License-Identifier: Apache-2.0
// Unsaved edits survive a reload, a closed lid and the back button: this tab keeps them until they are saved or discarded.
import type { Changes, Options } from '../../api/types';

export interface KeptDraft { base_version: number; title: string; changes: Changes; options: Options }

const name_start = 'axiometry.draft.';
const name = (test: number): string => `${name_start}${test}`;

/** A browser may forbid to keep anything; then a draft lasts as long as the page. */
export function keep_draft(test: number, draft: KeptDraft | null): void {
  try {
    if (draft === null) sessionStorage.removeItem(name(test));
    else sessionStorage.setItem(name(test), JSON.stringify(draft));
  } catch {
    // see above
  }
}

/** Of every test. */
export function forget_drafts(): void {
  try {
    for (const key of Object.keys(sessionStorage)) if (key.startsWith(name_start)) sessionStorage.removeItem(key);
  } catch {
    // see above
  }
}

export function kept_draft(test: number): KeptDraft | null {
  try {
    const text = sessionStorage.getItem(name(test));
    return text === null ? null : (JSON.parse(text) as KeptDraft);
  } catch {
    return null;
  }
}
