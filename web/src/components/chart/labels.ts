// SPDX-License-Identifier: Apache-2.0
// Where the names of limits stand: beside their line, where they hide the least of what was measured and no other name.
import type uPlot from 'uplot';
import type { ChartLine, ChartModel } from './model';
import { token } from './paint';

interface Box { left: number; top: number; right: number; bottom: number }
type Stroke = readonly [x0: number, y0: number, x1: number, y1: number];

/** From the right end of the line, where a limit is looked for, to its left. */
const along = [1, 0, 0.75, 0.5, 0.25];
const of_name = 100;   // a name under another is worse than all lines through it
const of_limit = 3;

export function paint_line_labels(plot: uPlot, pen: CanvasRenderingContext2D, model: ChartModel, ratio: number): void {
  const lines = (model.lines ?? []).filter((line) => !line.hidden && line.label !== '');
  if (lines.length === 0) return;
  const levels = (model.lines ?? []).filter((line) => !line.hidden).map((line) => plot.valToPos(line.value, 'y', true));
  const strokes = strokes_of(plot, model);
  const taken: Box[] = [];
  pen.setLineDash([]);
  pen.globalAlpha = 1;
  pen.font = `${11 * ratio}px ${token('--font')}`;
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  pen.lineWidth = 4 * ratio;
  pen.strokeStyle = token('--surface');
  for (const line of lines) {
    const box = best_box(plot, line, pen.measureText(line.label).width, taken, strokes, levels, ratio);
    if (!box) continue;
    taken.push(box);
    pen.fillStyle = token(line.colour);
    const middle = (box.top + box.bottom) / 2;
    pen.strokeText(line.label, box.left, middle);
    pen.fillText(line.label, box.left, middle);
  }
}

function best_box(
  plot: uPlot, line: ChartLine, width: number, taken: readonly Box[], strokes: readonly Stroke[], levels: readonly number[], ratio: number,
): Box | null {
  const [margin, gap, height] = [4 * ratio, 2 * ratio, 14 * ratio];
  const y = plot.valToPos(line.value, 'y', true);
  const { left, top, width: across, height: down } = plot.bbox;
  if (y < top || y > top + down) return null;
  let best: Box | null = null;
  let least = Infinity;
  for (const [rank, share] of along.entries()) {
    const start = left + margin + share * Math.max(across - width - 2 * margin, 0);
    for (const upper of [y - gap - height, y + gap]) {
      if (upper < top || upper + height > top + down) continue;
      const box = { left: start, right: start + width, top: upper, bottom: upper + height };
      const cost = rank * 0.1
        + taken.filter((other) => overlap(box, other)).length * of_name
        + levels.filter((level) => level > box.top && level < box.bottom).length * of_limit
        + strokes.filter((stroke) => crosses(box, stroke)).length;
      if (cost < least) [best, least] = [box, cost];
    }
  }
  return best;
}

/** What was measured, as it stands on the canvas: lines from point to point, and whiskers. */
function strokes_of(plot: uPlot, model: ChartModel): Stroke[] {
  const all: Stroke[] = [];
  const places = model.x.map((x) => plot.valToPos(x, 'x', true));
  for (const series of model.series) {
    if (series.hidden) continue;
    let before: readonly [number, number] | null = null;
    places.forEach((x, i) => {
      const value = series.values[i];
      if (typeof value !== 'number') return;
      const y = plot.valToPos(value, 'y', true);
      const ends = series.whisker?.[i];
      if (ends) all.push([x, plot.valToPos(ends[1], 'y', true), x, plot.valToPos(ends[0], 'y', true)]);
      all.push(before && series.width !== 0 ? [...before, x, y] : [x, y, x, y]);
      before = [x, y];
    });
  }
  return all;
}

const overlap = (a: Box, b: Box): boolean => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Whether a part of the stroke lies in the box: what is left of it between the four sides. */
function crosses(box: Box, [x0, y0, x1, y1]: Stroke): boolean {
  let [from, to] = [0, 1];
  const cut = (start: number, run: number, low: number, high: number): boolean => {
    if (run === 0) return start >= low && start <= high;
    const [a, b] = [(low - start) / run, (high - start) / run];
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
    return from <= to;
  };
  return cut(x0, x1 - x0, box.left, box.right) && cut(y0, y1 - y0, box.top, box.bottom);
}
