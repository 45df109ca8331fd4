// SPDX-License-Identifier: Apache-2.0
// The mathematics of the picture in three dimensions, without a page.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { fileURLToPath } from 'node:url';

const folder = fileURLToPath(new URL('../src/components/scene/', import.meta.url));
const entry = ['projection', 'solids', 'box', 'words', 'drawing', 'model'].map((name) => `export * from './${name}';`).join('\n');
const { outputFiles } = await build({ stdin: { contents: entry, resolveDir: folder, loader: 'ts' }, bundle: true, format: 'esm', write: false });
const scene = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

const near = (found, expected, what) => assert.ok(Math.abs(found - expected) < 1e-9, `${what}: found ${found}, expected ${expected}`);
const extent = { low: [0, 0, -500], high: [800, 600, 0] };
const size = [800, 500];
const drawn = (model, view = scene.first_view) => scene.drawing_of(model, view, size, String);

export const scene_tests = {
  async 'a scene: the screen has X to the right, Z up, and what is in front is nearer'() {
    const view = scene.projection_of({ azimuth: 0, elevation: 0, zoom: 1 }, extent, size);
    const [a, right, high, front] = [[0, 300, -250], [800, 300, -250], [0, 300, 0], [0, 0, -250]].map((place) => [...view.flat(place), view.depth(place)]);
    assert.ok(right[0] > a[0] && high[1] < a[1] && front[2] > a[2]);
    near(right[1], a[1], 'X stays level');
    const above = scene.projection_of({ azimuth: 0, elevation: 90, zoom: 1 }, extent, size);
    assert.ok(above.flat([0, 600, 0])[1] < above.flat([0, 0, 0])[1], 'from above Y goes up');
    const from_right = scene.projection_of({ azimuth: 90, elevation: 0, zoom: 1 }, extent, size);
    assert.ok(from_right.depth([800, 0, 0]) > from_right.depth([0, 0, 0]), 'from the right large X is near');
  },

  async 'a scene: vectors of the screen are square on each other and of length 1, and all stays within the picture'() {
    for (let azimuth = -180; azimuth <= 180; azimuth += 15)
      for (let elevation = -90; elevation <= 90; elevation += 15) {
        const { right, up, out } = scene.screen_of({ azimuth, elevation, zoom: 1 });
        for (const v of [right, up, out]) near(scene.dot(v, v), 1, 'length');
        near(scene.dot(right, up), 0, 'square'); near(scene.dot(right, out), 0, 'square'); near(scene.dot(up, out), 0, 'square');
        const view = scene.projection_of({ azimuth, elevation, zoom: 1 }, extent, size, 20);
        for (const x of [0, 800]) for (const y of [0, 600]) for (const z of [-500, 0]) {
          const [left, top] = view.flat([x, y, z]);
          assert.ok(left >= 19.9 && left <= 780.1 && top >= 19.9 && top <= 480.1, `${left}, ${top}`);
        }
      }
  },

  async 'a scene: keys turn, zoom within bounds and go back to the beginning'() {
    const first = scene.first_view;
    assert.equal(scene.view_by_key(first, 'ArrowRight').azimuth, first.azimuth + 7.5);
    assert.equal(scene.view_by_key(first, 'ArrowUp', true).elevation, first.elevation + 45);
    assert.equal(scene.view_by_key({ ...first, elevation: 88 }, 'ArrowUp').elevation, 90);
    assert.equal(scene.view_by_key({ ...first, azimuth: 178 }, 'ArrowRight').azimuth, -174.5);
    assert.equal(scene.view_by_key({ ...first, zoom: 8 }, '+').zoom, 8);
    assert.deepEqual(scene.view_by_key({ azimuth: 3, elevation: 4, zoom: 5 }, 'Home'), first);
    assert.equal(scene.view_by_key(first, 'Tab'), null);
  },

  async 'a scene: a body hides exactly the piece of a way that is behind it'() {
    const cube = scene.box_solid({ low: [40, 0, 0], high: [60, 20, 20] });
    const out = [0, -1, 0];
    const piece = scene.hidden_piece(cube, [0, 50, 10], [100, 50, 10], out);
    near(piece[0], 0.4, 'begins'); near(piece[1], 0.6, 'ends');
    assert.equal(scene.hidden_piece(cube, [0, -50, 10], [100, -50, 10], out), null, 'in front of it');
    assert.equal(scene.hidden_piece(cube, [0, 50, 30], [100, 50, 30], out), null, 'above it');
    assert.equal(scene.hidden_piece(cube, [50, -50, 10], [50, 0, 10], out), null, 'up to its face');
    const through = scene.hidden_piece(cube, [50, -50, 10], [50, 50, 10], out);
    near(through[0], 0.5, 'from the face on'); near(through[1], 1, 'to the end');
    assert.deepEqual(scene.hidden_piece(cube, [50, 50, 10], [50, 50, 10], out), [0, 1], 'a point behind it');
  },

  async 'a scene: round bodies hide what is behind them, from every side'() {
    const ball = scene.ball_solid([0, 0, 0], 10);
    const post = scene.cylinder_solid([0, 0, -10], 10, 20);
    for (let k = 0; k < 24; k += 1) {
      const a = (k * Math.PI) / 12;
      const out = [Math.cos(a), Math.sin(a), 0];
      const behind = [-50 * out[0], -50 * out[1], 0];
      const across = [-out[1] * 100, out[0] * 100, 0];
      for (const solid of [ball, post]) {
        const piece = scene.hidden_piece(solid, scene.minus(behind, across), scene.plus(behind, across), out);
        assert.ok(Math.abs(piece[0] - 0.45) < 0.002 && Math.abs(piece[1] - 0.55) < 0.002, `${k}: ${piece}`);
      }
    }
    for (const solid of [ball, post]) solid.faces.forEach((face, k) => {
      const { normal, distance } = solid.planes[k];
      for (const corner of face) assert.ok(scene.dot(normal, corner) <= distance + 1e-6, 'a corner beyond its plane');
    });
  },

  async 'a scene: what is left beside hidden pieces'() {
    assert.deepEqual(scene.rest_of([]), [[0, 1]]);
    assert.deepEqual(scene.rest_of([[0.5, 0.7], [0.1, 0.2], [0.6, 0.8]]), [[0, 0.1], [0.2, 0.5], [0.8, 1]]);
    assert.deepEqual(scene.rest_of([[0, 1]]), []);
  },

  async 'a scene: three edges of the volume are behind, and each axis is named once'() {
    for (let azimuth = -170; azimuth < 180; azimuth += 25)
      for (const elevation of [-60, -10, 10, 60]) {
        const edges = scene.box_edges(extent, scene.projection_of({ azimuth, elevation, zoom: 1 }, extent, size));
        assert.equal(edges.length, 12);
        assert.equal(edges.filter(({ behind }) => behind).length, 3);
        assert.deepEqual(edges.filter(({ named }) => named).map(({ axis }) => axis), [0, 1, 2]);
        assert.ok(edges.every(({ named, behind }) => !(named && behind)));
      }
    const words = drawn({ box: extent }).words.map(({ text }) => text);
    assert.deepEqual(words, ['X', '0', '800', 'Y', '0', '600', 'Z', '-500', '0']);
  },

  async 'a scene: lines behind an obstacle are drawn as hidden, arrows in the colour of their size'() {
    const solids = [{ key: 'vice', shape: { kind: 'box', low: [300, 200, -500], high: [500, 400, -200] }, colour: '--bad', label: 'vice' }];
    const paths = [{ key: 'x', places: [[0, 550, -400], [800, 550, -400]], colour: '--series-1', label: 'x' }];
    const strokes = drawn({ box: extent, solids, paths }, { azimuth: 0, elevation: 0, zoom: 1 }).strokes.filter(({ key }) => key.startsWith('x.'));
    assert.deepEqual(strokes.map(({ hidden }) => hidden).sort(), [false, false, true]);
    const scale = { label: 'error', unit: 'µm', low: 0, high: 10 };
    const arrows = [0, 5, 10].map((value) => ({ key: `a${value}`, at: [100 * value, 0, 0], by: [0, 0, 50], value }));
    const colours = drawn({ box: extent, arrows, scale }).strokes.filter(({ key }) => /^a\d/.test(key)).map(({ colour }) => colour);
    assert.equal(new Set(colours).size, 3);
    assert.equal(scale && scene.scale_colour(-5, scale), scene.scale_colour(0, scale));
    assert.equal(drawn({ box: extent, arrows }).strokes.length, 9, 'without a scale there are none');
  },

  async 'a scene of very many points: the one that is farthest off is drawn and named, wherever it stands'() {
    const coordinates = fileURLToPath(new URL('../src/pages/tracking/', import.meta.url));
    const made = await build({ stdin: { contents: "export * from './coordinates_scene';", resolveDir: coordinates, loader: 'ts' }, bundle: true, format: 'esm', write: false,
      outdir: '/', jsx: 'automatic', jsxImportSource: 'preact', loader: { '.css': 'empty' } });
    const { coordinates_scene } = await import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].text).toString('base64')}`);
    for (const far of [0, 1, 777, 999]) {
      const points = Array.from({ length: 1000 }, (_, k) => ({ name: `P${k}`, position_mm: [k, k % 7, 0], deviation_um: [k === far ? 90 : 1, 0, 0] }));
      const { model, most_um, farthest } = coordinates_scene({ points, stations: [] }, 'off');
      assert.equal(farthest, `P${far}`);
      assert.equal(most_um, 90);
      assert.equal(model.points.length, 300);
      assert.deepEqual(model.points.flatMap(({ label }) => label ?? []), [`P${far}`]);
      assert.equal(Math.max(...model.arrows.map(({ value }) => value)), 90);
    }
  },

  async 'a scene: words keep off each other and within the picture'() {
    const words = Array.from({ length: 6 }, (_, k) => ({ key: `${k}`, text: 'xyz', at: [100 + k, 100], kind: 'name' }));
    const placed = scene.placed_words([...words, { key: 'edge', text: 'a long name', at: [798, 4], kind: 'name' }], size);
    const places = placed.slice(0, 6).map(({ x, y, anchor }) => `${Math.round(x / 10)} ${Math.round(y / 8)} ${anchor}`);
    assert.equal(new Set(places).size, 6);
    const edge = placed.at(-1);
    assert.ok(edge.anchor === 'end' && edge.y > 10);
  },

  async 'a scene: ends of travels cover no other word, however flat the box is and from where it is seen'() {
    const number = (mm) => mm.toFixed(1);
    const boxes = [extent, { low: [-1234.5, -987.6, -20], high: [1234.5, 987.6, 20] }, { low: [-60, -1500, -40], high: [60, 1500, 40] }];
    for (const box of boxes)
      for (let azimuth = -180; azimuth < 180; azimuth += 15)
        for (let elevation = -75; elevation <= 75; elevation += 15) {
          const frames = scene.drawing_of({ box }, { azimuth, elevation, zoom: 1 }, [420, 320], number).words.map(({ x, y, anchor, text }) => {
            assert.equal(anchor, 'middle');
            return { text, left: x - 3.4 * text.length, right: x + 3.4 * text.length, top: y - 11, bottom: y + 3 };
          });
          for (const [k, a] of frames.entries())
            for (const b of frames.slice(k + 1))
              assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${a.text} covers ${b.text} from ${azimuth}, ${elevation}`);
        }
  },
};
