// SPDX-License-Identifier: Apache-2.0
// What happened at an x: lines from top to bottom, their names above the plot, where nothing measured is covered.
import type uPlot from 'uplot';
import { mark_rows, type ChartMark, type ChartModel } from './model';
import { inside, token } from './paint';

export const mark_row_px = 15;

interface Placed { mark: ChartMark; at: number; room: Room | null }

/** Where a name stands: in which row above the plot, and from where to where. */
export interface Room { row: number; left: number; right: number }

/**
 * Rooms for names beside their marks, right of them if possible, in the lowest row in which a name lies over no other one,
 * over no line that goes up to another, and no other one over its own line. A name without room is left out: its line
 * stays, and what the chart tells at its place says it.
 */
export function rooms_of(marks: readonly { at: number; width: number }[], rows: number, [low, high]: readonly [number, number], gap: number): (Room | null)[] {
  const taken: (Room & { at: number })[] = [];
  const is_free = (at: number, { row, left, right }: Room): boolean => left >= low && right <= high && taken.every((other) =>
    (other.row !== row || left >= other.right + gap || right + gap <= other.left)
    && (other.row < row || other.at < left || other.at > right)
    && (row < other.row || at < other.left || at > other.right));
  // The last one first: a name goes on to the right, so that those before it stand above it.
  const found = [...marks].reverse().map(({ at, width }) => {
    for (let row = 0; row < rows; row += 1) {
      for (const left of [at + gap, at - gap - width]) {
        const room = { row, left, right: left + width };
        if (!is_free(at, room)) continue;
        taken.push({ ...room, at });
        return room;
      }
    }
    return null;
  });
  return found.reverse();
}

function placed(plot: uPlot, pen: CanvasRenderingContext2D, model: ChartModel, ratio: number): Placed[] {
  const { left, width } = plot.bbox;
  pen.font = `${11 * ratio}px ${token('--font')}`;
  const seen = (model.marks ?? []).map((mark) => ({ mark, at: plot.valToPos(mark.x, 'x', true) }))
    .filter(({ at }) => at >= left && at <= left + width)
    .map(({ mark, at }) => ({ mark, at: Math.min(at + (mark.aside ?? 0) * ratio, left + width - ratio) })).sort((a, b) => a.at - b.at);
  // Above the scale at the left, and the end of the last date at the right, is room too.
  const reach = [0, plot.width * ratio] as const;
  const rooms = rooms_of(seen.map(({ mark, at }) => ({ at, width: pen.measureText(mark.label).width })), mark_rows(model), reach, 4 * ratio);
  return seen.map((one, k) => ({ ...one, room: rooms[k] ?? null }));
}

/** Behind all that was measured. */
export function paint_marks(plot: uPlot, model: ChartModel, ratio: number): void {
  if (!model.marks?.length) return;
  const pen = plot.ctx;
  const all = placed(plot, pen, model, ratio);
  const { top, height } = plot.bbox;
  inside(plot, () => {
    pen.setLineDash([2 * ratio, 2 * ratio]);
    pen.lineWidth = 1.25 * ratio;
    for (const { mark, at } of all) line(pen, mark, at, top, top + height);
  });
  pen.save();
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  for (const { mark, at, room } of all) {
    if (room === null) continue;
    const middle = top - (room.row + 0.5) * mark_row_px * ratio - 2 * ratio;
    pen.lineWidth = 1.25 * ratio;
    line(pen, mark, at, middle - mark_row_px * 0.4 * ratio, top);
    pen.fillStyle = token(mark.colour);
    pen.lineJoin = 'round';
    pen.lineWidth = 4 * ratio;
    pen.strokeStyle = token('--surface');
    pen.strokeText(mark.label, room.left, middle);
    pen.fillText(mark.label, room.left, middle);
  }
  pen.restore();
}

function line(pen: CanvasRenderingContext2D, mark: ChartMark, at: number, from: number, to: number): void {
  pen.strokeStyle = token(mark.colour);
  pen.beginPath();
  pen.moveTo(at, from);
  pen.lineTo(at, to);
  pen.stroke();
}
