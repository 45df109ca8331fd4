// SPDX-License-Identifier: Apache-2.0
import { day_of_test } from '../../components/test_date';
import { t } from './texts';

/** The day that a test counts by, and whether it is that of its arrival. */
export function Day({ test }: { test: { measured_on: string; received_at: string } }) {
  return <>{day_of_test(test)}{test.measured_on === '' && <span class="quiet"> ({t('received')})</span>}</>;
}
