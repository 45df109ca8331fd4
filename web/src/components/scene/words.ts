// SPDX-License-Identifier: Apache-2.0
// Words beside what they name, so that none covers another. Pure.
import type { Flat } from './projection';

export interface Word { key: string; text: string; at: Flat; kind: 'axis' | 'end' | 'name'; colour?: string }
export interface PlacedWord extends Word { x: number; y: number; anchor: 'start' | 'middle' | 'end' }

const height = 14;
const width_of = (text: string): number => 7 * text.length;  // px at 12 px: a little more than it takes

interface Frame { left: number; right: number; top: number; bottom: number }

function frame_of({ x, y, anchor, text }: PlacedWord): Frame {
  const width = width_of(text);
  const left = anchor === 'start' ? x : anchor === 'end' ? x - width : x - width / 2;
  return { left, right: left + width, top: y - height + 3, bottom: y + 3 };
}

const overlap = (a: Frame, b: Frame): number =>
  Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) * Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

const beyond = (frame: Frame, size: Flat): number =>
  Math.max(0, -frame.left) + Math.max(0, frame.right - size[0]) + Math.max(0, -frame.top) + Math.max(0, frame.bottom - size[1]);

/** Where a word may stand about its place, the best first. */
const around: readonly (readonly [x: number, y: number, anchor: PlacedWord['anchor']])[] = [
  [7, -5, 'start'], [-7, -5, 'end'], [7, 14, 'start'], [-7, 14, 'end'], [0, -9, 'middle'], [0, 19, 'middle'],
  [18, -16, 'start'], [-18, -16, 'end'], [18, 26, 'start'], [-18, 26, 'end'],
];

/** Where the name of an axis, or an end of its travel, may stand instead: lines up and down, half its width and more aside. */
function near_by({ text }: Word): Flat[] {
  const aside = width_of(text) / 2 + 6;
  return [[0, 0], [0, height], [0, -height], [aside, 0], [-aside, 0], [aside, height], [-aside, height], [aside, -height], [-aside, -height],
          [0, 2 * height], [0, -2 * height], [2 * aside, 0], [-2 * aside, 0]];
}

/** Those that come first choose first; each is within the picture and off the others, as far as there is room. An end of a
 *  travel that would cover another word is left out. */
export function placed_words(words: readonly Word[], size: Flat): PlacedWord[] {
  const taken: Frame[] = [];
  return words.flatMap((word) => {
    const [x, y] = word.at;
    const places: PlacedWord[] = word.kind === 'name'
      ? around.map(([dx, dy, anchor]) => ({ ...word, x: x + dx, y: y + dy, anchor }))
      : near_by(word).map(([dx, dy]) => ({ ...word, x: x + dx, y: y + dy + 4, anchor: 'middle' }));
    const covered = (placed: PlacedWord) => taken.reduce((sum, other) => sum + overlap(frame_of(placed), other), 0);
    const cost = (placed: PlacedWord) => covered(placed) + 20 * beyond(frame_of(placed), size);
    const best = places.reduce((chosen, one) => (cost(one) < cost(chosen) - 1e-9 ? one : chosen));
    if (word.kind === 'end' && covered(best) > 0) return [];
    taken.push(frame_of(best));
    return [best];
  });
}
