// SPDX-License-Identifier: Apache-2.0
// Where the pointer is in terms of the data; wheel and fingers on the plot.
import type uPlot from 'uplot';
import type { ChartModel, ChartPlace } from './model';

/** The x nearest to the pointer, and the visible series whose point there is near it. */
export function pointed_at(plot: uPlot, model: ChartModel, left: number, top: number): ChartPlace | null {
  if (left < 0 || model.x.length === 0) return null;
  const index = plot.posToIdx(left);
  let series: number | null = null;
  let nearest = 28;  // px
  model.series.forEach((one, i) => {
    const value = one.values[index];
    if (one.hidden || one.quiet || typeof value !== 'number') return;
    const distance = Math.abs(plot.valToPos(value, 'y') - top);
    if (distance < nearest) { nearest = distance; series = i; }
  });
  return { index, series };
}

export interface FingerEvents {
  zoom: (factor: number, around: number) => void;
  point: (left: number, top: number) => void;
  wheel_zooms: (event: WheelEvent) => boolean;
}

/** One finger moves the cursor, two zoom; the page still scrolls up and down. Ends with `signal`. */
export function watch_fingers(plot: uPlot, events: FingerEvents, signal: AbortSignal): void {
  const over = plot.over;
  const fingers = new Map<number, { x: number; y: number }>();
  const inside = (event: { clientX: number; clientY: number }) => {
    const frame = over.getBoundingClientRect();
    return { x: event.clientX - frame.left, y: event.clientY - frame.top };
  };
  const apart = () => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.max(20, Math.abs(a.x - b.x)) : null;
  };
  over.addEventListener('wheel', (event) => {
    if (!events.wheel_zooms(event)) return;
    event.preventDefault();
    events.zoom(event.deltaY > 0 ? 1.25 : 0.8, plot.posToVal(inside(event).x, 'x'));
  }, { signal, passive: false });
  over.addEventListener('pointerdown', (event) => {
    if (event.pointerType !== 'touch') return;
    fingers.set(event.pointerId, inside(event));
    if (fingers.size === 1) events.point(inside(event).x, inside(event).y);
  }, { signal });
  over.addEventListener('pointermove', (event) => {
    if (!fingers.has(event.pointerId)) return;
    const before = apart();
    fingers.set(event.pointerId, inside(event));
    const now = apart();
    if (before === null || now === null) { events.point(inside(event).x, inside(event).y); return; }
    const [a, b] = [...fingers.values()];
    if (a && b) events.zoom(before / now, plot.posToVal((a.x + b.x) / 2, 'x'));
  }, { signal });
  for (const end of ['pointerup', 'pointercancel'] as const) {
    over.addEventListener(end, (event) => fingers.delete(event.pointerId), { signal });
  }
}
