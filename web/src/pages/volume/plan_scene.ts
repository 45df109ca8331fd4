// SPDX-License-Identifier: Apache-2.0
// A planned calibration in terms of the picture: reach of the reflector, stations, the points of one run.
import type { VolumetricDraft } from '../../api/types';
import { station_solids, type Place, type SceneModel, type ScenePoint, type SceneSolid } from '../../components/scene/scene';

type PlanFile = VolumetricDraft['plan'];
const place = (numbers: readonly number[]): Place => [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];
const sum = (a: readonly number[], b: readonly number[]): Place => [0, 1, 2].map((k) => (a[k] ?? 0) + (b[k] ?? 0)) as unknown as Place;

/** Where the reflector of a tool comes. */
export function reach_of({ machine }: PlanFile, tool: string): { low: Place; high: Place } {
  const offset = (machine.tools_mm as Record<string, number[]>)[tool] ?? [0, 0, 0];
  const { X, Y, Z } = machine.travel_mm;
  return { low: sum([X[0] ?? 0, Y[0] ?? 0, Z[0] ?? 0], offset), high: sum([X[1] ?? 0, Y[1] ?? 0, Z[1] ?? 0], offset) };
}

export function plan_scene(plan: PlanFile, shown_run: number, way: boolean): SceneModel {
  const run = plan.runs[shown_run];
  const tool = run?.tool ?? Object.keys(plan.machine.tools_mm)[0] ?? '';
  const offset = (plan.machine.tools_mm as Record<string, number[]>)[tool] ?? [0, 0, 0];
  const box = reach_of(plan, tool);
  const stations = Object.entries(plan.machine.stations_mm as Record<string, number[]>);
  const size = Math.hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
  const foot = Math.min(box.low[2], ...stations.map(([, at]) => (at[2] ?? 0) - 0.05 * size));
  const stops = run?.stops ?? [];
  return {
    box,
    solids: [
      ...stations.flatMap(([name, at]) => station_solids(`station-${name}`, place(at), (name === run?.station ? 0.034 : 0.024) * size, foot, name)),
      ...(plan.obstacles ?? []).flatMap(({ name, box: solid }, k): SceneSolid[] =>
        (solid ? [{ key: `obstacle-${k}`, label: name ?? '', colour: '--caution', shape: { kind: 'box', low: place(solid.lowest_mm), high: place(solid.highest_mm) } }] : [])),
    ],
    paths: way && stops.length > 1
      ? [{ key: 'way', colour: '--ink-quiet', dash: [2, 3], quiet: true, places: stops.flatMap(({ at_mm, over_mm }) => [...(over_mm ?? []), at_mm].map((at) => sum(at, offset))) }] : [],
    points: stops.map(({ at_mm }, k): ScenePoint => ({ key: `point.${k}`, at: sum(at_mm, offset), colour: '--series-1', size: 4 })),
  };
}
