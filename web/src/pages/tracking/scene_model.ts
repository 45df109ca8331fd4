// SPDX-License-Identifier: Apache-2.0
// The set-up of a tracking interferometer in terms of the picture.
import type { TrackingDraft, TrackingPoints, TrackingRequest } from '../../api/types';
import { station_solids, type Place, type SceneModel, type ScenePath, type ScenePoint, type SceneSolid, type Token } from '../../components/scene/scene';
import { t } from './texts';
import { station_place } from './station_place';

const colours: Record<string, Token> = {
  x: '--series-1', y: '--series-3', z: '--series-4', xy: '--series-2', xz: '--series-5', yz: '--series-6', xyz: '--series-7',
};
const rest = ['--series-1', '--series-2', '--series-3', '--series-4', '--series-5', '--series-6'] as const;

/** Each of the seven lines always has the same one; diagonals of the travels have them in turn. */
export const line_colour = (id: string, k: number): Token => colours[id] ?? (rest[k % rest.length] as Token);

const place = (numbers: readonly number[]): Place => [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];
const sum = (a: readonly number[], b: readonly number[]): Place => [0, 1, 2].map((k) => (a[k] ?? 0) + (b[k] ?? 0)) as unknown as Place;

export interface Shown { ways: boolean; beams: boolean; chosen: string | null }

interface Subject { request: TrackingRequest; draft: TrackingDraft | null; points: TrackingPoints | null }

export function tracking_scene({ request, draft, points }: Subject, shown: Shown): SceneModel {
  const { setup } = request;
  const tool = setup.tool_offset_mm ?? [0, 0, 0];
  const box = { low: sum(setup.travel.lowest_mm, tool), high: sum(setup.travel.highest_mm, tool) };
  const at = station_place(setup);
  const station = at === null ? null : place(at);
  const size = Math.hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
  const instrument = station === null ? [] : station_solids('station', station, 0.03 * size, Math.min(box.low[2], station[2] - 0.06 * size), t('station'));
  return {
    box,
    solids: [...instrument, ...obstacles_of(setup)],
    paths: draft === null ? [] : [
      ...(shown.beams && station !== null ? draft.lines.map((line, k) => beam(station, line, k)) : []),
      ...(shown.ways ? [{ key: 'way', places: draft.way_mm.map(place), colour: '--ink-quiet', dash: [2, 3], quiet: true } as ScenePath] : []),
      ...draft.lines.map((line, k): ScenePath => ({
        key: line.id, label: line.id, places: ends_of(line.targets.map(place), station), colour: line_colour(line.id, k),
        width: 2.5, arrow: true, chosen: shown.chosen === line.id,
      })),
    ],
    points: points !== null ? points.points.map(({ reflector }, k): ScenePoint => ({ key: `point-${k}`, at: place(reflector), colour: '--accent', size: 8, label: String(k + 1) }))
      : (draft?.lines ?? []).flatMap((line, k) => line.targets.map((at, i): ScenePoint => (
        { key: `${line.id}.${i}`, at: place(at), colour: line_colour(line.id, k), size: shown.chosen === line.id ? 8 : 5, shape: 'ring' }))),
  };
}

type Line = TrackingDraft['lines'][number];

/** Only the ends, the nearer one first: the arrow leads away from the station, or where positions grow. */
function ends_of(targets: Place[], station: Place | null): Place[] {
  const [a, b] = [targets[0], targets[targets.length - 1]];
  if (!a || !b) return [];
  if (station === null) return [a, b];
  const far = (p: Place) => Math.hypot(p[0] - station[0], p[1] - station[1], p[2] - station[2]);
  return far(a) <= far(b) ? [a, b] : [b, a];
}

function beam(station: Place, line: Line, k: number): ScenePath {
  const near = ends_of(line.targets.map(place), station)[0] ?? station;
  return { key: `beam-${line.id}`, places: [station, near], colour: line_colour(line.id, k), dash: [1, 3], quiet: true };
}

function obstacles_of(setup: TrackingRequest['setup']): SceneSolid[] {
  return (setup.obstacles ?? []).flatMap(({ name, box, sphere, cylinder }, k): SceneSolid[] => {
    const named = { key: `obstacle-${k}`, label: name ?? '', colour: '--caution' as const };
    if (box) return [{ ...named, shape: { kind: 'box', low: place(box.lowest_mm), high: place(box.highest_mm) } }];
    if (sphere) return [{ ...named, shape: { kind: 'ball', centre: place(sphere.centre_mm), radius: sphere.radius_mm ?? 0 } }];
    if (cylinder) return [{ ...named, shape: { kind: 'cylinder', base: place(cylinder.base_mm), radius: cylinder.radius_mm ?? 0, height: cylinder.height_mm ?? 0 } }];
    return [];
  });
}
