// SPDX-License-Identifier: Apache-2.0
import { days_until } from '../../components/dates';
import { t } from './texts';

export const overdue = (due: string): boolean => (days_until(due) ?? 0) < 0;
const soon = 60;  // days

/** A date of calibration with what it means today. */
export function Due({ due }: { due: string }) {
  if (due === '') return <span class="quiet">{t('no_date')}</span>;
  const days = days_until(due);
  return (
    <span class="number">
      {due}{' '}
      {days !== null && days < 0 && <span class="tag bad">{t('overdue')}</span>}
      {days !== null && days >= 0 && days <= soon && <span class="tag caution">{days === 0 ? t('due_today') : t('due_soon', { days })}</span>}
    </span>
  );
}
