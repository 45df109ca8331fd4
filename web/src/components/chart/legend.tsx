// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import type { ChartSeries } from './model';

const r = 3.4;
const shapes = {
  circle: `M9 5m-${r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 -${2 * r} 0`,
  ring: `M9 5m-${r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 -${2 * r} 0`,
  square: 'M6 2h6v6h-6z',
  diamond: 'M9 1l4 4-4 4-4-4z',
  up: 'M9 1l4 7h-8z',
  down: 'M9 9l4-7h-8z',
};

/** `area`: not of a line but of bands, one colour beside the other. */
type Look = Pick<ChartSeries, 'colour' | 'width' | 'dash' | 'shape'> & { area?: readonly string[] };

/** A piece of a series as the chart draws it: its line and its point. */
export function Swatch({ series }: { series: Look }) {
  const colour = `var(${series.colour})`;
  if (series.area) {
    const width = 18 / series.area.length;
    return (
      <svg class="swatch" width="18" height="10" viewBox="0 0 18 10" aria-hidden="true">
        {series.area.map((one, i) => <rect key={one} x={i * width} y="0" width={width} height="10" fill={`var(${one})`} fill-opacity="0.45" />)}
      </svg>
    );
  }
  return (
    <svg class="swatch" width="18" height="10" viewBox="0 0 18 10" aria-hidden="true">
      {series.width !== 0 && (
        <path d="M0 5h18" fill="none" stroke={colour} stroke-width={Math.min(series.width ?? 1.5, 3)} stroke-dasharray={series.dash?.join(' ')} />
      )}
      {series.shape && (
        <path d={shapes[series.shape]} fill={series.shape === 'ring' ? 'var(--surface)' : colour} stroke={colour} stroke-width="1.2" />
      )}
    </svg>
  );
}

interface Item { key: string; label: ComponentChildren; look: Look; shown: boolean }

/** What the chart's lines mean, and switches for them. */
export function ChartLegend({ items, label, on_toggle }: { items: readonly Item[]; label: string; on_toggle: (key: string) => void }) {
  return (
    <div class="legend" role="group" aria-label={label}>
      {items.map((item) => (
        <button key={item.key} type="button" aria-pressed={item.shown} onClick={() => on_toggle(item.key)}>
          <Swatch series={item.look} /> {item.label}
        </button>
      ))}
    </div>
  );
}
