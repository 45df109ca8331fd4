// SPDX-License-Identifier: Apache-2.0
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { CompensationHead, Limit, Parameter, Trend } from '../../api/types';
import { use_get } from '../../api/use';
import { Chart, ChartLegend, type ChartLine, type ChartMark, type ChartPlace, type ChartSeries, type Ends } from '../../components/chart/chart';
import { day_seconds } from '../../components/dates';
import { FailureNotice } from '../../components/failure';
import { ParameterSymbol } from '../../components/symbol';
import { DataTable } from '../../components/table';
import { VerdictMark } from '../../components/verdict';
import { day_of_test } from '../../components/test_date';
import { absent, shortest, unit_sign } from '../../numbers';
import { go } from '../../router';
import { at_hand, column_decimals, FigureCell, ParameterHead, shown_of, some_interval, some_U, uncertainty_text } from '../../components/figure_cell';
import { differ, method_of, named_method, record_note } from '../../components/uncertainty';
import { short_control } from '../compensations/lines';
import { Day } from './day';
import { look, parameters, plain_symbol, verdict_of } from './parameters';
import { t } from './texts';
import { colon, semicolon } from '../../i18n/colon';

type Point = Trend['points'][number];
const most_named = 3;
const no_tables: readonly CompensationHead[] = [];


const seconds_of = (point: Point): number => day_seconds(point.measured_on) ?? day_seconds(point.received_at) ?? 0;

/** Tests of one day keep their order, a few hours apart. */
function times(points: readonly Point[]): number[] {
  let last = -Infinity;
  return points.map((point) => {
    last = Math.max(seconds_of(point), last + 3 * 3600);
    return last;
  });
}

const by_day = (a: Point, b: Point): number =>
  seconds_of(a) - seconds_of(b) || a.test - b.test;

/** The uncertainty of record as it was stated; ± U of a version from before its interval was kept. */
function ends_of({ value, U, low, high }: Point['figures'][number]): Ends | null {
  if (low !== null && high !== null) return [low, high];
  return U === null ? null : [value - U, value + U];
}

/** The history of an axis: chosen parameters over time with their uncertainty as bars and limits as lines, and the same as numbers. */
export function AxisTrend({ axis, version, height, tables = no_tables }: { axis: number; version: number; height: number; tables?: readonly CompensationHead[] }) {
  const [chosen, set_chosen] = useState<readonly Parameter[] | null>(null);
  const trend = use_get<Trend>(`/api/axes/${axis}/trend?parameters=${parameters.join(',')}&limit=500`);
  const drawn = useRef(version);
  useEffect(() => { if (drawn.current !== version) { drawn.current = version; trend.reload(); } }, [version]);  // its limits were edited
  if (trend.error && !trend.data) return <FailureNotice error={trend.error} retry={trend.reload} />;
  if (!trend.data) return <div style={{ height: `${height}px` }} />;
  if (trend.data.points.length === 0) return <p class="quiet">{t('no_tests')}</p>;
  const wanted = chosen ?? first_wanted(trend.data.points);
  const toggle = (key: string) => set_chosen(parameters.filter((one) => (one === key ? !wanted.includes(one) : wanted.includes(one))));
  const given = parameters.filter((key) => trend.data?.points.some((point) => point.figures.some((figure) => figure.parameter === key)));
  return (
    <div class="stack trend">
      <ChartLegend
        label={t('parameters')} on_toggle={toggle}
        items={given.map((key) => ({ key, label: <ParameterSymbol parameter={key} />, look: look(key), shown: wanted.includes(key) }))}
      />
      <TrendChart trend={trend.data} wanted={wanted} height={height} tables={tables} />
      <p class="quiet small">{t('click_hint')} {tables.length > 0 && t('tables_hint')} <span class="record-note">{record_note(trend.data.points.map(({ figures }) => figures))}</span> <OtherLimits trend={trend.data} wanted={wanted} /></p>
      <TrendTable trend={trend.data} wanted={given.filter((key) => wanted.includes(key))} />
    </div>
  );
}

