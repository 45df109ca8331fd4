// SPDX-License-Identifier: Apache-2.0
// A scene as flat pieces in the order in which they are drawn: what is hidden apart from what is seen. Pure.
import { box_edges, type BoxEdge } from './box';
import { places_of, type SceneArrow, type SceneModel, type ScenePath, type ScenePoint, type SceneScale, type SceneSolid } from './model';
import { between, dot, extent_of, plus, projection_of, times, type Flat, type Place, type Projection, type View } from './projection';
import { ball_solid, box_solid, cylinder_solid, hidden_piece, rest_of, type Piece, type Solid } from './solids';
import { placed_words, type PlacedWord, type Word } from './words';

export interface DrawnFace { key: string; points: string; colour: string; edge: string | null }
export interface DrawnStroke { key: string; from: Flat; to: Flat; colour: string; width: number; dash: readonly number[] | null; hidden: boolean; quiet: boolean }
export interface DrawnDot { key: string; at: Flat; colour: string; size: number; shape: 'dot' | 'ring' | 'cross'; hidden: boolean }

export interface Drawing {
  floor: string | null;
  behind: DrawnStroke[];      // edges of the volume that its own faces would hide
  patches: DrawnFace[];
  faces: DrawnFace[];
  strokes: DrawnStroke[];
  heads: DrawnFace[];         // of arrows
  dots: DrawnDot[];
  words: PlacedWord[];
}

const points_text = (points: readonly Flat[]): string => points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');

export const solid_of = ({ shape }: SceneSolid): Solid =>
  shape.kind === 'box' ? box_solid(shape) : shape.kind === 'ball' ? ball_solid(shape.centre, shape.radius) : cylinder_solid(shape.base, shape.radius, shape.height);

/** A colour between the ends of the scale's ramp of three colours. */
export function scale_colour(value: number, { low, high }: SceneScale): string {
  const part = high > low ? Math.min(1, Math.max(0, (value - low) / (high - low))) : 0;
  const [from, to, share] = part < 0.5 ? ['--scale-low', '--scale-middle', part * 200] : ['--scale-middle', '--scale-high', part * 200 - 100];
  return `color-mix(in oklab, var(${to}) ${share.toFixed(0)}%, var(${from}))`;
}

const light: Place = [-0.37, -0.56, 0.74];  // from the front left above

/** The faces towards the viewer of all bodies, the farthest body first. */
function drawn_faces(solids: readonly (SceneSolid & { body: Solid })[], view: Projection): DrawnFace[] {
  const depth = (body: Solid) => Math.max(...body.faces.flat().map(view.depth));
  return [...solids].sort((a, b) => depth(a.body) - depth(b.body)).flatMap(({ key, colour, body, shape }) =>
    body.faces.flatMap((face, k): DrawnFace[] => {
      const { normal } = body.planes[k] as { normal: Place };
      if (dot(normal, view.out) <= 1e-9) return [];
      const share = 46 - 26 * dot(normal, light);
      const fill = `color-mix(in srgb, var(${colour}) ${share.toFixed(0)}%, var(--surface))`;
      return [{ key: `${key}-${k}`, points: points_text(face.map(view.flat)), colour: fill, edge: shape.kind === 'box' ? `var(${colour})` : fill }];
    }));
}

interface Stroke { key: string; from: Place; to: Place; colour: string; width: number; dash: readonly number[] | null; quiet: boolean }

/** Cut where bodies hide it. */
function pieces_of(stroke: Stroke, bodies: readonly Solid[], view: Projection): DrawnStroke[] {
  const { key, from, to, ...look } = stroke;
  const hidden = bodies.map((body) => hidden_piece(body, from, to, view.out)).filter((piece): piece is Piece => piece !== null);
  const seen = rest_of(hidden);
  const piece = (of: Piece, is_hidden: boolean, k: number): DrawnStroke => ({
    ...look, key: `${key}/${is_hidden ? 'h' : ''}${k}`, from: view.flat(between(from, to, of[0])), to: view.flat(between(from, to, of[1])), hidden: is_hidden,
  });
  const not_seen = rest_of(seen);
  return [...not_seen.map((one, k) => piece(one, true, k)), ...seen.map((one, k) => piece(one, false, k))];
}

