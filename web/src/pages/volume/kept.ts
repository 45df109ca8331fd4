// SPDX-License-Identifier: Apache-2.0
// What was typed stays in this browser: a calibration takes hours, and the page may be closed meanwhile.
import { new_form, type VolumeForm } from './form';

const key = 'axiometry.volume';

export function kept_volume(): VolumeForm {
  const fresh = new_form();
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? 'null') as VolumeForm | null;
    if (!kept || !Array.isArray(kept.low) || !Array.isArray(kept.tools) || !Array.isArray(kept.obstacles)) return fresh;
    return { ...fresh, ...kept, texts: { ...fresh.texts, ...kept.texts } };
  } catch {
    return fresh; // a browser may forbid it, or another program have written there
  }
}

/** When somebody signs out. */
export function forget_volume(): void {
  try {
    localStorage.removeItem(key);
  } catch {
    // see above
  }
}

export function keep_volume(form: VolumeForm): void {
  try {
    localStorage.setItem(key, JSON.stringify(form));
  } catch {
    // see above
  }
}
