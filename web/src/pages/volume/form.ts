// SPDX-License-Identifier: Apache-2.0
// What is typed on the page of the volumetric calibration, and what it makes: machine.json and the request for a plan.
import type { VolumetricMachine, VolumetricPlanFile, VolumetricPlanRequest } from '../../api/types';
import { typed } from '../../numbers';
import { boxes_of, Reader, reflectors, type Faults, type ObstacleForm } from '../tracking/form';
import { chain_of_text, is_chain, usual_chains } from './chain';
import { t } from './texts';

export interface PlaceForm { name: string; at: string[] }

export const limit_keys = ['incidence', 'range_least', 'range_most', 'elevation_lowest', 'elevation_highest', 'safe_radius'] as const;
export const text_keys = ['a', 'b', 'repeatability', 'scale', 'count', 'points', 'feed', 'dwell', ...limit_keys] as const;
export type TextKey = (typeof text_keys)[number];

export interface VolumeForm {
  machine: string;
  chain: string;
  other: boolean;                  // whether its links are chosen one by one
  low: string[]; high: string[];   // travels of X, Y, Z
  tools: PlaceForm[];
  propose: boolean;
  stations: PlaceForm[];           // where they are given
  texts: Record<TextKey, string>;
  room_low: string[]; room_high: string[];
  reflector: string;
  obstacles: ObstacleForm[];
  functional: VolumetricMachine['functional_point_mm'] | null;  // of a file; not shown, but kept
}

const empty_texts = Object.fromEntries(text_keys.map((key) => [key, ''])) as Record<TextKey, string>;

export function new_form(): VolumeForm {
  return {
    machine: '', chain: 'XFYZ', other: false, low: ['0', '0', '-500'], high: ['800', '500', '0'],
    tools: [{ name: 'T1', at: ['0', '0', '-120'] }, { name: 'T2', at: ['60', '0', '-120'] }, { name: 'T3', at: ['0', '60', '-240'] }],
    propose: true, stations: [], texts: { ...empty_texts, a: typed(0.2), b: typed(0.3), repeatability: typed(0.5), count: '4', points: '100', incidence: '80' },
    room_low: ['', '', ''], room_high: ['', '', ''], reflector: '−Z', obstacles: [], functional: null,
  };
}

type Places = Record<string, number[]>;
type Box = NonNullable<VolumetricPlanRequest['room_mm']>;

function places_of(kind: string, places: readonly PlaceForm[], read: Reader): Places {
  const named: Places = {};
  places.forEach(({ name, at }, k) => {
    const key = name.trim() || `${kind === 'tool' ? 'T' : 'S'}${k + 1}`;
    if (key in named) read.faults[`${kind}.${k}.name`] = `${key}: 2`;
    named[key] = read.triple(`${kind}.${k}`, at);
  });
  return named;
}

const box_of = (low: number[], high: number[]): Box =>
  Object.fromEntries(['X', 'Y', 'Z'].map((axis, k) => [axis, [low[k] ?? 0, high[k] ?? 0]])) as unknown as Box;

export interface Read { machine: VolumetricMachine | null; request: VolumetricPlanRequest | null; faults: Faults }

