// SPDX-License-Identifier: Apache-2.0
// The set-up of a capture of lengths in terms of the picture: what has been caught, and where the reflector is to go.
import type { CapturedPlan, TrackingPlanFile, TrackingRequest, VolumetricPlanFile } from '../../api/types';
import type { Place, SceneModel, ScenePath, ScenePoint } from '../../components/scene/scene';
import { tracking_scene } from '../tracking/scene_model';
import { plan_scene } from '../volume/plan_scene';
import type { Caught } from './live';
import { station_place } from '../tracking/station_place';

export type Stop = CapturedPlan['stops'][number];
const place = (numbers: readonly number[]): Place => [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];

const volume_of = ({ plan }: CapturedPlan) => plan as VolumetricPlanFile;
const lines_of = ({ plan }: CapturedPlan) => plan as TrackingPlanFile;

/** The first stop of the line, or of the part, that a stop belongs to. */
function beginning_of(captured: CapturedPlan, stop: number): Place {
  let first = stop - 1;
  while (first > 0 && !captured.stops[first]?.begins_segment) first -= 1;
  return place(captured.stops[first]?.reflector_mm ?? []);
}

/**
 * From where lengths to a stop are measured, in the coordinates of the reflector: the instrument, or where the line begins
 * with which an interferometer without a station is aligned.
 */
export function origin_of(captured: CapturedPlan, stop: number): Place {
  if (captured.kind === 'lines') {
    const at = station_place(lines_of(captured).setup);
    return at === null ? beginning_of(captured, stop) : place(at);
  }
  const { machine, runs } = volume_of(captured);
  return place((machine.stations_mm as Record<string, number[]>)[runs[captured.part - 1]?.station ?? ''] ?? []);
}

export const distance = (a: Place, b: Place): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/** What the instrument will show at a stop, after the length that was caught last. Null before the first. */
export function expected_length(captured: CapturedPlan, caught: Caught, due: number | null): number | null {
  const last = caught[caught.length - 1];
  const [from, to] = [last && captured.stops[last.stop - 1], due === null ? undefined : captured.stops[due - 1]];
  if (!last || !from || !to || due === null || to.begins_segment) return null;
  const station = origin_of(captured, due);
  return last.length_mm + distance(place(to.reflector_mm), station) - distance(place(from.reflector_mm), station);
}

function surroundings(captured: CapturedPlan): SceneModel {
  if (captured.kind === 'volume') return plan_scene(volume_of(captured), captured.part - 1, false);
  const request = { setup: lines_of(captured).setup } as TrackingRequest;
  return tracking_scene({ request, draft: null, points: null }, { ways: false, beams: false, chosen: null });
}

export function length_scene(captured: CapturedPlan, caught: Caught, due: number | null): SceneModel {
  const has = new Set(caught.map(({ stop }) => stop));
  // Stops of a line come several times at one place, which is shown once.
  const places = new Map<string, { at: Place; caught: boolean }>();
  captured.stops.forEach(({ reflector_mm }, k) => {
    const at = place(reflector_mm);
    const key = at.join();
    places.set(key, { at, caught: (places.get(key)?.caught ?? false) || has.has(k + 1) });
  });
  const next = due === null ? undefined : captured.stops[due - 1];
  const at = next && place(next.reflector_mm);
  const before = caught[caught.length - 1];
  const from = before && captured.stops[before.stop - 1];
  const paths: ScenePath[] = !next || !at || due === null ? [] : [
    { key: 'beam', places: [origin_of(captured, due), at], colour: '--accent', width: 1.5 },
    ...(from ? [{ key: 'way', places: [place(from.reflector_mm), at], colour: '--ink-quiet', dash: [2, 3], quiet: true } as ScenePath] : []),
  ];
  const points = [...places].map(([key, one]): ScenePoint => (
    { key, at: one.at, colour: one.caught ? '--good' : '--ink-quiet', size: one.caught ? 6 : 5, shape: one.caught ? 'dot' : 'ring' }));
  if (next && at) points.push({ key: 'due', at, colour: '--accent', size: 13, label: next.name });
  return { ...surroundings(captured), paths, points };
}
