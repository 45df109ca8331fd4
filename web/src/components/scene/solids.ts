// SPDX-License-Identifier: Apache-2.0
// Convex bodies that hide what is behind them: boxes, upright cylinders, balls. Pure.
import { dot, minus, plus, times, type Extent, type Place } from './projection';

/** Inside where dot(normal, p) <= distance. */
export interface Plane { normal: Place; distance: number }

/** A body by its planes, and the corners of the face on each of them, counter-clockwise from outside. */
export interface Solid { planes: Plane[]; faces: Place[][] }

export function box_solid({ low, high }: Extent): Solid {
  const at = (x: 0 | 1, y: 0 | 1, z: 0 | 1): Place => [(x ? high : low)[0], (y ? high : low)[1], (z ? high : low)[2]];
  return {
    planes: [
      { normal: [-1, 0, 0], distance: -low[0] }, { normal: [1, 0, 0], distance: high[0] },
      { normal: [0, -1, 0], distance: -low[1] }, { normal: [0, 1, 0], distance: high[1] },
      { normal: [0, 0, -1], distance: -low[2] }, { normal: [0, 0, 1], distance: high[2] },
    ],
    faces: [
      [at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)], [at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)],
      [at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)], [at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)],
      [at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)], [at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)],
    ],
  };
}

const round = 24;  // sides of what is round

export function cylinder_solid(base: Place, radius: number, height: number): Solid {
  const angle = (k: number) => (2 * Math.PI * k) / round;
  const rim = (k: number, z: number): Place => [base[0] + radius * Math.cos(angle(k)), base[1] + radius * Math.sin(angle(k)), z];
  const ring = Array.from({ length: round }, (_, k) => k);
  const top = base[2] + height;
  const sides = ring.map((k): [Plane, Place[]] => {
    const normal: Place = [Math.cos(angle(k + 0.5)), Math.sin(angle(k + 0.5)), 0];
    return [{ normal, distance: dot(normal, rim(k, top)) }, [rim(k, base[2]), rim(k + 1, base[2]), rim(k + 1, top), rim(k, top)]];
  });
  return {
    planes: [...sides.map(([plane]) => plane), { normal: [0, 0, 1], distance: top }, { normal: [0, 0, -1], distance: -base[2] }],
    faces: [...sides.map(([, face]) => face), ring.map((k) => rim(k, top)), ring.map((k) => rim(-k, base[2]))],
  };
}

/** A globe with faces between meridians and parallels. */
export function ball_solid(centre: Place, radius: number): Solid {
  const bands = round / 2;
  const on = (k: number, j: number): Place => {
    const [a, e] = [(2 * Math.PI * k) / round, Math.PI * (j / bands - 0.5)];
    return plus(centre, times(radius, [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)]));
  };
  const solid: Solid = { planes: [], faces: [] };
  for (let j = 0; j < bands; j += 1)
    for (let k = 0; k < round; k += 1) {
      const normal = times(1 / radius, minus(on(k + 0.5, j + 0.5), centre));
      const face = [on(k, j), on(k + 1, j), on(k + 1, j + 1), on(k, j + 1)];
      solid.planes.push({ normal, distance: Math.max(...face.map((corner) => dot(normal, corner))) });
      solid.faces.push(face);
    }
  return solid;
}

/** Parts 0 … 1 of a way. */
export type Piece = readonly [from: number, to: number];

/**
 * The piece of the way from a to b that the body hides from a viewer in the direction `out`, or holds inside; null where
 * all of it is seen. A point is hidden where the ray from it to the viewer meets the body: the points (t, s) of the plane
 * of the way and that direction that lie in the body are a convex polygon, cut out of a rectangle plane by plane, and
 * the piece is what it covers of t.
 */
export function hidden_piece(solid: Solid, a: Place, b: Place, out: Place): Piece | null {
  const way = minus(b, a);
  const far = farthest(solid, a, out) + Math.hypot(...way) + 1;
  let polygon: [t: number, s: number][] = [[0, 0], [1, 0], [1, far], [0, far]];
  for (const { normal, distance } of solid.planes) {
    const [at_t, at_s, at_0] = [dot(normal, way), dot(normal, out), dot(normal, a) - distance];
    polygon = cut(polygon, ([t, s]) => at_0 + t * at_t + s * at_s);
    if (polygon.length === 0) return null;
  }
  const ts = polygon.map(([t]) => t);
  const piece: Piece = [Math.min(...ts), Math.max(...ts)];
  return piece[1] - piece[0] > 1e-9 ? piece : null;
}

/** How far from a, towards the viewer, the body may reach. */
function farthest(solid: Solid, a: Place, out: Place): number {
  let most = 0;
  for (const face of solid.faces) for (const corner of face) most = Math.max(most, Math.abs(dot(minus(corner, a), out)));
  return most;
}

/** What is left of a convex polygon where f is below 0: on the face of a body one is seen. */
function cut(polygon: [number, number][], f: (at: [number, number]) => number): [number, number][] {
  const kept: [number, number][] = [];
  polygon.forEach((here, k) => {
    const next = polygon[(k + 1) % polygon.length] as [number, number];
    const [f_here, f_next] = [f(here), f(next)];
    if (f_here < 0) kept.push(here);
    if (f_here < 0 !== f_next < 0) {
      const t = f_here / (f_here - f_next);
      kept.push([here[0] + t * (next[0] - here[0]), here[1] + t * (next[1] - here[1])]);
    }
  });
  return kept;
}

/** What is left of 0 … 1 without those pieces, in order. */
export function rest_of(pieces: readonly Piece[]): Piece[] {
  const left: Piece[] = [];
  let at = 0;
  for (const [from, to] of [...pieces].sort((a, b) => a[0] - b[0])) {
    if (from > at + 1e-9) left.push([at, from]);
    at = Math.max(at, to);
  }
  if (at < 1 - 1e-9) left.push([at, 1]);
  return left;
}