/** The machine and the request, or what keeps the form from being them. */
export function read_form(form: VolumeForm): Read {
  const read = new Reader();
  if (!is_chain(form.chain)) read.faults.chain = t('chain_fault');
  const scale = read.maybe('scale', form.texts.scale);
  const machine: VolumetricMachine = {
    ...(form.machine.trim() === '' ? {} : { name: form.machine.trim() }),
    chain: form.chain,
    travel_mm: box_of(read.triple('low', form.low), read.triple('high', form.high)),
    tools_mm: places_of('tool', form.tools, read),
    ...(form.propose ? {} : { stations_mm: places_of('station', form.stations, read) }),
    instrument: { a_um: read.number('a', form.texts.a), b_um_per_m: read.number('b', form.texts.b), ...(scale === null ? {} : { scale_u_um_per_m: scale }) },
    repeatability_um: read.number('repeatability', form.texts.repeatability),
    ...(form.functional ? { functional_point_mm: form.functional } : {}),
  };
  const of_machine = Object.keys(read.faults).length === 0;
  const number = (key: TextKey) => read.maybe(key, form.texts[key]);
  const given = <T extends Record<string, unknown>>(members: T) => Object.fromEntries(Object.entries(members).filter(([, value]) => value !== null)) as Partial<T>;
  const axis = reflectors.find(([name]) => name === form.reflector)?.[1] ?? null;
  const room = [...form.room_low, ...form.room_high].every((text) => text.trim() === '') ? null
    : box_of(read.triple('room_low', form.room_low), read.triple('room_high', form.room_high));
  const request = {
    machine, propose_stations: form.propose,
    ...given({ stations: form.propose ? number('count') : null, points: number('points'), feed_mm_per_min: number('feed'), dwell_s: number('dwell'), room_mm: form.propose ? room : null }),
    limits: given({
      incidence_most_deg: number('incidence'), range_least_mm: number('range_least'), range_most_mm: number('range_most'),
      elevation_lowest_deg: number('elevation_lowest'), elevation_highest_deg: number('elevation_highest'), safe_radius_mm: number('safe_radius'),
      reflector_axis: axis && [...axis],
    }),
    obstacles: boxes_of(form.obstacles, read),
  } as VolumetricPlanRequest;
  return { machine: of_machine ? machine : null, request: Object.keys(read.faults).length === 0 ? request : null, faults: read.faults };
}

const triple = (numbers: readonly number[] | undefined): string[] => [0, 1, 2].map((k) => typed(numbers?.[k]));
const list = (places: Record<string, number[]> | undefined): PlaceForm[] => Object.entries(places ?? {}).map(([name, at]) => ({ name, at: triple(at) }));
const is_object = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null && !Array.isArray(value);

/** A machine.json or a plan into the form. Throws an Error with a reason in words where it is neither. */
export function form_of_file(text: string, before: VolumeForm): VolumeForm {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new Error(t('no_json'));
  }
  const plan = is_object(value) && typeof value.format === 'string' && is_object(value.machine) ? (value as unknown as VolumetricPlanFile) : null;
  const machine = (plan?.machine ?? value) as VolumetricMachine;
  for (const name of ['chain', 'travel_mm', 'tools_mm'] as const)
    if (!is_object(machine) || !(name === 'chain' ? name in machine : is_object(machine[name]))) throw new Error(t('no_member', { name }));
  const chain = chain_of_text(String(machine.chain));
  const travel = machine.travel_mm as unknown as Record<string, number[] | undefined>;
  const end = (k: number) => ['X', 'Y', 'Z'].map((axis) => typed(travel[axis]?.[k]));
  const stations = list(machine.stations_mm as Places | undefined);
  const instrument = machine.instrument as { a_um?: number; b_um_per_m?: number; scale_u_um_per_m?: number } | undefined;
  const number = (x: number | null | undefined, otherwise: string) => (x === null || x === undefined ? otherwise : typed(x));
  const points = Math.max(0, ...(plan?.runs ?? []).map(({ stops }) => stops.length));
  return {
    ...before, machine: String(machine.name ?? ''), chain, other: !(usual_chains as readonly string[]).includes(chain), low: end(0), high: end(1),
    functional: machine.functional_point_mm ?? null,
    tools: list(machine.tools_mm as Places), propose: stations.length === 0, stations,
    texts: {
      ...before.texts, a: number(instrument?.a_um, typed(0.2)), b: number(instrument?.b_um_per_m, typed(0.3)), scale: number(instrument?.scale_u_um_per_m, ''),
      repeatability: number(machine.repeatability_um, '0'), points: points > 0 ? String(points) : before.texts.points,
    },
  };
}
