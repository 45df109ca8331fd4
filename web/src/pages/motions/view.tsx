// SPDX-License-Identifier: Apache-2.0
// What straightness, angles or squareness has found: figures, curves, what is to be known. Of a file just evaluated and of
// one that is kept alike.
import type { MotionEstimate, MotionOfFile, MotionResult } from '../../api/types';
import { Chart, Swatch, type ChartModel } from '../../components/chart/chart';
import { DataTable } from '../../components/table';
import { absent, decimals_for, fixed } from '../../numbers';
import { sentence } from '../../components/findings';
import { t } from './texts';

interface Row { key: string; quantity: string; course: string; value: string; U: string; unit: string }

const signs = { um: 'µm', urad: 'µrad', arcsec: '″' } as const;
const arrows = { up: '↑', down: '↓' } as const;

/** The value to the last place of its U; without one to hundredths. */
function row_of(quantity: string, course: string, estimate: Pick<MotionEstimate, 'value' | 'U'>, unit: string): Row {
  const { value, U } = estimate;
  const told = U !== null && U > 1e-9;
  const decimals = told ? decimals_for(U, 2) : 2;
  return { key: `${quantity} ${course}`, quantity, course, value: fixed(value, decimals), U: told ? fixed(U, decimals) : absent, unit };
}

function rows_of(motion: MotionOfFile): Row[] {
  const unit = signs[motion.unit];
  const range = motion.unit === 'um' ? t('straightness') : t(motion.reference === 'none' ? 'angle' : 'residuals');
  const rows = motion.courses.flatMap(({ course, range: found, slope_per_m: slope }) => {
    const mark = course === 'mean' ? t('mean') : arrows[course];
    return [row_of(range, mark, found, unit), ...(slope ? [row_of(t('slope'), mark, slope, `${unit}/m`)] : [])];
  });
  const alone = (value: number | null): MotionEstimate[] => (value === null ? [] : [{ value, u: null, k: null, U: null }]);
  return [
    ...rows,
    ...(motion.range_both ? [row_of(t('both'), '↑↓', motion.range_both, unit)] : []),
    ...(motion.reversal ? [row_of(t('reversal'), '↑↓', motion.reversal, unit)] : []),
    ...alone(motion.repeatability_up).map((one) => row_of(t('repeatability'), '↑', one, unit)),
    ...alone(motion.repeatability_down).map((one) => row_of(t('repeatability'), '↓', one, unit)),
    ...alone(motion.repeatability).map((one) => row_of(t('repeatability'), '↑↓', one, unit)),
  ];
}

function FigureTable({ caption, rows }: { caption: string; rows: readonly Row[] }) {
  return (
    <DataTable<Row> caption={caption} rows={rows} row_key={({ key }) => key} columns={[
      { key: 'quantity', head: t('quantity'), row_head: true, cell: ({ quantity }) => quantity },
      ...(rows.some(({ course }) => course !== '') ? [{ key: 'course', head: t('course'), cell: ({ course }: Row) => course }] : []),
      { key: 'value', head: t('value'), number: true, cell: ({ value, unit }) => <>{value}<span class="unit"> {unit}</span></> },
      { key: 'U', head: 'U', number: true, cell: ({ U }) => U },
    ]} />
  );
}

/** Of a straightness without its line, which is what its range is of; of an angle as it was read unless a line was asked for. */
function chart_of(motion: MotionOfFile): ChartModel {
  const { position_mm: x, up, down, mean } = motion.positions;
  const level = motion.reference !== 'none';
  const values = (course: typeof up) => (level ? course?.residual : course?.mean) ?? [];
  const whisker = (course: typeof up) => course?.s?.map((s, k): readonly [number, number] | null => {
    const middle = values(course)[k];
    return middle === undefined || s === null ? null : [middle - 2 * s, middle + 2 * s];
  });
  const spread = (course: typeof up) => { const list = whisker(course); return list ? { whisker: list } : {}; };
  return {
    x, x_label: t('position'), y_label: level && motion.unit === 'um' ? t('less_line') : t('in_unit', { unit: signs[motion.unit] }), y_decimals: 3,
    series: [
      ...(up ? [{ key: 'up', label: t('up'), values: values(up), colour: '--series-up', width: 2, shape: 'up' as const, aside: -2, ...spread(up) }] : []),
      ...(down ? [{ key: 'down', label: t('down'), values: values(down), colour: '--series-down', width: 2, dash: [5, 2], shape: 'down' as const, aside: 2, ...spread(down) }] : []),
      ...(mean ? [{ key: 'mean', label: t('both_mean'), values: values(mean), colour: '--series-mean', width: 1.5, shape: null }] : []),
    ],
  };
}

