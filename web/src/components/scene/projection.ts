// SPDX-License-Identifier: Apache-2.0
// How a place in a machine comes onto the screen: a parallel projection, as in a drawing, so that equal lengths stay equal.
// Pure: no page, no state.

/** X to the right of the machine, Y to its back, Z up. */
export type Place = readonly [x: number, y: number, z: number];
export type Flat = readonly [x: number, y: number];

/** From where one looks. Degrees; azimuth 0 stands before the machine, 90 at its right; elevation 90 looks down. */
export interface View { azimuth: number; elevation: number; zoom: number }

export const first_view: View = { azimuth: 30, elevation: 24, zoom: 1 };

export const plus = (a: Place, b: Place): Place => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Place, b: Place): Place => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (k: number, a: Place): Place => [k * a[0], k * a[1], k * a[2]];
export const dot = (a: Place, b: Place): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const between = (a: Place, b: Place, t: number): Place => plus(a, times(t, minus(b, a)));

/** Unit vectors of the screen: to its right, up, and out of it towards the viewer. */
export interface Screen { right: Place; up: Place; out: Place }

export function screen_of({ azimuth, elevation }: View): Screen {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const [sin_a, cos_a, sin_e, cos_e] = [Math.sin(a), Math.cos(a), Math.sin(e), Math.cos(e)];
  return {
    right: [cos_a, sin_a, 0],
    up: [-sin_e * sin_a, sin_e * cos_a, cos_e],
    out: [cos_e * sin_a, -cos_e * cos_a, sin_e],
  };
}

export interface Extent { low: Place; high: Place }

/** The smallest box with edges along the axes that holds all; a cube of one where there is nothing. */
export function extent_of(places: readonly Place[]): Extent {
  if (places.length === 0) return { low: [0, 0, 0], high: [1, 1, 1] };
  const ends = (pick: (...numbers: number[]) => number): Place =>
    [0, 1, 2].map((k) => places.reduce((end, place) => pick(end, place[k] as number), places[0]?.[k] as number)) as unknown as Place;
  return { low: ends(Math.min), high: ends(Math.max) };
}

export interface Projection extends Screen {
  scale: number;                    // px per unit of length
  flat: (place: Place) => Flat;     // px, y downwards
  depth: (place: Place) => number;  // the larger the nearer
}

/**
 * The middle of the extent in the middle of the picture, and all of it within the picture however it is turned about Z:
 * nothing grows or shrinks meanwhile. `room`: px that stay free at the edges, for words.
 */
export function projection_of(view: View, extent: Extent, size: Flat, room = 0): Projection {
  const screen = screen_of(view);
  const middle = between(extent.low, extent.high, 0.5);
  const half = minus(extent.high, middle);
  const across = Math.max(Math.hypot(half[0], half[1]), 1e-9);  // Z never widens a picture in which it is up
  const wide = Math.max(size[0] / 2 - room, 20) / across;
  const tilt = (view.elevation * Math.PI) / 180;
  const high = Math.max(size[1] / 2 - room, 20) / (half[2] * Math.cos(tilt) + across * Math.abs(Math.sin(tilt)));
  const scale = Math.min(wide, high) * view.zoom;
  return {
    ...screen, scale,
    flat: (place) => {
      const from = minus(place, middle);
      return [size[0] / 2 + scale * dot(from, screen.right), size[1] / 2 - scale * dot(from, screen.up)];
    },
    depth: (place) => dot(minus(place, middle), screen.out),
  };
}

const upright = (elevation: number): number => Math.min(90, Math.max(-90, elevation));
const around = (azimuth: number): number => ((((azimuth + 180) % 360) + 360) % 360) - 180;

export function turned(view: View, by: { azimuth?: number; elevation?: number }): View {
  return { ...view, azimuth: around(view.azimuth + (by.azimuth ?? 0)), elevation: upright(view.elevation + (by.elevation ?? 0)) };
}

export const zoomed = (view: View, factor: number): View => ({ ...view, zoom: Math.min(8, Math.max(0.5, view.zoom * factor)) });

/** What a key does with the view; null: nothing. With Shift in large steps. */
export function view_by_key(view: View, key: string, shift = false): View | null {
  const step = shift ? 45 : 7.5;
  switch (key) {
    case 'ArrowLeft': return turned(view, { azimuth: -step });
    case 'ArrowRight': return turned(view, { azimuth: step });
    case 'ArrowUp': return turned(view, { elevation: step });
    case 'ArrowDown': return turned(view, { elevation: -step });
    case '+': case '=': return zoomed(view, 1.25);
    case '-': case '_': return zoomed(view, 0.8);
    case 'Home': case '0': return first_view;
    default: return null;
  }
}
