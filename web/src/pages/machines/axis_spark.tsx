// SPDX-License-Identifier: Apache-2.0
import type { Axis, Parameter, Trend } from '../../api/types';
import { at_hand, shown_of } from '../../components/figure_cell';
import { Spark } from '../../components/spark';
import { ParameterSymbol } from '../../components/symbol';
import { absent, shortest, unit_sign } from '../../numbers';
import { courses } from './axis_courses';
import { is_over, plain_symbol } from './parameters';
import { t } from './texts';

/** By what the last test is known: A, or A↑ of a single direction; where approaches were not repeated E. */
function parameter_of(trend: Trend | undefined): Parameter {
  const figures = trend?.points[trend.points.length - 1]?.figures ?? [];
  const known = (['A', 'E'] as const).map((key) => at_hand(figures, key)).find((key) => figures.some((figure) => figure.parameter === key));
  return known ?? 'A';
}

/** One axis among many: its name, the course of what its last test is known by against its limit, the last value. */
export function AxisSpark({ axis }: { axis: Axis }) {
  const trend = courses.value.get(axis.id);
  const parameter = parameter_of(trend);
  const points = trend?.points.filter((point) => point.figures.some((figure) => figure.parameter === parameter)) ?? [];
  const figures = points.flatMap((point) => point.figures.filter((figure) => figure.parameter === parameter));
  const last = figures[figures.length - 1];
  const value = shown_of(points[points.length - 1]?.figures ?? [], parameter)?.value ?? absent;
  const limit = axis.limits.find((one) => one.parameter === parameter)?.value ?? last?.limit ?? null;
  const unit = trend ? unit_sign(trend.unit) : '';
  const label = last
    ? t('spark', { axis: axis.name, parameter: plain_symbol(parameter), value, unit, n: figures.length }) + (limit === null ? '' : t('spark_limit', { limit: shortest(limit) }))
    : axis.name;
  return (
    <a class="axis-spark" href={`/axes/${axis.id}`} title={label}>
      <span class="axis-name">{axis.name}</span>
      {last ? <Spark values={figures.map((figure) => figure.value)} over={figures.map((figure) => is_over(figure, limit))} limit={limit} label={label} /> : <span class="blank" />}
      <span class={`number value ${last && is_over(last, limit) ? 'over' : ''}`}>{last && parameter !== 'A' && <span class="quiet small"><ParameterSymbol parameter={parameter} /> </span>}{value}{last && <span class="quiet small unit">{unit}</span>}</span>
    </a>
  );
}
