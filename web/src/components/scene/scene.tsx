// SPDX-License-Identifier: Apache-2.0
// A machine's working volume in three dimensions, drawn as SVG: turned with the mouse, a finger or the arrow keys, nearer
// with the wheel (with Ctrl, or when it has the focus), two fingers or + and −. What it shows is said in scene/model.ts.
import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { texts } from '../../i18n/texts';
import { shortest } from '../../numbers';
import { decimal } from '../../settings';
import { drawing_of } from './drawing';
import { watch_hands } from './hands';
import type { SceneModel } from './model';
import { Picture, ScaleLegend } from './picture';
import { first_view, turned, view_by_key, zoomed, type View } from './projection';
import './scene.css';

export type { SceneArrow, SceneModel, ScenePatch, ScenePath, ScenePoint, SceneScale, SceneSolid, Token } from './model';
export { station_solids } from './model';
export type { Extent, Place } from './projection';

const t = texts({
  kind: 'picture in three dimensions',
  keys: 'Arrow keys turn it, with Shift in large steps; plus and minus bring it nearer and farther, Home shows it as at first.',
  hint: 'drag to turn',
  views: 'From where',
  oblique: 'Oblique',
  front: 'Front',
  side: 'Right',
  top: 'Top',
  nearer: 'Nearer',
  farther: 'Farther',
  seen: 'Seen from {azimuth}° to the right of the front, {elevation}° above',
});

const views: readonly (readonly ['oblique' | 'front' | 'side' | 'top', Pick<View, 'azimuth' | 'elevation'>])[] = [
  ['oblique', first_view], ['front', { azimuth: 0, elevation: 0 }], ['side', { azimuth: 90, elevation: 0 }], ['top', { azimuth: 0, elevation: 90 }],
];

interface Props {
  model: SceneModel;
  name: string;         // what it shows
  description: string;  // the same in sentences with its numbers, for those who do not see it
  height?: number;      // px, 420 when not given
  on_choose?: (key: string) => void;  // a click on a path or a point
  shared?: SharedView;  // of pictures that turn together
}

export type SharedView = readonly [View, (change: View | ((before: View) => View)) => void];

/** For pictures beside each other, which are turned as one. */
export const use_shared_view = (): SharedView => useState(first_view);

export function Scene({ model, name, description, height = 420, on_choose, shared }: Props) {
  const frame = useRef<HTMLDivElement>(null);
  const own = use_shared_view();
  const [view, set_view] = shared ?? own;
  const [width, set_width] = useState(640);
  const [said, set_said] = useState('');
  useLayoutEffect(() => {
    const box = frame.current as HTMLDivElement;
    const measure = () => { if (box.clientWidth > 0) set_width(box.clientWidth); };
    measure();
    const watch = new ResizeObserver(measure);
    watch.observe(box);
    const end = new AbortController();
    watch_hands(box, {
      turn: (azimuth, elevation) => set_view((before) => turned(before, { azimuth, elevation })),
      zoom: (factor) => set_view((before) => zoomed(before, factor)),
    }, end.signal);
    return () => { watch.disconnect(); end.abort(); };
  }, []);
  const tall = Math.min(height, Math.max(260, width * 0.9));
  const drawing = useMemo(() => drawing_of(model, view, [width, tall], (mm) => shortest(mm, 1)), [model, view, width, tall, decimal.value]);
  const key = (event: KeyboardEvent) => {
    const next = event.ctrlKey || event.metaKey || event.altKey ? null : view_by_key(view, event.key, event.shiftKey);
    if (next === null) return;
    event.preventDefault();
    set_view(next);
    set_said(t('seen', { azimuth: shortest(next.azimuth, 0), elevation: shortest(next.elevation, 0) }));
  };
  const is_view = (one: Pick<View, 'azimuth' | 'elevation'>) => one.azimuth === view.azimuth && one.elevation === view.elevation;
  return (
    <div class="scene">
      <div
        class="scene-frame" ref={frame} role="application" aria-roledescription={t('kind')} aria-label={`${name}. ${t('keys')}`}
        tabIndex={0} onKeyDown={key} style={{ height: `${tall}px` }}
      >
        <Picture drawing={drawing} size={[width, tall]} name={`${name}. ${description}`} on_choose={on_choose} />
        <span class="scene-hint no-print" aria-hidden="true">{t('hint')}</span>
        {model.scale && <ScaleLegend scale={model.scale} />}
      </div>
      <div class="scene-views no-print" role="group" aria-label={t('views')}>
        {views.map(([id, from]) => (
          <button key={id} type="button" aria-pressed={is_view(from)} onClick={() => set_view({ ...view, ...from, zoom: id === 'oblique' ? 1 : view.zoom })}>{t(id)}</button>
        ))}
        <button type="button" class="sign" aria-label={t('farther')} title={t('farther')} onClick={() => set_view(zoomed(view, 0.8))}>−</button>
        <button type="button" class="sign" aria-label={t('nearer')} title={t('nearer')} onClick={() => set_view(zoomed(view, 1.25))}>+</button>
      </div>
      <div class="visually-hidden" aria-live="polite">{said}</div>
    </div>
  );
}
