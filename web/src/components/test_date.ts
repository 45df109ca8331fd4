// SPDX-License-Identifier: Apache-2.0
// When a test was measured, in lists and on its own page.
import type { Test } from '../api/types';
import { texts } from '../i18n/texts';

const t = texts({
  undated: 'undated',
  simulated: 'simulated, no date',
});

/** The day that a test counts by: of measurement or, where none is stated, of arrival. */
export const day_of_test = (test: { measured_on: string; received_at: string }): string => test.measured_on || test.received_at.slice(0, 10);

/** A day as a list has it. */
export const date_or_none = (date: string | null | undefined): string => date || t('undated');

/** As the test states it; in a simulated one stands instead that nothing was measured. */
export const test_date = (test: Test): string =>
  test.simulated_undated ? t('simulated') : date_or_none(test.result.metadata.test?.date);
