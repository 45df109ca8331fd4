// SPDX-License-Identifier: Apache-2.0
// A chart of values over targets or time: zoom by dragging, wheel (with Ctrl, or when it has the focus) and two fingers;
// arrow keys move its cursor, and what is there is announced.
import { effect } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type uPlot from 'uplot';
import { texts } from '../../i18n/texts';
import { decimal, shown_theme } from '../../settings';
import './chart.css';
import { chart_key } from './keys';
import { structure, type ChartPlace, type ChartProps } from './model';
import { aligned, make_plot, unzoom, zoom } from './plot';
import { pointed_at, watch_fingers } from './pointer';
import { PlainTip, plain_words } from './tip';

export type { ChartBand, ChartLine, ChartMark, ChartModel, ChartPlace, ChartProps, ChartSeries, Ends, Shape, Values } from './model';
export { ChartLegend, Swatch } from './legend';

const t = texts({
  kind: 'interactive chart',
  keys: 'Arrow keys left and right move from point to point, up and down from series to series; plus and minus zoom, 0 shows all.',
  all: 'Show all',
  drag: 'drag to zoom',
});

const paper_width = 720;   // px, of A4 upright between its margins

export function Chart(props: ChartProps) {
  const frame = useRef<HTMLDivElement>(null);
  const into = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const now = useRef(props);
  now.current = props;
  const [at, set_at] = useState<ChartPlace | null>(null);
  const [zoomed, set_zoomed] = useState(false);
  const [said, set_said] = useState('');
  const [, set_turn] = useState(0);
  const is_zoomed = useRef(false);
  const marked = useRef(false);   // something is marked, and must follow when the plot moves
  marked.current = at !== null || (props.cursor ?? null) !== null;
  const pressed = useRef<[number, number]>([0, 0]);
  const kept = useRef<{ x: [number, number]; y: [number, number] } | null>(null);

  const last_at = useRef<ChartPlace | null>(null);

  const move = (to: ChartPlace | null) => {
    if (last_at.current?.index === to?.index && last_at.current?.series === to?.series) return;
    last_at.current = to;
    set_at(to);
    now.current.on_cursor?.(to);
  };
  const set_zoom = (to: boolean) => { is_zoomed.current = to; set_zoomed(to); };
  const zoom_by = (factor: number, around: number) => { if (plot.current) set_zoom(zoom(plot.current, now.current, factor, around)); };
  const show_all = () => { set_zoom(false); if (plot.current) unzoom(plot.current, now.current); };

  // A new plot only when the kinds of series change; the stretch that is looked at stays.
  const shape = structure(props);
  useLayoutEffect(() => {
    const box = into.current as HTMLDivElement;
    const size = () => ({ width: Math.max(box.clientWidth, 120), height: Math.max(box.clientHeight, 80) });
    const made = make_plot(() => now.current, {
      pointed: (p) => move(pointed_at(p, now.current, p.cursor.left ?? -1, p.cursor.top ?? -1)),
      drawn: () => { if (marked.current) set_turn((n) => n + 1); },
      zoomed: () => set_zoom(true),
      unzoomed: () => set_zoom(false),
    }, size(), box);
    plot.current = made;
    const view = kept.current;
    if (view && is_zoomed.current) {
      made.batch(() => {
        made.setScale('x', { min: view.x[0], max: view.x[1] });
        made.setScale('y', { min: view.y[0], max: view.y[1] });
      });
    }
    const end = new AbortController();
    watch_fingers(made, {
      zoom: zoom_by,
      point: (left, top) => move(pointed_at(made, now.current, left, top)),
      wheel_zooms: (event) => event.ctrlKey || event.metaKey || frame.current === document.activeElement,
    }, end.signal);
    const watch = new ResizeObserver(() => {
      const wanted = size();
      if (wanted.width !== made.width || wanted.height !== made.height) made.setSize(wanted);
    });
    watch.observe(box);
    // Paper is narrower than a screen: drawn for it, words do not shrink with the picture.
    window.addEventListener('beforeprint', () => made.setSize({ ...size(), width: Math.min(size().width, paper_width) }), end);
    window.addEventListener('afterprint', () => made.setSize(size()), end);
    let first = true;
    const redraw = effect(() => {
      void shown_theme.value; void decimal.value;
      if (!first) made.redraw(false, true);
      first = false;
    });
    return () => {
      const { x, y } = made.scales;
      kept.current = x?.min != null && x.max != null && y?.min != null && y.max != null
        ? { x: [x.min, x.max], y: [y.min, y.max] } : null;
      redraw(); watch.disconnect(); end.abort(); made.destroy();
      plot.current = null;
    };
  }, [shape]);

  // New values, and series on or off, in the plot that is there.
  useEffect(() => {
    const p = plot.current;
    if (!p) return;
    p.batch(() => {
      props.series.forEach((series, i) => {
        if (p.series[i + 1] && p.series[i + 1]?.show === Boolean(series.hidden)) p.setSeries(i + 1, { show: !series.hidden });
      });
      p.setData(aligned(props), !is_zoomed.current);
      if (is_zoomed.current) p.redraw(true, false);
    });
  }, [shape, props.x, props.series, props.bands, props.lines, props.marks]);

  const place: ChartPlace | null = at ?? ((props.cursor ?? null) === null ? null : { index: props.cursor as number, series: null });
  const key = (event: KeyboardEvent) => {
    const next = chart_key(event, props, at);
    if (next === null) return;
    event.preventDefault();
    if (next === 'in' || next === 'out') {
      const { min, max } = plot.current?.scales['x'] ?? {};
      zoom_by(next === 'in' ? 0.7 : 1.4, at ? (props.x[at.index] as number) : ((min ?? 0) + (max ?? 1)) / 2);
    } else if (next === 'all') show_all();
    else if (next === 'none') move(null);
    else if (next === 'choose') { if (at) props.on_choose?.(at); }
    else {
      move(next);
      set_said(props.spoken ? props.spoken(next) : plain_words(props, next));
    }
  };
  return (
    <div
      class="chart" ref={frame} role="application" aria-roledescription={t('kind')} aria-label={`${props.name}. ${t('keys')}`}
      tabIndex={0} onKeyDown={key} style={{ height: `${props.height ?? 320}px` }}
      onBlur={() => move(null)}
      onPointerDown={(event) => { pressed.current = [event.clientX, event.clientY]; }}
      onClick={(event) => { if (at && at.series !== null && !dragged(pressed.current, event)) props.on_choose?.(at); }}
    >
      <div class="plot" ref={into} />
      {place && plot.current && <Marks plot={plot.current} props={props} place={place} with_tip={at !== null} />}
      {!zoomed && <span class="zoom-hint no-print" aria-hidden="true">{t('drag')}</span>}
      {zoomed && <button type="button" class="unzoom no-print" onClick={(event) => { event.stopPropagation(); show_all(); }}>{t('all')}</button>}
      <div class="visually-hidden" aria-live="polite">{said}</div>
    </div>
  );
}

