// SPDX-License-Identifier: Apache-2.0
// Mean deviations before, predicted and measured again, in terms of the drawing: the colour tells the step, line and
// shape the direction.
import type { CompensationMean, CompensationNode, Parameter, Shown, Unit } from '../../api/types';
import type { ChartLine, ChartModel, ChartSeries } from '../../components/chart/chart';
import { position_unit, shortest, unit_sign } from '../../numbers';
import { plain_symbol } from '../test/figures_text';
import { t } from './texts';

export type Stage = 'before' | 'predicted' | 'retest';
export type Means = Partial<Record<Stage, readonly CompensationMean[]>>;
export const stages: readonly Stage[] = ['before', 'predicted', 'retest'];

const colours: Record<Stage, string> = { before: '--series-8', predicted: '--series-1', retest: '--series-3' };

export const stage_look = (stage: Stage): Pick<ChartSeries, 'colour' | 'width' | 'shape'> =>
  ({ colour: colours[stage], width: stage === 'before' ? 1.25 : 2, shape: 'up' });

/** Every value once, ascending. */
function united(lists: readonly (readonly number[])[]): number[] {
  return [...new Set(lists.flat())].sort((a, b) => a - b);
}

function series_of(stage: Stage, way: 'up' | 'down', means: readonly CompensationMean[], x: readonly number[], hidden: boolean): ChartSeries | null {
  const at = new Map(means.map((mean) => [mean.target, mean[way]]));
  const values = x.map((target) => at.get(target) ?? null);
  if (values.every((value) => value === null)) return null;
  return {
    key: `${stage}_${way}`, label: `${t(stage)} ${way === 'up' ? '↑' : '↓'}`, values, ...stage_look(stage), shape: way,
    size: stage === 'before' ? 6 : 8, across: true, hidden, ...(way === 'down' ? { dash: [7, 3] } : {}),
  };
}

/** Limits that a chart of means can show: those of a range of means. */
export const drawable = (shown: readonly Shown[]): Shown[] => shown.filter((row) => row.limit !== null && /^[EM]/.test(row.parameter));

/** What a limit bounds of these means: its lowest and highest. */
export function bounded(means: readonly CompensationMean[], parameter: Parameter): [number, number] | null {
  const values = means.flatMap(({ up, down }) => {
    if (parameter === 'M') return up === null || down === null ? [] : [(up + down) / 2];
    return [parameter.endsWith('_down') ? null : up, parameter.endsWith('_up') ? null : down].filter((one): one is number => one !== null);
  });
  return values.length === 0 ? null : [Math.min(...values), Math.max(...values)];
}

/** A limit bounds a range, not a place: its lines stand about the middle of the range of the last step. */
function limit_lines(means: Means, limit: Shown | null, hidden: boolean): ChartLine[] {
  const last = [...stages].reverse().find((stage) => means[stage] !== undefined);
  const range = limit === null || last === undefined ? null : bounded(means[last] as readonly CompensationMean[], limit.parameter);
  if (limit === null || limit.limit === null || range === null) return [];
  const middle = (range[0] + range[1]) / 2;
  const line = { colour: '--ink-quiet', hidden };
  return [
    { ...line, value: middle + limit.limit / 2, label: t('limit_in_all', { symbol: plain_symbol(limit.parameter), value: shortest(limit.limit), unit: limit.unit }) },
    { ...line, value: middle - limit.limit / 2, label: '' },
  ];
}

export interface MeansChoice { hidden: ReadonlySet<string>; limit: Shown | null }

export function means_model(means: Means, kind: 'linear' | 'rotary', unit: Unit, { hidden, limit }: MeansChoice): ChartModel {
  const there = stages.filter((stage) => means[stage] !== undefined);
  const x = united(there.map((stage) => (means[stage] as readonly CompensationMean[]).map(({ target }) => target)));
  return {
    x, x_kind: kind === 'rotary' ? 'angle' : 'number', x_label: `${t('position')} / ${position_unit(kind)}`, y_label: `${t('deviation')} / ${unit_sign(unit)}`,
    series: there.flatMap((stage) => (['up', 'down'] as const).flatMap((way) =>
      series_of(stage, way, means[stage] as readonly CompensationMean[], x, hidden.has(stage)) ?? [])),
    lines: limit_lines(means, limit, hidden.has('limits')),
  };
}

export type Nodes = readonly CompensationNode[];

const one_curve = (nodes: Nodes): boolean => nodes.every(({ up, down }) => up === down);

function node_series(key: 'table' | 'existing', nodes: Nodes, x: readonly number[]): ChartSeries[] {
  const look = key === 'table' ? { colour: '--series-1', width: 2 } : { colour: '--series-8', width: 1.25 };
  const size = nodes.length > 80 ? 3.5 : 7;
  const made = (way: 'up' | 'down', name: string, dash: boolean): ChartSeries => {
    const at = new Map(nodes.map((node) => [node.position, node[way]]));
    return { key: `${key}_${way}`, label: name, values: x.map((position) => at.get(position) ?? null), ...look, shape: dash ? 'down' : way, size, across: true, ...(dash ? { dash: [7, 3] } : {}) };
  };
  if (one_curve(nodes)) return [{ ...made('up', t(key === 'table' ? 'the_table' : 'the_existing'), false), shape: 'circle', size: nodes.length > 80 ? 3 : 5 }];
  return [made('up', `${t(key === 'table' ? 'the_table' : 'the_existing')} ↑`, false), made('down', `${t(key === 'table' ? 'the_table' : 'the_existing')} ↓`, true)];
}

/** What the control adds, over the axis; behind it what another table adds. */
export function table_model(table: Nodes | null, existing: Nodes | null, kind: 'linear' | 'rotary', unit: Unit): ChartModel {
  const x = united([table ?? [], existing ?? []].map((nodes) => nodes.map(({ position }) => position)));
  return {
    x, x_kind: kind === 'rotary' ? 'angle' : 'number', x_label: `${t('position')} / ${position_unit(kind)}`, y_label: `${t('added')} / ${unit_sign(unit)}`, y_zero: true,
    series: [...(existing ? node_series('existing', existing, x) : []), ...(table ? node_series('table', table, x) : [])],
    lines: [{ value: 0, colour: '--line-strong', label: '', dash: [] }],
  };
}
