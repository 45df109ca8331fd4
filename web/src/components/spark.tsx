// SPDX-License-Identifier: Apache-2.0
import './spark.css';

interface Props { values: readonly number[]; over: readonly boolean[]; limit: number | null; width?: number; height?: number; label: string }

/** A course at a glance: from 0 to a little above the largest value or the limit, which is a dashed line. */
export function Spark({ values, over, limit, width = 112, height = 34, label }: Props) {
  const top = Math.max(...values, limit ?? 0) * 1.12 || 1;
  const x = (i: number) => (values.length < 2 ? width / 2 : 3 + (i / (values.length - 1)) * (width - 6));
  const y = (value: number) => height - 2 - (Math.max(value, 0) / top) * (height - 5);
  return (
    <svg class="spark" width={width} height={height} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
      <path class="ground" d={`M0 ${height - 1.5}H${width}`} />
      {limit !== null && <path class="limit" d={`M0 ${y(limit)}H${width}`} />}
      <polyline class="course" points={values.map((value, i) => `${x(i)},${y(value)}`).join(' ')} />
      {values.map((value, i) => {
        if (over[i]) return <path key={i} class="over" d={`M${x(i)} ${y(value) - 3.6}l3.6 3.6-3.6 3.6-3.6-3.6z`} />;
        return i === values.length - 1 ? <circle key={i} class="last" cx={x(i)} cy={y(value)} r="2.4" /> : null;
      })}
    </svg>
  );
}
