// SPDX-License-Identifier: Apache-2.0
// What is typed on the page of the tracking interferometer, and the request that it makes. It stays a text until then.
import type { TrackingRequest, TrackingStation } from '../../api/types';
import { parsed } from '../../numbers';
import { drawn_seed } from '../plan/form';
import { t } from './texts';

export const axes = ['X', 'Y', 'Z'] as const;
export type Triple = readonly [number, number, number];

/** Where the instrument was found, as the rest of the page takes it. */
export interface LocatedStation {
  file: string; position: Triple; covariance: number[][];
  for_bounds?: number[][];  // as wide as a normal station must have it; absent in what an older page kept
}

export interface ObstacleForm { name: string; low: string[]; high: string[] }

export interface TrackingForm {
  machine: string;
  low: string[]; high: string[];   // travels of X, Y, Z
  tool: string[];
  station: string[];
  which: 'seven' | 'body' | 'face' | 'both';
  rule: 'equal' | 'corner';
  texts: Record<TextKey, string>;
  reflector: string;               // '' is as it sees most
  obstacles: ObstacleForm[];
  seed: string;
}

export const text_keys = [
  'targets', 'runs', 'feed', 'dwell', 'overrun', 'period', 'range_least', 'range_most', 'elevation_lowest', 'elevation_highest',
  'incidence', 'safe_radius', 'line_least', 'constant', 'per_length',
] as const;
export type TextKey = (typeof text_keys)[number];
/** By field: "low.0" is the lower end of X. */
export type Faults = Record<string, string>;

/** ISO 230-6: the interferometer is aligned with each diagonal of the travels in turn, and nobody asks where it stands. */
export const is_aligned = (form: TrackingForm): boolean => form.which !== 'seven';

export function new_form(): TrackingForm {
  return {
    machine: '', low: ['0', '0', '-500'], high: ['800', '600', '0'], tool: ['0', '0', '-120'], station: ['100', '80', '-600'],
    which: 'seven', rule: 'equal', texts: Object.fromEntries(text_keys.map((key) => [key, ''])) as Record<TextKey, string>,
    reflector: '', obstacles: [], seed: drawn_seed(),
  };
}

export const reflectors: readonly (readonly [string, Triple])[] = [
  ['−Z', [0, 0, -1]], ['+Z', [0, 0, 1]], ['−X', [-1, 0, 0]], ['+X', [1, 0, 0]], ['−Y', [0, -1, 0]], ['+Y', [0, 1, 0]],
];

type Setup = TrackingRequest['setup'];

/** Reads numbers out of a form, and keeps in mind which of them are none. */
export class Reader {
  readonly faults: Faults = {};

  number(key: string, text: string): number {
    const value = parsed(text);
    if (value === null) this.faults[key] = text.trim() === '' ? t('wanted') : t('not_number', { text: text.trim() });
    return value ?? 0;
  }
  maybe(key: string, text: string): number | null {
    return text.trim() === '' ? null : this.number(key, text);
  }
  triple(key: string, texts: readonly string[]): number[] {
    return axes.map((_, k) => this.number(`${key}.${k}`, texts[k] ?? ''));
  }
}

function setup_of(form: TrackingForm, located: LocatedStation | null, read: Reader): Setup {
  const limit = (key: TextKey) => read.maybe(key, form.texts[key]);
  const given = <T extends Record<string, number | number[] | null>>(members: T) =>
    Object.fromEntries(Object.entries(members).filter(([, value]) => value !== null));
  const axis = reflectors.find(([name]) => name === form.reflector)?.[1] ?? null;
  const ranging = given({ constant_um: limit('constant'), per_length_um_per_m: limit('per_length') });
  const machine = { travel: { lowest_mm: read.triple('low', form.low), highest_mm: read.triple('high', form.high) }, tool_offset_mm: read.triple('tool', form.tool) };
  if (is_aligned(form)) return { ...machine, ranging, obstacles: boxes_of(form.obstacles, read) } as Setup;
  return {
    ...machine,
    station: located ? { position_mm: [...located.position], ...(located.for_bounds ? { covariance_mm2: located.for_bounds } : {}) } : { position_mm: read.triple('station', form.station) },
    limits: given({
      range_least_mm: limit('range_least'), range_most_mm: limit('range_most'), elevation_lowest_deg: limit('elevation_lowest'),
      elevation_highest_deg: limit('elevation_highest'), incidence_most_deg: limit('incidence'), safe_radius_mm: limit('safe_radius'),
      line_least_mm: limit('line_least'), reflector_axis: axis && [...axis],
    }),
    ranging,
    obstacles: boxes_of(form.obstacles, read),
  } as Setup;
}

/** Whichever corner was typed first. */
export function boxes_of(obstacles: readonly ObstacleForm[], read: Reader) {
  return obstacles.map(({ name, low, high }, k) => {
    const [a, b] = [read.triple(`obstacle.${k}.low`, low), read.triple(`obstacle.${k}.high`, high)];
    const ends = (pick: (x: number, y: number) => number) => a.map((x, i) => pick(x, b[i] ?? 0));
    return { name: name.trim(), box: { lowest_mm: ends(Math.min), highest_mm: ends(Math.max) } };
  });
}

/** The request, or what keeps the form from being one. */
export function request_of(form: TrackingForm, located: LocatedStation | null): { request: TrackingRequest | null; faults: Faults } {
  const read = new Reader();
  const number = (key: TextKey) => read.maybe(key, form.texts[key]);
  const period = number('period');
  const request: TrackingRequest = {
    setup: setup_of(form, located, read),
    ...(is_aligned(form) ? { lines: form.which === 'both' ? ['body', 'face'] : [form.which] } : { turn_reflector: form.reflector === '', rule: form.rule }),
    targets: number('targets'), runs: number('runs'), feed: number('feed'), dwell_s: number('dwell'),
    overrun_mm: number('overrun'), periods_mm: period === null ? null : [period, period, period],
    seed: read.number('seed', form.seed), machine: form.machine.trim(),
  };
  return { request: Object.keys(read.faults).length === 0 ? request : null, faults: read.faults };
}

export const located_station = (found: TrackingStation): LocatedStation =>
  ({
    file: found.source.file, position: found.refined.station as unknown as Triple, covariance: found.refined.covariance as unknown as number[][],
    for_bounds: found.refined.covariance_for_bounds as unknown as number[][],
  });

/** The covariance that plans and lines take; none where an older page kept only one that is too small for bounds. */
export const bounds_of = ({ for_bounds }: LocatedStation): number[][] | null => for_bounds ?? null;

/** Standard uncertainties of X, Y, Z in µm. */
export const station_u = ({ covariance }: LocatedStation): number[] => axes.map((_, k) => 1000 * Math.sqrt(Math.max(0, covariance[k]?.[k] ?? 0)));
