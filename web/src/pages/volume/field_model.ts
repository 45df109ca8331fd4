// SPDX-License-Identifier: Apache-2.0
// The field of errors in terms of the picture: slices and arrows of what the server computed on a grid.
import type { VolumetricField } from '../../api/types';
import type { Extent, Place, SceneArrow, SceneModel, ScenePatch, SceneScale } from '../../components/scene/scene';

export type ToolField = VolumetricField['tools'][number];
export type Vector = readonly [number, number, number];

/** Of one tool: places of the axes, displacements in µm there. */
export interface Grid {
  nodes: number;
  low: Vector; high: Vector;
  offset: Vector;
  errors: readonly (Vector | null)[];  // X fastest
}

const vector = (numbers: readonly number[]): Vector => [numbers[0] ?? 0, numbers[1] ?? 0, numbers[2] ?? 0];
const size = ([x, y, z]: Vector): number => Math.hypot(x, y, z);

/** As found, or less the displacement and rotation that a placing of the workpiece takes away. */
export function grid_of({ nodes, observed_mm }: VolumetricField, tool: ToolField, without_rigid: boolean): Grid {
  const [low, high] = [vector(observed_mm.lowest), vector(observed_mm.highest)];
  const grid: Grid = { nodes, low, high, offset: vector(tool.offset_mm), errors: tool.error_um.map((error) => (error === null ? null : vector(error))) };
  const rigid = tool.without_rigid_motion;
  if (!without_rigid || rigid === null) return grid;
  const [by, turn] = [vector(rigid.translation_um), vector(rigid.rotation_urad)];
  return {
    ...grid,
    errors: grid.errors.map((error, k) => {
      if (error === null) return null;
      const q = place_of(grid, [k % nodes, Math.floor(k / nodes) % nodes, Math.floor(k / nodes / nodes)]);
      const r = [0, 1, 2].map((a) => ((q[a] as number) - ((low[a] as number) + (high[a] as number)) / 2) / 1000) as unknown as Vector;
      const moved: Vector = [turn[1] * r[2] - turn[2] * r[1], turn[2] * r[0] - turn[0] * r[2], turn[0] * r[1] - turn[1] * r[0]];
      return [0, 1, 2].map((a) => (error[a] as number) - (by[a] as number) - (moved[a] as number)) as unknown as Vector;
    }),
  };
}

type Index = readonly [number, number, number];

/** Where the axes stand at a node. */
export const place_of = ({ low, high, nodes }: Grid, at: Index): Vector =>
  [0, 1, 2].map((a) => (low[a] as number) + (((high[a] as number) - (low[a] as number)) * (at[a] as number)) / (nodes - 1)) as unknown as Vector;

const error_at = ({ errors, nodes }: Grid, [x, y, z]: Index): Vector | null => errors[x + nodes * (y + nodes * z)] ?? null;

/** The largest |δ| of all grids: one scale for what is compared. */
export const largest_of = (...grids: Grid[]): number =>
  grids.reduce((most, { errors }) => errors.reduce((m, error) => (error === null ? m : Math.max(m, size(error))), most), 0);

/** |δ| on one slice, least and most; null where nothing is told. */
export function slice_range(grid: Grid, axis: number, slice: number): [number, number] | null {
  const sizes = slice_nodes(grid, axis, slice).map((at) => error_at(grid, at)).filter((error) => error !== null).map(size);
  return sizes.length === 0 ? null : [Math.min(...sizes), Math.max(...sizes)];
}

function slice_nodes({ nodes }: Grid, axis: number, slice: number): Index[] {
  const list: Index[] = [];
  for (let j = 0; j < nodes; j += 1) for (let i = 0; i < nodes; i += 1) list.push(index_on(axis, slice, i, j));
  return list;
}

/** Nodes i and j on a slice: of the first and of the second of the other two axes. */
function index_on(axis: number, slice: number, i: number, j: number): Index {
  const at: [number, number, number] = [0, 0, 0];
  const [first, second] = axis === 0 ? [1, 2] : axis === 1 ? [0, 2] : [0, 1];
  at[axis] = slice;
  at[first as number] = i;
  at[second as number] = j;
  return at;
}

/** A round enlargement with which the largest arrow is about an eighth of the volume. */
export function usual_enlargement(grid: Grid, most_um: number): number {
  const room = Math.min(...[0, 1, 2].map((a) => (grid.high[a] as number) - (grid.low[a] as number))) / 4;
  const wanted = most_um > 0 ? room / (most_um / 1000) : 1000;
  const step = 10 ** Math.floor(Math.log10(wanted));
  return step * ([5, 2, 1].find((n) => n * step <= wanted) ?? 1);
}

export interface FieldLook { axis: number; slice: number; enlarged: number; all: boolean; scale: SceneScale }

export function field_scene(grid: Grid, { axis, slice, enlarged, all, scale }: FieldLook): SceneModel {
  const seen = (q: Vector): Place => [0, 1, 2].map((a) => (q[a] as number) + (grid.offset[a] as number)) as unknown as Place;
  const box: Extent = { low: seen(grid.low), high: seen(grid.high) };
  const patches: ScenePatch[] = [];
  for (let j = 0; j + 1 < grid.nodes; j += 1)
    for (let i = 0; i + 1 < grid.nodes; i += 1) {
      const around = ([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]] as const).map(([a, b]) => index_on(axis, slice, a, b));
      const errors = around.map((at) => error_at(grid, at));
      if (errors.some((error) => error === null)) continue;
      patches.push({ key: `p${i}-${j}`, corners: around.map((at) => seen(place_of(grid, at))), value: errors.reduce((sum, error) => sum + size(error as Vector) / 4, 0) });
    }
  const step = Math.max(1, Math.round((grid.nodes - 1) / 5));
  const every: Index[] = [];
  for (let z = 0; z < grid.nodes; z += step) for (let y = 0; y < grid.nodes; y += step) for (let x = 0; x < grid.nodes; x += step) every.push([x, y, z]);
  const arrows = (all ? every : slice_nodes(grid, axis, slice)).flatMap((at): SceneArrow[] => {
    const error = error_at(grid, at);
    if (error === null) return [];
    return [{ key: at.join('-'), at: seen(place_of(grid, at)), by: error.map((e) => (e * enlarged) / 1000) as unknown as Place, value: size(error) }];
  });
  return { box, patches, arrows, scale };
}
