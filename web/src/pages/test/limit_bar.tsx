// SPDX-License-Identifier: Apache-2.0

interface Props {
  value: number; low: number | null; high: number | null;   // ends of the interval of record
  limit: number | null; tone: 'good' | 'bad' | 'caution' | 'none'; reach?: number;
}

/** `reach`: of the scale where there is no limit. A value as a bar, its interval as a whisker, its limit as a line across. The numbers stand beside it. */
export function LimitBar({ value, low, high, limit, tone, reach: common = 0 }: Props) {
  const size = Math.abs(value);
  // Of a negative value the magnitude is drawn, and its interval with it.
  const ends = low === null || high === null ? null : value < 0 ? [-high, -low] as const : [low, high] as const;
  const reach = Math.max((limit ?? 0) * 1.25, Math.max(size, ends?.[1] ?? 0) * 1.02, limit === null ? common * 1.02 : 0, 1e-9);
  const x = (v: number): number => Math.round(Math.min(Math.max(v / reach, 0), 1) * 1000) / 10;
  return (
    <svg class={`limit-bar ${tone}`} viewBox="0 0 100 14" preserveAspectRatio="none" aria-hidden="true">
      <line class="track" x1="0" x2="100" y1="13.5" y2="13.5" />
      <rect class="value" x="0" y="4" width={x(size)} height="6" />
      {ends !== null && (
        <>
          <line class="whisker" x1={x(ends[0])} x2={x(ends[1])} y1="7" y2="7" />
          {ends.map((end, i) => <line key={i} class="whisker" x1={x(end)} x2={x(end)} y1="4.5" y2="9.5" />)}
        </>
      )}
      {limit !== null && <line class="limit" x1={x(limit)} x2={x(limit)} y1="0" y2="14" />}
    </svg>
  );
}
