// SPDX-License-Identifier: Apache-2.0
import { Fragment } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import type { Evaluated, PositionResult, Readings } from '../../api/types';
import { most_decimals } from '../../components/aligned';
import { texts } from '../../i18n/texts';
import { fixed, position_unit, shortest, unit_sign } from '../../numbers';
import { decimal, language } from '../../settings';
import { position_decimals, type Quantity } from './figures_text';
import type { TestState } from './state';

const t = texts({
  title: 'Positions',
  target: 'Target',
  all_readings: 'All single readings',
  all_digits: 'All digits',
  readings_at: 'Single readings at {target}',
  run: ['Run', 'approach'],
  measured: 'as measured',
  decides: 'decides {symbol}',
  note: 'Deviations in {unit}. Strong: decides a parameter of the axis.',
  number: 'No.',
});

const columns: readonly (readonly [Quantity, string, string])[] = [
  ['mean_up', 'x̄', '↑'], ['mean_down', 'x̄', '↓'], ['mean', 'x̄', ''], ['reversal', 'B', ''],
  ['s_up', 's', '↑'], ['s_down', 's', '↓'], ['R_up', 'R', '↑'], ['R_down', 'R', '↓'], ['R', 'R', ''],
];

/** Of which parameters a position's value is the one that decides: the largest B, R↑, R↓ and R, the ends of M. */
function deciding(positions: readonly PositionResult[]): Map<string, string> {
  const found = new Map<string, string>();
  const mark = (quantity: Quantity, symbol: string, better: (a: number, b: number) => boolean) => {
    let best: { i: number; value: number } | null = null;
    positions.forEach((position, i) => {
      const value = position[quantity];
      if (value !== null && (best === null || better(value, best.value))) best = { i, value };
    });
    if (best !== null) found.set(`${(best as { i: number }).i}:${quantity}`, symbol);
  };
  const larger = (a: number, b: number) => a > b;
  mark('reversal', 'B', (a, b) => Math.abs(a) > Math.abs(b));
  mark('R_up', 'R↑', larger);
  mark('R_down', 'R↓', larger);
  mark('R', 'R', larger);
  for (const [quantity, symbol] of [['mean_up', 'E↑'], ['mean_down', 'E↓'], ['mean', 'M']] as const) {
    mark(quantity, symbol, larger);
    mark(quantity, symbol, (a, b) => a < b);
  }
  return found;
}

/** The results at every target; a row opens to its single readings. */
export function Positions({ state }: { state: TestState }) {
  const evaluated = state.evaluated.value;
  const { positions, axis, unit } = evaluated.result;
  const [open, set_open] = useState<ReadonlySet<number>>(new Set<number>());
  const [digits, set_digits] = useState(false);
  const present = columns.filter(([quantity]) => positions.some((position) => position[quantity] !== null));
  const all_open = open.size === positions.length;
  const strong = deciding(positions);
  const number = (value: number | null, quantity: Quantity) => (digits ? shortest(value, 9) : fixed(value, position_decimals(evaluated, quantity)));
  // Single readings are no results: they keep a digit more than the parameters that are made of them.
  const reading_decimals = 1 + most_decimals(evaluated.shown.map((row) => row.value));
  const reading = (value: number | null) => (digits ? shortest(value, 9) : fixed(value, reading_decimals));
  const toggle = (i: number) => {
    const next = new Set(open);
    if (!next.delete(i)) next.add(i);
    set_open(next);
  };
  const decimals = target_decimals(positions);
  const here = state.target.value;
  const rows = useMemo(() => (
    <tbody>
      {positions.map((position, i) => (
        <Fragment key={i}>
          <tr class={here === i ? 'pointed' : ''} onMouseEnter={() => (state.target.value = i)}>
            <th scope="row" class="number">
              <button type="button" class="expand" aria-expanded={open.has(i)} onClick={() => toggle(i)} onFocus={() => (state.target.value = i)}>
                <span aria-hidden="true">{open.has(i) ? '▾' : '▸'}</span> {i + 1}
                <span class="visually-hidden"> {t('readings_at', { target: shortest(position.target) })}</span>
              </button>
            </th>
            <td class="number">{fixed(position.target, decimals)}</td>
            {present.map(([quantity]) => {
              const decides = strong.get(`${i}:${quantity}`);
              return (
                <td key={quantity} class={`number ${decides ? 'decides' : ''}`} title={decides ? t('decides', { symbol: decides }) : undefined}>
                  {number(position[quantity], quantity)}
                </td>
              );
            })}
          </tr>
          {open.has(i) && <Single evaluated={evaluated} at={i} span={present.length + 1} number={reading} />}
        </Fragment>
      ))}
    </tbody>
  ), [positions, evaluated.readings, evaluated.shown, open, digits, here, language.value, decimal.value]);
  return (
    <section class="panel flush positions-panel">
      <header>
        <h2>{t('title')}</h2>
        <div class="row no-print">
          <button type="button" class="small" aria-pressed={all_open} onClick={() => set_open(all_open ? new Set() : new Set(positions.keys()))}>{t('all_readings')}</button>
          <button type="button" class="small" aria-pressed={digits} onClick={() => set_digits(!digits)}>{t('all_digits')}</button>
        </div>
      </header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
        <table class="positions" onMouseLeave={() => (state.target.value = null)}>
          <thead>
            <tr>
              <th scope="col" class="number">{t('number')}</th>
              <th scope="col" class="number">{t('target')} / {position_unit(axis.kind)}</th>
              {present.map(([quantity, symbol, arrow]) => (
                <th key={quantity} scope="col" class="number"><span class="symbol">{symbol}</span><sub>i</sub>{arrow}</th>
              ))}
            </tr>
          </thead>
          {rows}
        </table>
      </div>
      <p class="small quiet foot">{t('note', { unit: unit_sign(unit) })}</p>
    </section>
  );
}

/** As many decimals as the most exact target needs, at most 4, so that the column aligns. */
function target_decimals(positions: readonly PositionResult[]): number {
  return Math.max(0, ...positions.map(({ target }) => {
    const text = String(Number(target.toFixed(4)));
    return text.includes('.') ? text.length - text.indexOf('.') - 1 : 0;
  }));
}

function readings_at(readings: Readings, at: number): { label: string; values: (number | null)[] }[] {
  const rows = [
    { label: '↑', values: readings.up[at] ?? [] }, { label: '↓', values: readings.down[at] ?? [] },
    ...(readings.as_measured
      ? [{ label: `↑ ${t('measured')}`, values: readings.as_measured.up[at] ?? [] }, { label: `↓ ${t('measured')}`, values: readings.as_measured.down[at] ?? [] }]
      : []),
  ];
  return rows.filter((row) => row.values.some((value) => value !== null));
}

function Single({ evaluated, at, span, number }: {
  evaluated: Evaluated; at: number; span: number; number: (value: number | null) => string;
}) {
  const rows = readings_at(evaluated.readings, at);
  const runs = Math.max(0, ...rows.map((row) => row.values.length));
  return (
    <tr class="single">
      <td />
      <td colSpan={span}>
        <table>
          <thead><tr><th scope="col">{t('run')}</th>{Array.from({ length: runs }, (_, run) => <th key={run} scope="col" class="number">{run + 1}</th>)}</tr></thead>
          <tbody>
            {rows.map((row) => (
              <tr key={row.label}>
                <th scope="row">{row.label}</th>
                {Array.from({ length: runs }, (_, run) => <td key={run} class="number">{number(row.values[run] ?? null)}</td>)}
              </tr>
            ))}
          </tbody>
        </table>
      </td>
    </tr>
  );
}
