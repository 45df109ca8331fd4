// SPDX-License-Identifier: Apache-2.0
import type { Axis } from '../../api/types';
import { shown_of } from '../../components/figure_cell';
import { Spark } from '../../components/spark';
import { absent, shortest, unit_sign } from '../../numbers';
import { courses } from './axis_courses';
import { is_over } from './parameters';
import { t } from './texts';

/** One axis among many: its name, the course of A against its limit, the last value. */
export function AxisSpark({ axis }: { axis: Axis }) {
  const trend = courses.value.get(axis.id);
  const points = trend?.points.filter((point) => point.figures.some((figure) => figure.parameter === 'A')) ?? [];
  const figures = points.flatMap((point) => point.figures.filter((figure) => figure.parameter === 'A'));
  const last = figures[figures.length - 1];
  const value = shown_of(points[points.length - 1]?.figures ?? [], 'A')?.value ?? absent;
  const limit = axis.limits.find((one) => one.parameter === 'A')?.value ?? last?.limit ?? null;
  const unit = trend ? unit_sign(trend.unit) : '';
  const label = last
    ? t('spark', { axis: axis.name, value, unit, n: figures.length }) + (limit === null ? '' : t('spark_limit', { limit: shortest(limit) }))
    : axis.name;
  return (
    <a class="axis-spark" href={`/axes/${axis.id}`} title={label}>
      <span class="axis-name">{axis.name}</span>
      {last ? <Spark values={figures.map((figure) => figure.value)} over={figures.map((figure) => is_over(figure, limit))} limit={limit} label={label} /> : <span class="blank" />}
      <span class={`number value ${last && is_over(last, limit) ? 'over' : ''}`}>{value}{last && <span class="quiet small unit">{unit}</span>}</span>
    </a>
  );
}
