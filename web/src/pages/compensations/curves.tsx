// SPDX-License-Identifier: Apache-2.0
import { useMemo, useState } from 'preact/hooks';
import type { Parameter, Shown, Unit } from '../../api/types';
import { Chart, ChartLegend, Swatch } from '../../components/chart/chart';
import { DataTable } from '../../components/table';
import { fixed, position_unit, shortest, unit_sign } from '../../numbers';
import { decimal, language } from '../../settings';
import { plain_symbol } from '../test/figures_text';
import { drawable, means_model, stage_look, stages, table_model, type Means, type Nodes } from './curve_model';
import { t } from './texts';

const toggled = (set: ReadonlySet<string>, key: string): ReadonlySet<string> => {
  const next = new Set(set);
  if (!next.delete(key)) next.add(key);
  return next;
};

/** Mean deviations of all steps over each other, with the limits of the axis where a range of means has one. */
export function MeansChart({ means, shown, kind, unit, height = 340 }: {
  means: Means; shown: readonly Shown[]; kind: 'linear' | 'rotary'; unit: Unit; height?: number;
}) {
  const [hidden, set_hidden] = useState<ReadonlySet<string>>(new Set());
  const [wanted, set_wanted] = useState<Parameter | null>(null);
  const limits = drawable(shown);
  const limit = limits.find(({ parameter }) => parameter === wanted) ?? limits[0] ?? null;
  const model = useMemo(() => means_model(means, kind, unit, { hidden, limit }),
                        [means.before, means.predicted, means.retest, kind, unit, hidden, limit?.parameter, limit?.limit, language.value, decimal.value]);
  const there = stages.filter((stage) => means[stage] !== undefined);
  const items = [
    ...there.map((stage) => ({ key: stage as string, label: t(stage), look: stage_look(stage), shown: !hidden.has(stage) })),
    ...(limit ? [{ key: 'limits', label: t('limits'), look: { colour: '--ink-quiet', width: 1.25, dash: [6, 4] }, shown: !hidden.has('limits') }] : []),
  ];
  return (
    <section class="panel chart-panel" aria-labelledby="compensation-means">
      <header>
        <h2 id="compensation-means">{t('means')}</h2>
        <div class="row no-print">
          <ChartLegend label={t('legend')} items={items} on_toggle={(key) => set_hidden(toggled(hidden, key))} />
          {limits.length > 1 && (
            <label class="small">{t('limit_of')}
              <select value={limit?.parameter ?? ''} onChange={(event) => set_wanted(event.currentTarget.value as Parameter)}>
                {limits.map(({ parameter }) => <option key={parameter} value={parameter}>{plain_symbol(parameter)}</option>)}
              </select>
            </label>
          )}
        </div>
      </header>
      <Chart {...model} name={t('means_name')} height={height} />
      <p class="quiet small chart-key">{t('ways')}{limit && ` ${t('limit_place')}`}</p>
    </section>
  );
}

/** What the control adds over the axis, and the same as numbers. `children`: what belongs below it. */
export function TableChart({ table, existing, kind, unit, height = 240 }: { table: Nodes | null; existing: Nodes | null; kind: 'linear' | 'rotary'; unit: Unit; height?: number }) {
  const model = useMemo(() => table_model(table, existing, kind, unit), [table, existing, kind, unit, language.value]);
  const both = table !== null && existing !== null;
  return (
    <section class="panel chart-panel" aria-labelledby="compensation-curve">
      <header>
        <h2 id="compensation-curve">{t(table === null ? 'existing_curve' : 'curve')}</h2>
        {both && (
          <span class="row small quiet">
            <span><Swatch series={{ colour: '--series-1', width: 2, shape: 'circle' }} /> {t('the_table')}</span>
            <span><Swatch series={{ colour: '--series-8', width: 1.25, shape: 'circle' }} /> {t('the_existing')}</span>
          </span>
        )}
      </header>
      <Chart {...model} name={t('curve_name')} height={height} />
      <p class="quiet small chart-key">{t('curve_sign')}</p>
      {table !== null && <NodeTable title={t('nodes', { n: table.length })} nodes={table} kind={kind} unit={unit} />}
      {existing !== null && <NodeTable title={t('existing_nodes', { n: existing.length })} nodes={existing} kind={kind} unit={unit} />}
    </section>
  );
}

export function NodeTable({ title, nodes, kind, unit, open = false }: { title: string; nodes: Nodes; kind: 'linear' | 'rotary'; unit: Unit; open?: boolean }) {
  const value = (way: 'up' | 'down') => ({ key: way, head: `${way === 'up' ? '↑' : '↓'} / ${unit_sign(unit)}`, number: true, cell: (node: Nodes[number]) => fixed(node[way], 2) });
  return (
    <details class="nodes" open={open}>
      <summary>{title}</summary>
      <DataTable caption={title} rows={nodes} row_key={({ position }) => position} columns={[
        { key: 'position', head: `${t('position')} / ${position_unit(kind)}`, number: true, cell: ({ position }) => shortest(position, 6) },
        value('up'), value('down'),
      ]} />
    </details>
  );
}
