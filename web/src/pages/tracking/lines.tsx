// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import type { TrackingDraft, TrackingPoints, TrackingRequest } from '../../api/types';
import { Field } from '../../components/field';
import { sentence } from '../../components/findings';
import { Scene } from '../../components/scene/scene';
import { DataTable } from '../../components/table';
import { fixed, shortest } from '../../numbers';
import { language } from '../../settings';
import { lasting } from '../plan/outcome';
import { TextNumber, type FormProps } from './fields';
import { is_aligned, type TrackingForm } from './form';
import { line_colour, tracking_scene } from './scene_model';
import { place_text } from './station';
import { t } from './texts';
import { station_place } from './station_place';

interface Props extends FormProps {
  request: TrackingRequest | null;
  draft: TrackingDraft | null;      // the last good one
  is_of_request: boolean;           // and whether it is of what stands in the form
  points: TrackingPoints | null;
  failure: ComponentChildren;
  taken: ComponentChildren;         // buttons that take the plan along
}

/** The set-up as a picture, and what can be measured. */
export function LinesPanel(props: Props) {
  const { request, draft, is_of_request, points, failure, taken } = props;
  const [chosen, set_chosen] = useState<string | null>(null);
  const [ways, set_ways] = useState(false);
  const [beams, set_beams] = useState(true);
  const drawn = is_of_request ? draft : null;
  const scene = useMemo(() => request && tracking_scene({ request, draft: drawn, points }, { ways, beams, chosen }), [request, drawn, points, ways, beams, chosen, language.value]);
  return (
    <section class="panel tracking-lines" aria-labelledby="tracking-lines">
      <header>
        <h2 id="tracking-lines"><span class="step">3</span>{t('lines')}</h2>
        <div class="row no-print">{taken}</div>
      </header>
      <Programme {...props} />
      {failure}
      {scene && <Scene model={scene} name={t('picture')} description={told(request, drawn)} height={460} on_choose={(key) => set_chosen(key === chosen ? null : key)} />}
      <p class="only-print">{told(request, drawn)}</p>
      <div class="row no-print scene-parts">
        {!is_aligned(props.form) && <label><input type="checkbox" checked={beams} onChange={(event) => set_beams(event.currentTarget.checked)} />{t('beams')}</label>}
        <label><input type="checkbox" checked={ways} onChange={(event) => set_ways(event.currentTarget.checked)} />{t('ways')}</label>
      </div>
      {draft && !is_of_request && <p class="quiet small">{t('last_good')}</p>}
      {draft && <Figures draft={draft} />}
      {draft && <LineTable draft={draft} chosen={chosen} choose={set_chosen} />}
      {draft && <Lost draft={draft} />}
    </section>
  );
}

/** The picture in sentences. */
function told(request: TrackingRequest | null, draft: TrackingDraft | null): string {
  if (!request) return '';
  const { travel, tool_offset_mm: tool } = request.setup;
  const reach = (k: number) => [travel.lowest_mm, travel.highest_mm].map((end) => shortest((end[k] ?? 0) + (tool?.[k] ?? 0), 1)).join(' … ');
  const lines = draft === null ? t('nothing_planned') : [
    t('told_lines', { n: draft.lines.length, ids: draft.lines.map(({ id }) => id).join(', ') }),
    ...(draft.lost.length > 0 ? [t('told_lost', { ids: draft.lost.map(({ id }) => id).join(', ') })] : []),
  ].join(' ');
  const at = station_place(request.setup);
  const where = { x: reach(0), y: reach(1), z: reach(2), lines };
  return at === null ? t('told_aligned', where) : t('told', { ...where, station: place_text(at) });
}

