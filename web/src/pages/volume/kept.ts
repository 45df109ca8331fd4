// SPDX-License-Identifier: Apache-2.0
import { kept_form } from '../../kept_form';
import { new_form, type VolumeForm } from './form';

export const volume_kept = kept_form<VolumeForm>('volume', new_form, (kept, fresh) =>
  (Array.isArray(kept.low) && Array.isArray(kept.tools) && Array.isArray(kept.obstacles) ? { ...fresh, ...kept, texts: { ...fresh.texts, ...kept.texts } } : null));
