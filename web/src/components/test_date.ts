// SPDX-License-Identifier: Apache-2.0
import { texts } from '../i18n/texts';

const t = texts({
  undated: ['undated', 'ohne Datum'],
  simulated: ['simulated, no date', 'simuliert, ohne Datum'],
});

/** When a test was measured; in a simulated one stands instead that nothing was. */
export const test_date = (date: string | null | undefined): string =>
  !date ? t('undated') : date === 'None: simulated' ? t('simulated') : date;
