// SPDX-License-Identifier: Apache-2.0
import type { ChartModel, ChartPlace } from './model';

/** What a key on a chart means: a new place of the cursor, a zoom, or nothing (null). */
export function chart_key(event: KeyboardEvent, model: ChartModel, at: ChartPlace | null): ChartPlace | 'in' | 'out' | 'all' | 'none' | 'choose' | null {
  if (event.ctrlKey || event.metaKey || event.altKey || model.x.length === 0) return null;
  const last = model.x.length - 1;
  const to = (index: number): ChartPlace => ({ index: Math.min(Math.max(index, 0), last), series: at?.series ?? null });
  switch (event.key) {
    case 'ArrowRight': return to(at ? at.index + 1 : 0);
    case 'ArrowLeft': return to(at ? at.index - 1 : last);
    case 'Home': return to(0);
    case 'End': return to(last);
    case 'ArrowUp': return along(model, at, -1);
    case 'ArrowDown': return along(model, at, 1);
    case '+': return 'in';
    case '-': return 'out';
    case '0': return 'all';
    case 'Escape': return at ? 'none' : null;
    case 'Enter': return event.target === event.currentTarget ? 'choose' : null;
    default: return null;
  }
}

/** The next visible series that has a value at this x; after the last one comes "all of them" again. */
function along(model: ChartModel, at: ChartPlace | null, step: 1 | -1): ChartPlace {
  const index = at?.index ?? 0;
  const there = model.series.flatMap((s, i) => (!s.hidden && !s.quiet && typeof s.values[index] === 'number' ? [i] : []));
  const choices: (number | null)[] = [null, ...there];
  const found = choices.indexOf(at?.series ?? null);
  return { index, series: choices[(Math.max(found, 0) + step + choices.length) % choices.length] ?? null };
}
