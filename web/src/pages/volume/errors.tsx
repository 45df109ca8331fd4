// SPDX-License-Identifier: Apache-2.0
// The 21 errors: 18 curves with their bands, three angles, and all of them as a table.
import { useMemo } from 'preact/hooks';
import type { VolumetricErrors, VolumetricNode, VolumetricSquareness } from '../../api/types';
import { Chart, type ChartModel } from '../../components/chart/chart';
import { DataTable } from '../../components/table';
import { absent, decimals_for, fixed } from '../../numbers';
import { language } from '../../settings';
import { axes, kind_of, motions, squarenesses, type Axis, type Motion } from './error_names';
import { t } from './result_texts';

const nodes_of = (errors: VolumetricErrors, name: string): readonly VolumetricNode[] => (errors as unknown as Record<string, VolumetricNode[]>)[name] ?? [];
const angle_of = (errors: VolumetricErrors, name: string): VolumetricSquareness => (errors as unknown as Record<string, VolumetricSquareness>)[name] as VolumetricSquareness;

export function ErrorCurves({ errors }: { errors: VolumetricErrors }) {
  return (
    <>
      {axes.map((axis) => (
        <section key={axis} class="axis-errors" aria-labelledby={`errors-${axis}`}>
          <h3 id={`errors-${axis}`}>{t('of_axis', { axis })}</h3>
          <div class="error-curves">
            {motions.filter((motion) => motion.axis === axis).map((motion) => <ErrorCurve key={motion.name} motion={motion} nodes={nodes_of(errors, motion.name)} />)}
          </div>
        </section>
      ))}
    </>
  );
}

function ErrorCurve({ motion, nodes }: { motion: Motion; nodes: readonly VolumetricNode[] }) {
  const { name, axis, unit } = motion;
  const model = useMemo(() => curve_model(motion, nodes), [nodes, language.value]);
  return (
    <figure class="curve">
      <figcaption><strong>{name}</strong> <span class="quiet">{kind_of(motion)}, {unit}</span></figcaption>
      {nodes.length === 0
        ? <p class="untold"><strong>{t('no_number')}</strong><span class="quiet small">{t('untold')}</span></p>
        : <Chart {...model} name={`${name}, ${kind_of(motion)}, ${unit}, ${t('of_axis', { axis })}`} height={170} />}
    </figure>
  );
}

function curve_model({ axis, unit }: Motion, nodes: readonly VolumetricNode[]): ChartModel {
  const values = nodes.map(({ value }) => value);
  const has_directions = nodes.some(({ up }) => up !== undefined);
  const side = (key: 'up' | 'down') => nodes.map((node) => node[key]?.value ?? null);
  return {
    x: nodes.map(({ position }) => position), x_label: t('position', { axis }), y_label: unit, y_zero: true,
    bands: [{ key: 'band', upper: nodes.map(({ value, u }) => value + 2 * u), lower: nodes.map(({ value, u }) => value - 2 * u), colour: '--series-1', opacity: 0.25 }],
    series: [
      { key: 'value', label: has_directions ? t('mean') : t('value'), values, colour: '--series-1', shape: null },
      ...(has_directions ? [
        { key: 'up', label: t('up'), values: side('up'), colour: '--series-up', shape: null, dash: [4, 2], width: 1 },
        { key: 'down', label: t('down'), values: side('down'), colour: '--series-down', shape: null, dash: [4, 2], width: 1 },
      ] : []),
    ],
  };
}

export function SquarenessFigures({ errors }: { errors: VolumetricErrors }) {
  return (
    <dl class="figures squareness">
      {squarenesses.map(([name, a, b]) => {
        const { value, u } = angle_of(errors, name);
        return (
          <div key={name}>
            <dt>{name} · {t('squareness_of', { a, b })}</dt>
            <dd class="number">
              {value === null || u === null ? <>{t('no_number')} <span class="unit">{t('untold')}</span></>
                : <>{fixed(value, decimals_for(2 * u, 2))} <span class="unit">± {fixed(2 * u, decimals_for(2 * u, 2))} µrad (k = 2)</span></>}
            </dd>
          </div>
        );
      })}
    </dl>
  );
}

interface Row { name: string; kind: string; unit: string; most: number | null; spread: number | null; u_mean: number | null; u_most: number | null }

function row_of(motion: Motion, nodes: readonly VolumetricNode[]): Row {
  const told = nodes.length > 0;
  const values = nodes.map(({ value }) => value);
  const us = nodes.map(({ u }) => u);
  const signed = values.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);
  return {
    name: motion.name, kind: kind_of(motion), unit: motion.unit, most: told ? signed : null,
    spread: told ? Math.max(...values) - Math.min(...values) : null,
    u_mean: told ? Math.sqrt(us.reduce((sum, u) => sum + u * u, 0) / us.length) : null, u_most: told ? Math.max(...us) : null,
  };
}

export function ErrorTable({ errors }: { errors: VolumetricErrors }) {
  const rows: Row[] = [
    ...motions.map((motion) => row_of(motion, nodes_of(errors, motion.name))),
    ...squarenesses.map(([name, a, b]): Row => {
      const { value, u } = angle_of(errors, name);
      return { name, kind: `${t('squareness')} ${t('squareness_of', { a, b })}`, unit: 'µrad', most: value, spread: null, u_mean: u, u_most: u };
    }),
  ];
  const number = (key: 'most' | 'spread' | 'u_mean' | 'u_most', head: string, decimals: number) =>
    ({ key, head, number: true, cell: (row: Row) => (row.most === null && key === 'most' ? t('no_number') : row[key] === null ? absent : fixed(row[key], decimals)) });
  return (
    <details class="all-errors">
      <summary>{t('table')}</summary>
      <DataTable caption={t('table')} rows={rows} row_key={({ name }) => name} columns={[
        { key: 'name', head: t('error'), row_head: true, cell: ({ name }) => name },
        { key: 'kind', head: t('kind'), cell: ({ kind }) => kind },
        { key: 'unit', head: t('unit'), cell: ({ unit }) => unit },
        number('most', t('most'), 2), number('spread', t('spread'), 2), number('u_mean', t('u_mean'), 2), number('u_most', t('u_most'), 2),
      ]} />
      <p class="quiet small">{t('table_note')}</p>
    </details>
  );
}

export const told_count = (errors: VolumetricErrors): number =>
  motions.filter(({ name }) => nodes_of(errors, name).length > 0).length + squarenesses.filter(([name]) => angle_of(errors, name).value !== null).length;

export type { Axis };
