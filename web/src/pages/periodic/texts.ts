// SPDX-License-Identifier: Apache-2.0
import { texts } from '../../i18n/texts';

export const t = texts({
  title: 'Periodic error',
  title_axis: 'Periodic error of axis {axis}',
  loading: 'The period is searched …',
  sought: 'Period',
  period: 'Known period ({unit})',
  period_hint: 'empty: it is searched',
  expected: 'The test expects {period} {unit}.',
  take: 'Take it',
  min_period: 'Shortest searched ({unit})',
  max_period: 'Longest searched ({unit})',
  above_zero: 'a number above 0',
});