function OneMotion({ motion }: { motion: MotionOfFile }) {
  const name = motion.error ?? t('unnamed');
  const model = chart_of(motion);
  const label = t(motion.reference === 'none' ? 'angles_of' : 'readings_of', { name });
  return (
    <section class="panel">
      <header><h2>{name} <span class="quiet small">{motion.source.file}{motion.read_positive && `, ${motion.read_positive}`}</span></h2></header>
      <p class="row small">{model.series.map((series) => <span key={series.key}><Swatch series={series} /> {series.label}</span>)}</p>
      <Chart {...model} name={label} height={280} />
      <FigureTable caption={name} rows={rows_of(motion)} />
    </section>
  );
}

function Squareness({ result }: { result: MotionResult }) {
  const { theta_1_arcsec: one, theta_2_arcsec: two, squareness_arcsec: both, location_error: location } = result;
  if (!one || !two || !both) return null;
  const rows = [
    row_of(t('theta_1'), '', one, '″'), row_of(t('theta_2'), '', two, '″'),
    row_of(t(result.in_axes ? 'square_axes' : 'square_plain'), '', both, '″'),
    ...(location ? [row_of(t('location', { name: location.name }), '', location.urad, 'µrad')] : []),
  ];
  return (
    <section class="panel">
      <header><h2>{t('squareness')}</h2></header>
      <FigureTable caption={t('squareness')} rows={rows} />
      {location && <p class="quiet small">{t('location_how')}</p>}
    </section>
  );
}

function AtPoint({ abbe }: { abbe: NonNullable<MotionResult['abbe']> }) {
  type Changes = Record<string, number[] | null>;
  const { change_um, change_up_um = {}, change_down_um = {} } = abbe as unknown as { change_um: Changes; change_up_um?: Changes; change_down_um?: Changes };
  const { course: told } = abbe as { course?: 'up' | 'down' | 'mean' | null }; // absent of what an older version kept
  const mark = told === 'mean' ? t('mean') : told ? arrows[told] : '';
  const changes = Object.entries(change_um).flatMap(([name, list]) => [
    ...(change_up_um[name] ? [{ name, course: arrows.up, list: change_up_um[name] }] : []),
    ...(change_down_um[name] ? [{ name, course: arrows.down, list: change_down_um[name] }] : []),
    { name, course: list ? mark : '', list },
  ]);
  const missing = abbe.missing as Record<string, string>;
  return (
    <section class="panel">
      <header><h2>{t('at_point')} <span class="quiet small">{abbe.offset_mm.map((mm) => fixed(mm, 1)).join(', ')} mm</span></h2></header>
      <DataTable<(typeof changes)[number]> caption={t('at_point')} rows={changes} row_key={({ name, course }) => `${name} ${course}`} columns={[
        { key: 'name', head: t('quantity'), row_head: true, cell: ({ name }) => name },
        ...(changes.some(({ course }) => course !== '') ? [{ key: 'course', head: t('course'), cell: ({ course }: (typeof changes)[number]) => course }] : []),
        { key: 'range', head: t('change_range'), number: true, cell: ({ list }) => (list ? fixed(Math.max(...list) - Math.min(...list), 3) : absent) },
        ...(Object.keys(missing).length > 0 ? [{ key: 'missing', head: t('missing'), cell: ({ name }: (typeof changes)[number]) => missing[name] ?? '' }] : []),
      ]} />
    </section>
  );
}

export function MotionView({ result }: { result: MotionResult }) {
  const motions = result.straightness ? [result.straightness] : result.angles ?? result.lines ?? [];
  const remarks = [...new Set([...(result.remarks ?? []), ...motions.flatMap((motion) => motion.remarks)])];
  return (
    <>
      <Squareness result={result} />
      {motions.map((motion, k) => <OneMotion key={k} motion={motion} />)}
      {result.abbe && <AtPoint abbe={result.abbe} />}
      {remarks.length > 0 && (
        <section class="panel">
          <header><h2>{t('to_know')}</h2></header>
          <ul>{remarks.map((remark) => <li key={remark}>{sentence(remark)}</li>)}</ul>
        </section>
      )}
      <p class="quiet small">{t('not_checked')}</p>
    </>
  );
}
