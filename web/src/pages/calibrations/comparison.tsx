// SPDX-License-Identifier: Apache-2.0
import type { KeptCalibration, CalibrationComparison, CalibrationPage } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { DataTable } from '../../components/table';
import { place, set_query } from '../../router';
import { figure_name, figure_text, sign_of } from './figures';
import { t } from './texts';
import { colon } from '../../i18n/colon';

/** This calibration beside another of its kind, which stands in the address. */
export function ComparePanel({ calibration }: { calibration: KeptCalibration }) {
  const other = place.value.query.get('with');
  const others = use_get<CalibrationPage>(`/api/calibrations?kind=${calibration.kind}&order=measured&limit=200`);
  const list = others.data?.calibrations.filter(({ id }) => id !== calibration.id) ?? [];
  if (other === null && list.length === 0) return null;
  return (
    <section class="panel">
      <header><h2>{t('comparison')}</h2></header>
      <div class="no-print">
        <Field label={t('compare_with')}>
          {(ids) => (
            <select {...ids} value={other ?? ''} onChange={(event) => set_query({ with: event.currentTarget.value || null })}>
              <option value="">{t('choose')}</option>
              {list.map((one) => <option key={one.id} value={one.id}>{[one.title, one.measured_on].filter(Boolean).join(', ')}</option>)}
            </select>
          )}
        </Field>
      </div>
      {other !== null && <Compared before={other} after={calibration.id} kind={calibration.kind} />}
    </section>
  );
}

type Row = CalibrationComparison['rows'][number];

function Compared({ before, after, kind }: { before: string; after: number; kind: string }) {
  const asked = use_get<CalibrationComparison>(`/api/calibrations/${before}/comparison?with=${after}`);
  if (asked.error) return <FailureNotice error={asked.error} retry={asked.reload} />;
  const found = asked.data;
  if (!found) return null;
  const value = (row: Row, number: number | null, u: number | null = null) =>
    `${figure_text(row.parameter, row.unit, number)}${u === null ? '' : ` (u ${figure_text(row.parameter, row.unit, u)})`}`;
  return (
    <>
      <DataTable<Row> caption={t('comparison')} rows={found.rows} row_key={(row) => `${row.parameter} ${row.of}`} columns={[
        { key: 'figure', head: t('figure'), row_head: true, cell: (row) => figure_name(row.parameter, row.of) },
        { key: 'before', head: <>{t('before')}{colon()} {found.before.title}</>, number: true, cell: (row) => value(row, row.before, row.before_u) },
        { key: 'after', head: <>{t('after')}{colon()} {found.after.title}</>, number: true, cell: (row) => value(row, row.after, row.after_u) },
        { key: 'difference', head: t('difference'), number: true, cell: (row) => value(row, row.difference) },
        { key: 'unit', head: t('unit'), cell: (row) => sign_of(row.unit) },
      ]} />
      {kind === 'volumetric' && <p class="quiet small">{t('compare_how')}</p>}
    </>
  );
}
