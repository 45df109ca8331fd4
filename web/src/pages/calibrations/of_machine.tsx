// SPDX-License-Identifier: Apache-2.0
import type { CalibrationPage } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { CalibrationTable } from './table';
import { t } from './texts';

/** The calibrations of a machine, the latest measured first; nothing where it has none. */
export function CalibrationsOfMachine({ machine }: { machine: number }) {
  const page = use_get<CalibrationPage>(`/api/calibrations?machine=${machine}&order=measured&limit=10`);
  if (page.error) return <FailureNotice error={page.error} retry={page.reload} />;
  if (!page.data || page.data.total === 0) return null;
  return (
    <section class="panel">
      <header>
        <h2>{t('title')}</h2>
        <a class="small" href={`/calibrations?machine=${machine}`}>{t('counted', { n: page.data.calibrations.length, total: page.data.total })}</a>
      </header>
      <CalibrationTable rows={page.data.calibrations} with_machine={false} />
    </section>
  );
}