function Programme(props: Props) {
  const { form, change, draft } = props;
  const first = draft?.plan.lines[0]?.plan;
  const usual = (value: number | null | undefined) => (value === null || value === undefined ? t('automatic') : shortest(value));
  const choices = <K extends 'which' | 'rule'>(key: K, label: string, options: readonly TrackingForm[K][]) => (
    <Field label={label}>
      {(ids) => (
        <select {...ids} value={form[key]} onChange={(event) => change({ [key]: event.currentTarget.value })}>
          {options.map((id) => <option key={id} value={id}>{t(id)}</option>)}
        </select>
      )}
    </Field>
  );
  return (
    <div class="programme no-print">
      {choices('which', t('which'), ['seven', 'body', 'face', 'both'])}
      {form.which === 'seven' && choices('rule', t('rule'), ['equal', 'corner'])}
      <TextNumber {...props} name="targets" label={t('targets')} placeholder={t('automatic')} />
      <TextNumber {...props} name="runs" label={t('runs')} placeholder={usual(first?.runs)} />
      <TextNumber {...props} name="dwell" label={`${t('dwell')} (s)`} placeholder={usual(first?.dwell_s)} />
      <TextNumber {...props} name="feed" label={`${t('feed')} (mm/min)`} placeholder={usual(first?.feed)} />
      <TextNumber {...props} name="overrun" label={`${t('overrun')} (mm)`} placeholder={usual(first?.overrun)} />
      <TextNumber {...props} name="period" label={`${t('period')} (mm)`} placeholder="–" />
    </div>
  );
}

function Figures({ draft }: { draft: TrackingDraft }) {
  const all = draft.lines.length + draft.lost.length;
  const figures: [string, string][] = [
    [t('lines'), draft.lost.length === 0 ? String(all) : `${draft.lines.length} / ${all}`],
    [t('readings'), String(draft.lines.reduce((sum, { readings }) => sum + readings, 0))],
    [t('duration'), lasting(draft.duration_s)],
  ];
  return (
    <dl class="figures">
      {figures.map(([name, value]) => <div key={name}><dt>{name}</dt><dd class="number">{value}</dd></div>)}
    </dl>
  );
}

export function LineName({ id, k }: { id: string; k: number }) {
  return <span class="line-name"><span class="line-swatch" style={{ background: `var(${line_colour(id, k)})` }} aria-hidden="true" />{id}</span>;
}

function LineTable({ draft, chosen, choose }: { draft: TrackingDraft; chosen: string | null; choose: (id: string | null) => void }) {
  const rows = draft.lines.map((line, k) => ({ ...line, k }));
  return (
    <DataTable caption={t('lines')} rows={rows} row_key={({ id }) => id} row_class={({ id }) => (id === chosen ? 'chosen' : '')}
      columns={[
        { key: 'id', head: t('line'), row_head: true, cell: ({ id, k }) => <button type="button" class="plain small" aria-pressed={id === chosen} onClick={() => choose(id === chosen ? null : id)}><LineName id={id} k={k} /></button> },
        { key: 'standard', head: t('standard'), class: 'standard', cell: ({ standard }) => standard.replace(/:.*$/, '') },
        { key: 'distance', head: t('distance'), number: true, cell: ({ usable }) => (usable ? `${fixed(usable.begin_mm, 0)} … ${fixed(usable.end_mm, 0)}` : '–') },
        { key: 'targets', head: t('targets'), number: true, cell: ({ targets }) => targets.length },
        { key: 'runs', head: t('runs'), number: true, cell: ({ runs }) => runs },
        { key: 'ends', head: t('ends'), cell: ({ usable }) => (usable ? `${usable.limited_by_begin}; ${usable.limited_by_end}` : t('whole_travel')) },
      ]} />
  );
}

function Lost({ draft }: { draft: TrackingDraft }) {
  const notes = draft.remarks.map(sentence);
  if (draft.lost.length === 0 && notes.length === 0) return <p class="quiet small">{t('none_lost')}</p>;
  return (
    <ul class="finding-list">
      {draft.lost.map(({ id, reason }) => (
        <li key={id} class="departure"><span class="weight">{t('lost')} {id}</span><span>{sentence(reason)}</span></li>
      ))}
      {notes.map((note, k) => <li key={k} class="note"><span class="weight">{t('note')}</span><span>{note}</span></li>)}
    </ul>
  );
}
