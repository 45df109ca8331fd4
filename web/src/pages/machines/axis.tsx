// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Axis, CompensationHead, CompensationList, Machine } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { TablesOfAxis } from '../compensations/of_axis';
import { LimitsLine } from './machine';
import './machines.css';
import { AxisDialog } from './axis_dialog';
import { EntityHistory } from './history';
import { t } from './texts';
import { AxisTrend } from './trend';

const no_tables: readonly CompensationHead[] = [];

/** One axis: its limits and its whole history. */
export function AxisPage({ parts }: { parts: Record<string, string> }) {
  const axis = use_get<Axis>(`/api/axes/${parts['id']}`);
  const machine = use_get<Machine>(axis.data ? `/api/machines/${axis.data.machine}` : null);
  const tables = use_get<CompensationList>(`/api/compensations?axis=${encodeURIComponent(parts['id'] ?? '')}`);
  const [editing, set_editing] = useState(false);
  const found = axis.data;
  if (axis.error && !found) return <FailureNotice error={axis.error} retry={axis.reload} />;
  if (!found) return null;
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/machines">{t('machines')}</a> / <a href={`/machines/${found.machine}`}>{machine.data?.name ?? t('machine')}</a></p>
          <h1 tabIndex={-1}>{t('axis_title', { machine: machine.data?.name ?? '', axis: found.name })}</h1>
        </div>
        <div class="row no-print">
          <a class="button" href={`/?machine=${found.machine}&axis=${found.id}`}>{t('tests')}</a>
          <button type="button" onClick={() => set_editing(true)}>{t('limits_edit')}</button>
        </div>
      </div>
      <section class="panel">
        <header><h2>{t('trend')} <span class="quiet small limits-line">{t(found.kind)}</span> <LimitsLine axis={found} /></h2></header>
        <AxisTrend axis={found.id} version={found.version} height={420} tables={tables.data?.compensations ?? no_tables} />
      </section>
      <TablesOfAxis list={tables} />
      {found.notes !== '' && <p class="panel notes">{found.notes}</p>}
      <EntityHistory path={`/api/axes/${found.id}`} subject={`axis ${found.id}`} version={found.version} />
      {editing && (
        <AxisDialog axis={found} machine={found.machine} on_saved={() => { set_editing(false); axis.reload(); }} on_close={() => set_editing(false)} />
      )}
    </>
  );
}