/** The end of a drag is no click on a point. */
const dragged = (from: readonly [number, number], to: MouseEvent): boolean => Math.hypot(to.clientX - from[0], to.clientY - from[1]) > 4;

/** The cursor: a line at x, a ring on the point of the chosen series, and what is there. */
function Marks({ plot, props, place, with_tip }: { plot: uPlot; props: ChartProps; place: ChartPlace; with_tip: boolean }) {
  const ratio = window.devicePixelRatio || 1;
  const [left, top] = [plot.bbox.left / ratio, plot.bbox.top / ratio];
  const [width, height] = [plot.bbox.width / ratio, plot.bbox.height / ratio];
  const value = props.x[place.index];
  if (value === undefined) return null;
  const aside = place.series === null ? 0 : (props.series[place.series]?.aside ?? 0);
  const x = plot.valToPos(value, 'x') + aside;
  if (x < -0.5 || x > width + 0.5) return null;
  const level = place.series === null ? null : props.series[place.series]?.values[place.index];
  const y = typeof level === 'number' ? plot.valToPos(level, 'y') : null;
  const side = x > width / 2 ? { right: `${plot.width - left - x + 14}px` } : { left: `${left + x + 14}px` };
  return (
    <>
      <div class="here" style={{ left: `${left + x}px`, top: `${top}px`, height: `${height}px` }} />
      {y !== null && y >= 0 && y <= height && <div class="spot" style={{ left: `${left + x}px`, top: `${top + y}px` }} />}
      {with_tip && <div class="tip" style={side}>{props.tip ? props.tip(place) : <PlainTip model={props} place={place} />}</div>}
    </>
  );
}
