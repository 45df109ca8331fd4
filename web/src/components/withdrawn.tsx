// SPDX-License-Identifier: Apache-2.0
import { texts } from '../i18n/texts';

const t = texts({ withdrawn: 'withdrawn' });

/** Wherever results of a test are shown that is withdrawn. */
export function Withdrawn({ test }: { test: { withdrawn: boolean } }) {
  return test.withdrawn ? <span class="mark caution">{t('withdrawn')}</span> : null;
}
