// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import type { Axis, CompensationHead, CompensationList, Machine } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { absent, shortest, unit_sign } from '../../numbers';
import { AttentionTags } from './machines';
import { CalibrationsOfMachine } from '../calibrations/of_machine';
import './machines.css';
import { AxisDialog } from './axis_dialog';
import { EntityHistory } from './history';
import { load_courses } from './axis_courses';
import { Day } from './day';
import { MachineDialog } from './machine_dialog';
import { plain_symbol } from './parameters';
import { t } from './texts';
import { AxisTrend } from './trend';
import { colon } from '../../i18n/colon';

/** One machine: what it is, its axes with their limits, and how they have changed. */
export function MachinePage({ parts }: { parts: Record<string, string> }) {
  const machine = use_get<Machine>(`/api/machines/${parts['id']}`);
  const [editing, set_editing] = useState<'machine' | Axis | 'axis' | null>(null);
  const found = machine.data;
  useEffect(() => (found ? load_courses(found.axes) : undefined), [found]);
  if (machine.error && !found) return <FailureNotice error={machine.error} retry={machine.reload} />;
  if (!found) return null;
  const saved_axis = () => { set_editing(null); machine.reload(); };
  return (
    <>
      <div class="page-head">
        <div>
          <p class="crumb"><a href="/machines">{t('machines')}</a></p>
          <h1 tabIndex={-1}>{found.name}</h1>
        </div>
        <div class="row no-print">
          <a class="button" href={`/?machine=${found.id}`}>{t('all_tests', { n: found.tests })}</a>
          <button type="button" onClick={() => set_editing('axis')}>{t('add_axis')}</button>
          <button type="button" onClick={() => set_editing('machine')}>{t('edit')}</button>
        </div>
      </div>
      {machine.error && <FailureNotice error={machine.error} retry={machine.reload} />}
      <section class="panel">
        <Facts machine={found} />
      </section>
      <div class="axis-panels">
        {found.axes.map((axis) => (
          <AxisPanel key={axis.id} axis={axis} edit={() => set_editing(axis)} />
        ))}
      </div>
      <CalibrationsOfMachine machine={found.id} />
      <EntityHistory path={`/api/machines/${found.id}`} subject={`machine ${found.id}`} version={found.version} />
      {editing === 'machine' && (
        <MachineDialog machine={found} on_saved={() => { set_editing(null); machine.reload(); }} on_close={() => set_editing(null)} />
      )}
      {editing !== null && editing !== 'machine' && (
        <AxisDialog axis={editing === 'axis' ? null : editing} machine={found.id} on_saved={saved_axis} on_close={() => set_editing(null)} />
      )}
    </>
  );
}

const no_tables: readonly CompensationHead[] = [];

/** An axis with its history, and where tables were made of its tests. */
function AxisPanel({ axis, edit }: { axis: Axis; edit: () => void }) {
  const tables = use_get<CompensationList>(`/api/compensations?axis=${axis.id}`);
  return (
    <section class="panel">
      <header>
        <h2><a href={`/axes/${axis.id}`}>{t('axis')} {axis.name}</a> <LimitsLine axis={axis} /></h2>
        <button type="button" class="no-print" onClick={edit} aria-label={`${t('axis')} ${axis.name}${colon()} ${t('limits_edit')}`}>{t('limits_edit')}</button>
      </header>
      {tables.error && <FailureNotice error={tables.error} retry={tables.reload} />}
      <AxisTrend axis={axis.id} version={axis.version} height={260} tables={tables.data?.compensations ?? no_tables} />
    </section>
  );
}

export function LimitsLine({ axis }: { axis: Axis }) {
  if (axis.limits.length === 0) return null;
  const unit = unit_sign(axis.kind === 'linear' ? 'um' : 'arcsec');
  return (
    <span class="quiet small limits-line">
      {axis.limits.map((limit) => t('limit_line', { parameter: plain_symbol(limit.parameter), value: shortest(limit.value), unit })).join(', ')}
    </span>
  );
}

const facts = ['manufacturer', 'type', 'serial_number', 'controller', 'location'] as const;

function Facts({ machine }: { machine: Machine }) {
  return (
    <>
      <dl class="fact-grid">
        {facts.map((key) => <div key={key}><dt>{t(key)}</dt><dd>{machine[key] || absent}</dd></div>)}
        <div>
          <dt>{t('latest')}</dt>
          <dd class="latest">
            {machine.latest_test ? <a href={`/tests/${machine.latest_test.id}`}><Day test={machine.latest_test} /></a> : absent}
            <AttentionTags machine={machine} />
          </dd>
        </div>
      </dl>
      {machine.notes !== '' && <p class="notes">{machine.notes}</p>}
    </>
  );
}