/** Of every test A, E, R and B, or what one of a single direction has in their place. */
function first_wanted(points: readonly Point[]): Parameter[] {
  const keys = points.flatMap(({ figures }) => (['A', 'E', 'R', 'B'] as const).map((key) => at_hand(figures, key)));
  return parameters.filter((key) => keys.includes(key));
}

/** The limits of the axis; where it has none for a parameter, that of the last test. */
function limits_of(trend: Trend, points: readonly Point[]): Limit[] {
  const last = points[points.length - 1];
  return parameters.flatMap((parameter) => {
    const value = trend.axis.limits.find((limit) => limit.parameter === parameter)?.value
      ?? last?.figures.find((figure) => figure.parameter === parameter)?.limit;
    return value === undefined || value === null ? [] : [{ parameter, value }];
  });
}

/** Tests that were held against other limits than those that are drawn. */
function OtherLimits({ trend, wanted }: { trend: Trend; wanted: readonly Parameter[] }) {
  const drawn = limits_of(trend, [...trend.points].sort(by_day));
  const others = trend.points.filter((point) => point.figures.some(({ parameter, limit }) =>
    limit !== null && wanted.includes(parameter) && drawn.some((one) => one.parameter === parameter && one.value !== limit)));
  if (others.length === 0) return null;
  const named = others.slice(0, most_named).map(({ title }) => title).join(', ') + (others.length > most_named ? ', …' : '');
  return <span class="other-limits">{t('other_limits', { n: others.length, named })}</span>;
}

/** Where tables were made stands behind the test that they were made of. */
function marks_of(tables: readonly CompensationHead[], points: readonly Point[], x: readonly number[]): ChartMark[] {
  return tables.flatMap((table) => {
    const k = points.findIndex((point) => kept_as(point).includes(table.test.id));
    const at = k >= 0 ? (x[k] as number) : day_seconds(table.test.measured_on);
    return at === null ? [] : [{ x: at, label: short_control(table.control.title), colour: '--ink-quiet', aside: 10 }];
  });
}

/** The test and those kept of the same bytes. */
const kept_as = (point: Point): readonly number[] => [point.test, ...point.same_bytes];

const same_bytes_words = (point: Point): string[] =>
  (point.same_bytes.length === 0 ? [] : [t('same_bytes', { n: point.same_bytes.length, ids: point.same_bytes.join(', ') })]);

/** What tables have to do with a test, in words. */
function table_words(tables: readonly CompensationHead[], point: Point): string[] {
  const tests = kept_as(point);
  return tables.flatMap((table) => [
    ...(tests.includes(table.test.id) ? [t('table_made', { id: table.id, control: short_control(table.control.title) })] : []),
    ...(table.retest && tests.includes(table.retest.id) ? [t(table.retest.revised ? 'table_unproved' : 'table_proved', { id: table.id, control: short_control(table.control.title) })] : []),
  ]);
}