function strokes_of(path: ScenePath): Stroke[] {
  const { colour, dash = null, quiet = false } = path;
  const width = (path.width ?? (quiet ? 1 : 1.75)) * (path.chosen ? 1.8 : 1);
  return path.places.slice(1).map((to, k) => ({ key: `${path.key}.${k}`, from: path.places[k] as Place, to, colour: `var(${colour})`, width, dash, quiet }));
}

/** A head of three points at the end of a way on the screen; none where that is too short to show one. */
function head_of(key: string, from: Flat, to: Flat, colour: string, size: number): DrawnFace[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 2) return [];
  const head = Math.min(size, length);
  const [ux, uy] = [dx / length, dy / length];
  const back: Flat = [to[0] - head * ux, to[1] - head * uy];
  const [wx, wy] = [-uy * head * 0.36, ux * head * 0.36];
  return [{ key: `${key}>`, points: points_text([to, [back[0] + wx, back[1] + wy], [back[0] - wx, back[1] - wy]]), colour, edge: null }];
}

function path_head(path: ScenePath, view: Projection): DrawnFace[] {
  const [from, to] = path.places.slice(-2);
  if (!path.arrow || !to || !from) return [];
  return head_of(path.key, view.flat(from), view.flat(to), `var(${path.colour})`, path.chosen ? 11 : 9);
}

const arrow_stroke = ({ key, at, by, value }: SceneArrow, scale: SceneScale): Stroke =>
  ({ key, from: at, to: plus(at, by), colour: scale_colour(value, scale), width: 1.5, dash: null, quiet: false });

function drawn_dots(points: readonly ScenePoint[], bodies: readonly Solid[], view: Projection): DrawnDot[] {
  return [...points].sort((a, b) => view.depth(a.at) - view.depth(b.at)).map(({ key, at, colour, size = 5, shape = 'dot' }) => ({
    key, at: view.flat(at), colour: `var(${colour})`, size, shape,
    hidden: bodies.some((body) => hidden_piece(body, at, at, view.out) !== null),
  }));
}

const edge_stroke = (edge: BoxEdge): Stroke =>
  ({ key: edge.key, from: edge.from, to: edge.to, colour: 'var(--line-strong)', width: 1, dash: edge.behind ? [3, 3] : null, quiet: edge.behind });

/** The name of each axis along its edge, and where its travel begins and ends. */
function axis_words(edges: readonly BoxEdge[], view: Projection, size: Flat, number: (mm: number) => string): Word[] {
  return edges.filter(({ named }) => named).flatMap(({ axis, from, to }): Word[] => {
    const [a, b, middle] = [view.flat(from), view.flat(to), view.flat(between(from, to, 0.5))];
    if (Math.hypot(b[0] - a[0], b[1] - a[1]) < 24) return [];
    const off = outwards(a, b, [size[0] / 2, size[1] / 2]);
    const beside = (at: Flat, px: number): Flat => [at[0] + off[0] * px, at[1] + off[1] * px];
    const name = 'XYZ'[axis] as string;
    return [
      { key: `axis-${name}`, text: name, at: beside(middle, 20), kind: 'axis' },
      { key: `axis-${name}-0`, text: number(from[axis] as number), at: beside(view.flat(between(from, to, 0.04)), 17), kind: 'end' },
      { key: `axis-${name}-1`, text: number(to[axis] as number), at: beside(view.flat(between(from, to, 0.96)), 17), kind: 'end' },
    ];
  });
}

