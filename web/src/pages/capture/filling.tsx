// SPDX-License-Identifier: Apache-2.0
// Targets filling in: the curve of each run as it comes, and all readings as a table.
import type { RefObject } from 'preact';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import type { Capture } from '../../api/types';
import { Chart, type ChartSeries } from '../../components/chart/chart';
import { absent, fixed } from '../../numbers';
import type { Direction, Reading } from './live';
import { t as t_motion } from './motion_texts';
import { arrow } from './readout';
import { t } from './texts';
import { semicolon } from '../../i18n/colon';

interface Props { readings: Reading[]; targets: number[]; runs: number; unit: string; deviation_unit: string; due: Capture['due'] }

const both = ['up', 'down'] as const;
type Cells = Map<string, Reading>;
const key = (direction: Direction, run: number, target: number): string => `${direction} ${run} ${target}`;

/** By approach: one that was read again is the later one. */
const cells_of = (readings: Reading[]): Cells => new Map(readings.map((one) => [key(one.direction, one.run, one.target), one]));

/** `read`: what is read where that is no deviation of positions. */
export function LiveChart({ readings, targets, runs, unit, deviation_unit, read }: Props & { read?: string }) {
  const series = useMemo(() => {
    const cells = cells_of(readings);
    const latest = readings[readings.length - 1];
    const all: ChartSeries[] = [];
    for (const direction of both)
      for (let run = 1; run <= runs; run++)
        all.push({
          key: `${direction} ${run}`, label: `${t('run')} ${run} ${arrow(direction)}`,
          values: targets.map((_, i) => cells.get(key(direction, run, i + 1))?.deviation ?? null),
          colour: `--series-${direction}`, shape: direction === 'up' ? 'up' : 'down', across: true,
          opacity: !latest || latest.run === run ? 1 : 0.45, width: latest?.run === run ? 2 : 1.2,
        });
    return all;
  }, [readings, targets, runs]);
  return (
    <section class="panel" aria-labelledby="deviations">
      <h2 id="deviations">{read ? t_motion('read') : t('deviations')}</h2>
      <Chart
        name={(read ? t_motion : t)('chart', { n: readings.length, all: targets.length })} height={340} y_zero={!read}
        x={targets} x_label={`${t('position')} / ${unit}`} y_label={`${read ?? t('deviation')} / ${deviation_unit}`} series={series}
      />
    </section>
  );
}

/** Where not all runs have room beside each other, the one that fills in is scrolled into sight as it begins, and columns
 * end at the targets: of a number cut off there, "0.30", one would read the rest. */
function use_due_in_sight(frame: RefObject<HTMLDivElement | null>, due: Capture['due'], columns: number): void {
  useLayoutEffect(() => {
    const cell = frame.current?.querySelector('td.due')?.getBoundingClientRect();
    if (!frame.current || !cell) return;
    const { left } = frame.current.getBoundingClientRect();
    frame.current.style.scrollPaddingInlineStart = `${frame.current.querySelector<HTMLElement>('th:nth-child(2)')?.offsetWidth ?? 0}px`;
    frame.current.scrollLeft += (cell.left + cell.right) / 2 - left - frame.current.clientWidth / 2;
  }, [due?.run, due?.direction, columns]);
}

export function LiveTable({ readings, targets, runs, unit, deviation_unit, due, directions }: Props & { directions: readonly Direction[] }) {
  const cells = cells_of(readings);
  const latest = readings[readings.length - 1];
  const columns = directions.flatMap((direction) => Array.from({ length: runs }, (_, i) => ({ direction, run: i + 1 })));
  const frame = useRef<HTMLDivElement>(null);
  use_due_in_sight(frame, due, columns.length);
  return (
    <section class="panel flush filling">
      <header><h2 id="filling">{t('readings')} <span class="quiet small">/ {deviation_unit}</span></h2></header>
      <div class="table-frame" role="region" aria-labelledby="filling" tabIndex={0} ref={frame}>
        <table>
          <thead>
            <tr>
              <th scope="col" class="number">i</th>
              <th scope="col" class="number">{t('position')} / {unit}</th>
              {columns.map(({ direction, run }) => (
                <th scope="col" class="number" key={`${direction}${run}`}>{run}<span class={direction}>{arrow(direction)}</span></th>
              ))}
            </tr>
          </thead>
          <tbody>
            {targets.map((target, i) => (
              <tr key={i}>
                <th scope="row" class="number">{i + 1}</th>
                <td class="number">{fixed(target, 3)}</td>
                {columns.map(({ direction, run }) => {
                  const cell = cells.get(key(direction, run, i + 1));
                  const is_due = due !== null && due.target === i + 1 && due.run === run && due.direction === direction;
                  return (
                    <td key={`${direction}${run}`} class={`number ${is_due ? 'due' : ''} ${cell !== undefined && cell === latest ? 'latest' : ''}`}
                      title={cell && cell.remarks.length > 0 ? cell.remarks.join(semicolon()) : undefined}>
                      {cell ? fixed(cell.deviation, 2) : is_due ? '…' : <span class="quiet">{absent}</span>}
                      {cell && cell.remarks.length > 0 && <sup>*</sup>}
                    </td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
