// SPDX-License-Identifier: Apache-2.0
// What a scene shows, said in terms of the machine and free of how it is drawn. Lengths in mm, X right, Y back, Z up.
import type { Extent, Place } from './projection';

/** A token of styles/tokens.css, "--series-1". */
export type Token = `--${string}`;

interface Named { key: string; label?: string }

/** A body that hides what is behind it. */
export interface SceneSolid extends Named {
  shape: ({ kind: 'box' } & Extent) | { kind: 'cylinder'; base: Place; radius: number; height: number } | { kind: 'ball'; centre: Place; radius: number };
  colour: Token;
}

/** A way from place to place. */
export interface ScenePath extends Named {
  places: readonly Place[];
  colour: Token;
  width?: number;             // px, 1.5 when not given
  dash?: readonly number[];
  arrow?: boolean;            // at its end
  quiet?: boolean;            // thin and pale: beams, ways
  chosen?: boolean;           // drawn stronger than the others
}

export interface ScenePoint extends Named {
  at: Place;
  colour: Token;
  size?: number;              // px, 5 when not given
  shape?: 'dot' | 'ring' | 'cross';
}

/** An arrow whose length is a quantity, enlarged by scale.arrow_mm, and whose colour is its size on the scale. */
export interface SceneArrow { key: string; at: Place; by: Place; value: number }

/** A flat piece, coloured by the scale: of a slice through a field. It hides nothing. */
export interface ScenePatch { key: string; corners: readonly Place[]; value: number }

/** What colours of arrows and patches mean. */
export interface SceneScale { label: string; unit: string; low: number; high: number; decimals?: number }

export interface SceneModel {
  box: Extent | null;         // the working volume, with the axes at its edges
  solids?: readonly SceneSolid[];
  paths?: readonly ScenePath[];
  points?: readonly ScenePoint[];
  arrows?: readonly SceneArrow[];
  patches?: readonly ScenePatch[];
  scale?: SceneScale | null;
}

/** All places that must be in the picture. */
export function places_of(model: SceneModel): Place[] {
  const places: Place[] = model.box ? [model.box.low, model.box.high] : [];
  for (const { shape } of model.solids ?? []) {
    if (shape.kind === 'box') places.push(shape.low, shape.high);
    const r = shape.kind === 'box' ? 0 : shape.radius;
    if (shape.kind === 'ball') places.push(...corners_about(shape.centre, r, r));
    if (shape.kind === 'cylinder') places.push(...corners_about(shape.base, r, 0), ...corners_about([shape.base[0], shape.base[1], shape.base[2] + shape.height], r, 0));
  }
  for (const path of model.paths ?? []) places.push(...path.places);
  for (const point of model.points ?? []) places.push(point.at);
  for (const arrow of model.arrows ?? []) places.push(arrow.at);
  for (const patch of model.patches ?? []) places.push(...patch.corners);
  return places;
}

const corners_about = ([x, y, z]: Place, r: number, h: number): Place[] => [[x - r, y - r, z - h], [x + r, y + r, z + h]];

/** A station: a pedestal from its foot up to the instrument, whose ball is about the place where the lines meet. */
export function station_solids(key: string, at: Place, radius: number, foot: number, label: string): SceneSolid[] {
  const height = Math.max(at[2] - radius * 0.6 - foot, 0);
  const ball: SceneSolid = { key, shape: { kind: 'ball', centre: at, radius }, colour: '--accent', label };
  return height <= 0 ? [ball]
    : [{ key: `${key}-foot`, shape: { kind: 'cylinder', base: [at[0], at[1], foot], radius: radius * 0.72, height }, colour: '--line-strong' }, ball];
}
