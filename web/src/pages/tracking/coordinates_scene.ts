// SPDX-License-Identifier: Apache-2.0
// Stations and points that were found, in terms of the picture; with nominal points arrows from these.
import type { SceneArrow, SceneModel, ScenePoint } from '../../components/scene';
import { station_solids, type Place } from '../../components/scene';
import type { Coordinates } from './coordinates';

const most_points = 300;   // of very many some
const most_names = 30;
const place = (numbers: readonly number[]): Place => [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];

export const off_um = ({ deviation_um }: Coordinates['points'][number]): number => Math.hypot(...(deviation_um ?? [0]));

/** A round number with which the longest arrow is about a tenth of the extent. */
function enlargement(size_mm: number, most_um: number): number {
  const wanted = most_um > 0 ? (0.1 * size_mm) / (most_um / 1000) : 1;
  const step = 10 ** Math.floor(Math.log10(wanted));
  return step * ([5, 2, 1].find((n) => n * step <= wanted) ?? 1);
}

export interface CoordinatesScene { model: SceneModel; enlarged: number; most_um: number }

export function coordinates_scene({ points, stations }: Coordinates, label: string): CoordinatesScene {
  const shown = points.length <= most_points ? points : Array.from({ length: most_points }, (_, k) => points[Math.floor((k * points.length) / most_points)] as (typeof points)[number]);
  const low = [0, 1, 2].map((c) => Math.min(...shown.map(({ position_mm }) => position_mm[c] ?? 0)));
  const high = [0, 1, 2].map((c) => Math.max(...shown.map(({ position_mm }) => position_mm[c] ?? 0)));
  const size = Math.hypot(...[0, 1, 2].map((c) => (high[c] ?? 0) - (low[c] ?? 0))) || 1;
  const most_um = Math.max(0, ...shown.map(off_um));
  const enlarged = enlargement(size, most_um);
  const foot = Math.min(low[2] ?? 0, ...stations.map(({ position_mm }) => (position_mm[2] ?? 0) - 0.05 * size));
  const arrows = shown.filter(({ deviation_um }) => deviation_um).map((point): SceneArrow => {
    const by = place(point.deviation_um ?? []).map((um) => (um * enlarged) / 1000) as unknown as Place;
    const at = place(point.position_mm).map((mm, c) => mm - (point.deviation_um?.[c] ?? 0) / 1000) as unknown as Place;
    return { key: point.name, at, by, value: off_um(point) };
  });
  const model: SceneModel = {
    box: { low: place(low), high: place(high) },
    solids: stations.flatMap(({ name, position_mm }) => station_solids(`station-${name}`, place(position_mm), 0.025 * size, foot, name)),
    points: shown.map(({ name, position_mm }): ScenePoint => ({ key: `point-${name}`, at: place(position_mm), colour: '--series-1', size: arrows.length > 0 ? 4 : 6, ...(shown.length <= most_names ? { label: name } : {}) })),
    ...(arrows.length > 0 ? { arrows, scale: { label, unit: 'µm', low: 0, high: most_um } } : {}),
  };
  return { model, enlarged, most_um };
}
