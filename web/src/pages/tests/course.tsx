// SPDX-License-Identifier: Apache-2.0
import type { PositionResult } from '../../api/types';
import { t } from './texts';

const [width, height, edge] = [96, 24, 2];

/** The mean deviations of both directions over the axis, at a glance; the line is zero. */
export function Course({ positions }: { positions: readonly PositionResult[] }) {
  const means = positions.flatMap((one) => [one.mean_up, one.mean_down]).filter((mean) => mean !== null);
  if (means.length === 0) return null;
  const [least, most] = [Math.min(0, ...means), Math.max(0, ...means)];
  const [first, last] = [Math.min(...positions.map((one) => one.target)), Math.max(...positions.map((one) => one.target))];
  const x = (target: number) => edge + ((target - first) / (last - first || 1)) * (width - 2 * edge);
  const y = (mean: number) => height - edge - ((mean - least) / (most - least || 1)) * (height - 2 * edge);
  const line = (key: 'mean_up' | 'mean_down') =>
    positions.flatMap((one) => (one[key] === null ? [] : [`${x(one.target).toFixed(1)},${y(one[key]).toFixed(1)}`])).join(' ');
  return (
    <svg class="course" width={width} height={height} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={t('course')}>
      <path class="zero" d={`M0 ${y(0).toFixed(1)}H${width}`} />
      <polyline class="up" points={line('mean_up')} />
      <polyline class="down" points={line('mean_down')} />
    </svg>
  );
}