function TrendChart({ trend, wanted, height, tables }: { trend: Trend; wanted: readonly Parameter[]; height: number; tables: readonly CompensationHead[] }) {
  const unit = unit_sign(trend.unit);
  const points = useMemo(() => [...trend.points].sort(by_day), [trend]);
  const x = useMemo(() => times(points), [points]);
  const series = useMemo((): ChartSeries[] => parameters.map((key) => {
    const figures = points.map((point) => point.figures.find((figure) => figure.parameter === key));
    return {
      key, label: plain_symbol(key), ...look(key), size: 7, aside: 3 * (wanted.indexOf(key) - (wanted.length - 1) / 2), across: true, hidden: !wanted.includes(key),
      values: figures.map((figure) => figure?.value ?? null), whisker: figures.map((figure) => (figure ? ends_of(figure) : null)),
    };
  }), [points, wanted]);
  const marks = useMemo(() => marks_of(tables, points, x), [tables, points, x]);
  const lines = useMemo((): ChartLine[] => limits_of(trend, points).filter((limit) => wanted.includes(limit.parameter)).map((limit) => ({
    value: limit.value, colour: look(limit.parameter).colour,
    label: t('limit_line', { parameter: plain_symbol(limit.parameter), value: shortest(limit.value), unit }),
  })), [trend, points, wanted, unit]);
  const tip = (place: ChartPlace) => {
    const point = points[place.index];
    if (!point) return null;
    return (
      <>
        <div class="head"><Day test={point} /></div>
        <div class="title">{point.title}</div>
        <table>
          <tbody>
            {wanted.map((key) => (
              <tr key={key} class={series[place.series ?? -1]?.key === key ? 'strong' : ''}>
                <td><ParameterSymbol parameter={key} /></td>
                <td class="number"><FigureCell shown={shown_of(point.figures, key)} /> {unit}</td>
              </tr>
            ))}
          </tbody>
        </table>
        {[...table_words(tables, point), ...same_bytes_words(point)].map((words) => <div key={words}>{words}</div>)}
        {method_of(point.figures) !== null && <div class="quiet">{t('by_method', { method: named_method(method_of(point.figures)) })}</div>}
      </>
    );
  };
  const spoken = (place: ChartPlace) => {
    const point = points[place.index];
    const keys = place.series === null ? wanted : [parameters[place.series] as Parameter];
    const said = keys.map((key) => {
      const shown = point ? shown_of(point.figures, key) : null;
      return [plain_symbol(key), shown?.value ?? absent, shown ? uncertainty_text(shown) : '', unit].filter((part) => part !== '').join(' ');
    });
    const method = named_method(method_of(point?.figures ?? []));
    const further = [...(point ? [...table_words(tables, point), ...same_bytes_words(point)] : []), ...(method === '' ? [] : [t('by_method', { method })])];
    return `${point ? day_of_test(point) : ''}, ${point?.title}${colon()} ${[said.join(semicolon()), ...further].join(semicolon())}`;
  };
  return (
    <Chart
      name={t('trend_of', { axis: trend.axis.name })} height={height} x={x} x_kind="time" x_label={t('measured')}
      y_label={t('value_in', { unit })} y_zero series={series} lines={lines} marks={marks} tip={tip} spoken={spoken}
      on_choose={(place) => { const point = points[place.index]; if (point) go(`/tests/${point.test}`); }}
    />
  );
}

function TrendTable({ trend, wanted }: { trend: Trend; wanted: readonly Parameter[] }) {
  const points = [...trend.points].sort((a, b) => by_day(b, a));
  const figures = points.map((point) => point.figures);
  const named = differ(figures);
  return (
    <details class={`numbers ${some_interval(figures) ? 'with-intervals' : ''}`} open={points.length <= 12}>
      <summary>{t('numbers')}</summary>
      <DataTable<Point>
        caption={t('trend_of', { axis: trend.axis.name })} rows={points} row_key={(point) => point.test}
        columns={[
          { key: 'measured', head: t('measured'), class: 'number-text wide-only', cell: (point) => <Day test={point} /> },
          { key: 'test', head: t('test'), row_head: true, cell: (point) => (
            <><a href={`/tests/${point.test}`}>{point.title}</a><span class="only-narrow quiet small number-text"><Day test={point} /></span>
              {named && method_of(point.figures) !== null && <span class="by-method quiet small">{t('by_method', { method: named_method(method_of(point.figures)) })}</span>}
              {same_bytes_words(point).map((words) => <span key={words} class="same-bytes quiet small"> {words}</span>)}</>
          ) },
          ...wanted.map((key) => ({
            key, head: <ParameterHead parameter={key} unit={unit_sign(trend.unit)} with_U={some_U(figures)} />, number: true,
            cell: (point: Point) => <FigureCell shown={shown_of(point.figures, key)} decimals={column_decimals(figures, key)} />,
          })),
          { key: 'verdict', head: t('verdict'), cell: (point) => <VerdictMark verdict={verdict_of(point)} short /> },
        ]}
      />
    </details>
  );
}
