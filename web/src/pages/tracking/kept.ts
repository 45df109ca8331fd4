// SPDX-License-Identifier: Apache-2.0
import { kept_form } from '../../kept_form';
import { new_form, type LocatedStation, type TrackingForm } from './form';

export interface KeptPage { form: TrackingForm; located: LocatedStation | null }

export const tracking_kept = kept_form<KeptPage>('tracking', () => ({ form: new_form(), located: null }), ({ form, located }, fresh) =>
  (Array.isArray(form.low) && Array.isArray(form.obstacles) ? { form: { ...fresh.form, ...form, texts: { ...fresh.form.texts, ...form.texts } }, located } : null));
