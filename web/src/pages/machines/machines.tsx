// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from 'preact/hooks';
import type { Machine, MachineList } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { DataTable, type Order } from '../../components/table';
import { day_of_test } from '../../components/test_date';
import { VerdictMark } from '../../components/verdict';
import { absent } from '../../numbers';
import { go } from '../../router';
import './machines.css';
import { attention, weight } from './attention';
import { last_verdict, load_courses } from './axis_courses';
import { AxisSpark } from './axis_spark';
import { Day } from './day';
import { MachineDialog } from './machine_dialog';
import { t } from './texts';

const day_of_latest = ({ latest_test }: Machine): string => (latest_test ? day_of_test(latest_test) : '');

const sorts: Record<string, (a: Machine, b: Machine) => number> = {
  attention: (a, b) => weight(a) - weight(b) || b.name.localeCompare(a.name),
  name: (a, b) => a.name.localeCompare(b.name),
  location: (a, b) => a.location.localeCompare(b.location) || a.name.localeCompare(b.name),
  latest: (a, b) => day_of_latest(a).localeCompare(day_of_latest(b)),
};

function fits(machine: Machine, text: string): boolean {
  const all = [machine.name, machine.location, machine.type, machine.manufacturer, machine.serial_number, machine.controller].join(' ').toLowerCase();
  return text.toLowerCase().split(/\s+/).every((word) => all.includes(word));
}

/** All machines, those first that need to be looked at. */
export function MachinesPage() {
  const machines = use_get<MachineList>('/api/machines');
  const [text, set_text] = useState('');
  const [order, set_order] = useState<Order>({ by: 'attention', descending: true });
  const [adding, set_adding] = useState(false);
  const all = machines.data?.machines ?? [];
  useEffect(() => {
    if (machines.data) return load_courses(machines.data.machines.flatMap((machine) => machine.axes));
    return undefined;
  }, [machines.data]);
  const compare = sorts[order.by] ?? sorts['name'];
  const rows = all.filter((machine) => fits(machine, text)).sort((a, b) => (compare?.(a, b) ?? 0) * (order.descending ? -1 : 1));
  const grave = all.filter((machine) => weight(machine) > 1).length;
  return (
    <>
      <div class="page-head">
        <h1 tabIndex={-1}>{t('machines')}</h1>
        <div class="row">
          {all.length > 0 && <span class="quiet small">{t('summary', { n: all.length, attention: grave })}</span>}
          {all.length > 8 && (
            <input type="search" aria-label={t('search')} placeholder={t('search_hint')} class="wide" value={text} onInput={(event) => set_text(event.currentTarget.value)} />
          )}
          <button type="button" onClick={() => set_adding(true)}>{t('add')}</button>
        </div>
      </div>
      {machines.error && <FailureNotice error={machines.error} retry={machines.reload} />}
      {machines.data && all.length === 0 && <p class="panel">{t('none')}</p>}
      {all.length > 0 && (
        <section class="panel flush machines">
          {rows.length === 0
            ? <p class="quiet nothing">{t('none_fits')}</p>
            : <MachineTable rows={rows} order={order} on_order={set_order} />}
        </section>
      )}
      {adding && <MachineDialog machine={null} on_saved={(saved) => go(`/machines/${saved.id}`)} on_close={() => set_adding(false)} />}
    </>
  );
}

function MachineTable({ rows, order, on_order }: { rows: Machine[]; order: Order; on_order: (order: Order) => void }) {
  return (
    <DataTable<Machine>
      caption={t('machines')} rows={rows} row_key={(row) => row.id} order={order} on_order={on_order}
      columns={[
        { key: 'name', head: t('machine'), order: 'name', row_head: true, class: 'name', cell: (row) => (
          <>
            <a href={`/machines/${row.id}`}>{row.name}</a>
            <span class="quiet small block">{[row.manufacturer, row.type].filter((part) => part !== '').join(' ')}</span>
            <span class="only-narrow"><AttentionTags machine={row} /></span>
          </>
        ) },
        { key: 'location', head: t('location'), order: 'location', class: 'wide-only location', cell: (row) => row.location || absent },
        { key: 'attention', head: t('attention'), order: 'attention', falling: true, class: 'wide-only', cell: (row) => <AttentionTags machine={row} /> },
        { key: 'latest', head: t('latest'), order: 'latest', falling: true, class: 'number-text wide-only', cell: (row) => (
          row.latest_test
            ? <a class="quiet-link" href={`/tests/${row.latest_test.id}`}><Day test={row.latest_test} /></a>
            : absent
        ) },
        { key: 'tests', head: t('tests'), number: true, class: 'wide-only tests', cell: (row) => <a class="quiet-link" href={`/?machine=${row.id}`}>{row.tests}</a> },
        { key: 'axes', head: t('axes_course'), class: 'axes', cell: (row) => (
          <div class="axis-sparks">{row.axes.map((axis) => <AxisSpark key={axis.id} axis={axis} />)}</div>
        ) },
      ]}
    />
  );
}

export function AttentionTags({ machine }: { machine: Machine }) {
  const all = attention(machine);
  if (all.length === 0) return <Calm machine={machine} />;
  return (
    <span class="tags">
      {all.map(({ kind, axes, overdue }) => {
        if (kind === 'never') return <span key={kind} class="tag">{t(kind)}</span>;
        if (kind === 'new limit') return <span key={kind} class="tag caution">{t('over_new_limit', { axes: axes.join(', ') })}</span>;
        if (kind === 'overdue') return overdue.map((late) => <span key={late.since} class="tag caution">{late.axes.length === 0 ? t('overdue', { date: late.since }) : t('axes_overdue', { axes: late.axes.join(', '), date: late.since })}</span>);
        return <span key={kind} class="verdict-of">{axes.length > 0 && <strong>{axes.join(', ')}</strong>}<VerdictMark verdict={kind} /></span>;
      })}
    </span>
  );
}

/** Nothing to look at: the axes whose last test conforms, or that no tolerance says so of any. */
function Calm({ machine }: { machine: Machine }) {
  const good = machine.axes.filter((axis) => last_verdict(axis.id) === 'conforms').map((axis) => axis.name);
  return (
    <span class="verdict-of">
      {good.length > 0 && good.length < machine.axes.length && <strong>{good.join(', ')}</strong>}
      <VerdictMark verdict={good.length > 0 ? 'conforms' : (machine.latest_test?.verdict ?? null)} />
    </span>
  );
}
