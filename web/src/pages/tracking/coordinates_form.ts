// SPDX-License-Identifier: Apache-2.0
// Files of readings from several stations, what they are by their heads, and what their fields ask for.
import type { MultilaterationOptions, PolarChoices } from '../../api/types';
import { parsed } from '../../numbers';
import { t as t_page } from './texts';

export interface CoordinatesFile { file: File; kind: 'angles' | 'ranges' | 'nominal'; stations: readonly string[] }

const most_stations = 12;   // that have a field of their own

/** What a table is by its head: without a station nominal points, with an angle readings of a tracker. */
export async function file_of(file: File): Promise<CoordinatesFile> {
  const lines = (await file.slice(0, 1_000_000).text()).split(/\r?\n/).filter((line) => line.trim() !== '' && !line.startsWith('#'));
  const head = lines[0] ?? '';
  const mark = ['\t', ';', ','].find((one) => head.includes(one)) ?? ',';
  const cells = head.split(mark).map((cell) => cell.replace(/["\uFEFF]/g, '').trim().toLowerCase());
  const station = cells.findIndex((cell) => cell.startsWith('station'));
  if (station < 0) return { file, kind: 'nominal', stations: [] };
  const kind = cells.some((cell) => /^(az|azimuth|horizontal angle|hz|elevation|el|zenith|vertical angle)\b|^(azimuth|elevation|zenith)/.test(cell)) ? 'angles' : 'ranges';
  const named = new Set(lines.slice(1).map((line) => (line.split(mark)[station] ?? '').replace(/"/g, '').trim()).filter((name) => name !== ''));
  return { file, kind, stations: [...named].slice(0, most_stations) };
}

export interface CoordinatesForm {
  scale: 'fixed' | 'common' | 'free';
  prior: string;
  ranging: string; repeatability: string; find_breaks: boolean;
  instrument: string; of_station: Readonly<Record<string, string>>;
  polar_ranging: string; angles: string; in_station: boolean;
}

export const new_coordinates = (): CoordinatesForm => ({
  scale: 'fixed', prior: '', ranging: '', repeatability: '', find_breaks: true, instrument: '', of_station: {}, polar_ranging: '', angles: '', in_station: false,
});

export type CoordinatesFaults = Partial<Record<'prior', string>>;

const given = (name: string, text: string) => (text.trim() === '' ? {} : { [name]: text.trim() });

export function multilateration_options(form: CoordinatesForm): { options: MultilaterationOptions | null; faults: CoordinatesFaults } {
  const prior = parsed(form.prior);
  const wants_prior = form.scale !== 'fixed' && form.prior.trim() !== '';
  const faults: CoordinatesFaults = wants_prior && prior === null ? { prior: t_page('not_number', { text: form.prior.trim() }) } : {};
  const options = {
    scale: form.scale, ...(wants_prior && prior !== null ? { scale_prior_ppm: prior } : {}), ...given('ranging', form.ranging),
    ...given('repeatability', form.repeatability), find_breaks: form.find_breaks, covariances: true,
  };
  return { options: Object.keys(faults).length === 0 ? options : null, faults };
}

export function polar_options(form: CoordinatesForm, stations: readonly string[], has_nominal: boolean): PolarChoices {
  const instruments = [
    ...(form.instrument === '' ? [] : [form.instrument]),
    ...stations.flatMap((station) => (form.of_station[station] ? [`${station}=${form.of_station[station]}`] : [])),
  ];
  return { instruments, ...given('ranging', form.polar_ranging), ...given('angles', form.angles), in_station: has_nominal && form.in_station };
}
