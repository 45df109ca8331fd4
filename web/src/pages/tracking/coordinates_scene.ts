// SPDX-License-Identifier: Apache-2.0
// Stations and points that were found, in terms of the picture; with nominal points arrows from these.
import type { Place, SceneArrow, SceneModel, ScenePoint } from '../../components/scene/scene';
import { station_solids } from '../../components/scene/model';
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

/** Points of the whole measurement, and in the place of the one next to it that which is farthest off. */
function some_of(points: Coordinates['points']): Coordinates['points'] {
  const places = Array.from({ length: most_points }, (_, k) => Math.floor((k * points.length) / most_points));
  const farthest = points.reduce((most, point, k) => (off_um(point) > off_um(points[most] as typeof point) ? k : most), 0);
  if (!places.includes(farthest)) places[Math.floor((farthest * most_points) / points.length)] = farthest;
  return places.map((k) => points[k] as Coordinates['points'][number]);
}

/** `farthest` is the name of the point with the longest arrow of all. */
export interface CoordinatesScene { model: SceneModel; enlarged: number; most_um: number; farthest: string }

export function coordinates_scene({ points, stations }: Coordinates, label: string): CoordinatesScene {
  const shown = points.length <= most_points ? points : some_of(points);
  const low = [0, 1, 2].map((c) => Math.min(...shown.map(({ position_mm }) => position_mm[c] ?? 0)));
  const high = [0, 1, 2].map((c) => Math.max(...shown.map(({ position_mm }) => position_mm[c] ?? 0)));
  const size = Math.hypot(...[0, 1, 2].map((c) => (high[c] ?? 0) - (low[c] ?? 0))) || 1;
  const farthest = shown.reduce<(typeof shown)[number] | null>((most, point) => (off_um(point) > (most ? off_um(most) : 0) ? point : most), null);
  const most_um = farthest ? off_um(farthest) : 0;
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
    points: shown.map(({ name, position_mm }): ScenePoint => ({ key: `point-${name}`, at: place(position_mm), colour: '--series-1', size: arrows.length > 0 ? 4 : 6, ...(shown.length <= most_names || name === farthest?.name ? { label: name } : {}) })),
    ...(arrows.length > 0 ? { arrows, scale: { label, unit: 'µm', low: 0, high: most_um } } : {}),
  };
  return { model, enlarged, most_um, farthest: farthest?.name ?? '' };
}