/** The unit vector across a line on the screen, away from the middle. */
function outwards(a: Flat, b: Flat, middle: Flat): Flat {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const across: Flat = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
  const away = across[0] * ((a[0] + b[0]) / 2 - middle[0]) + across[1] * ((a[1] + b[1]) / 2 - middle[1]);
  return away < 0 ? [-across[0], -across[1]] : across;
}

function name_words(model: SceneModel, view: Projection): Word[] {
  const words: Word[] = [];
  const add = (key: string, text: string | undefined, at: Place | undefined, colour: string) => {
    if (text && at) words.push({ key: `name-${key}`, text, at: view.flat(at), kind: 'name', colour: `var(${colour})` });
  };
  for (const path of model.paths ?? []) add(path.key, path.label, path.places[path.places.length - 1], path.colour);
  for (const { key, label, at, colour } of model.points ?? []) add(key, label, at, colour);
  for (const { key, label, shape } of model.solids ?? [])
    add(key, label, shape.kind === 'box' ? between(shape.low, shape.high, 0.5) : shape.kind === 'ball' ? plus(shape.centre, times(shape.radius, view.up)) : shape.base, '--ink');
  return words;
}

/** All that is drawn, seen like that. `number` spells the ends of travels. */
export function drawing_of(model: SceneModel, view: View, size: Flat, number: (mm: number) => string): Drawing {
  const extent = extent_of(places_of(model));
  const projection = projection_of(view, extent, size, 30);
  const solids = (model.solids ?? []).map((solid) => ({ ...solid, body: solid_of(solid) }));
  const bodies = solids.map(({ body }) => body);
  const edges = model.box ? box_edges(model.box, projection) : [];
  const scale = model.scale ?? null;
  const arrows = scale ? (model.arrows ?? []) : [];
  const nearest_last = (a: Stroke, b: Stroke) => projection.depth(between(a.from, a.to, 0.5)) - projection.depth(between(b.from, b.to, 0.5));
  const strokes = [...(model.paths ?? []).flatMap(strokes_of), ...arrows.map((arrow) => arrow_stroke(arrow, scale as SceneScale))].sort(nearest_last);
  const cut = (list: Stroke[]) => list.flatMap((stroke) => pieces_of(stroke, bodies, projection));
  const floor = model.box && floor_of(model.box, view);
  return {
    floor: floor && points_text(floor.map(projection.flat)),
    behind: cut(edges.filter(({ behind }) => behind).map(edge_stroke)),
    patches: scale === null ? [] : [...(model.patches ?? [])].sort((a, b) => projection.depth(middle_of(a.corners)) - projection.depth(middle_of(b.corners)))
      .map(({ key, corners, value }) => ({ key, points: points_text(corners.map(projection.flat)), colour: scale_colour(value, scale), edge: null })),
    faces: drawn_faces(solids, projection),
    strokes: [...cut(edges.filter(({ behind }) => !behind).map(edge_stroke)), ...cut(strokes)],
    heads: [...(model.paths ?? []).flatMap((path) => path_head(path, projection)),
            ...arrows.flatMap(({ key, at, by, value }) => head_of(key, projection.flat(at), projection.flat(plus(at, by)), scale_colour(value, scale as SceneScale), 6))],
    dots: drawn_dots(model.points ?? [], bodies, projection),
    words: placed_words([...axis_words(edges, projection, size, number), ...name_words(model, projection)], size),
  };
}

const middle_of = (places: readonly Place[]): Place => times(1 / Math.max(places.length, 1), places.reduce((sum, place) => plus(sum, place), [0, 0, 0] as Place));

/** The face that one looks onto from inside: the lower one seen from above, the upper one from below. */
function floor_of({ low, high }: { low: Place; high: Place }, view: View): Place[] {
  const z = view.elevation >= 0 ? low[2] : high[2];
  return [[low[0], low[1], z], [high[0], low[1], z], [high[0], high[1], z], [low[0], high[1], z]];
}
