// SPDX-License-Identifier: Apache-2.0
// What was typed stays in this browser: a measurement takes hours, and the page may be closed meanwhile.
import { new_form, type LocatedStation, type TrackingForm } from './form';

const key = 'axiometry.tracking';

export interface KeptPage { form: TrackingForm; located: LocatedStation | null }

export function kept_page(): KeptPage {
  const fresh: KeptPage = { form: new_form(), located: null };
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? 'null') as KeptPage | null;
    if (!kept || !Array.isArray(kept.form.low) || !Array.isArray(kept.form.obstacles)) return fresh;
    return { form: { ...fresh.form, ...kept.form, texts: { ...fresh.form.texts, ...kept.form.texts } }, located: kept.located };
  } catch {
    return fresh; // a browser may forbid it, or another program have written there
  }
}

/** When somebody signs out. */
export function forget_page(): void {
  try {
    localStorage.removeItem(key);
  } catch {
    // see above
  }
}

export function keep_page(page: KeptPage): void {
  try {
    localStorage.setItem(key, JSON.stringify(page));
  } catch {
    // see above
  }
}
