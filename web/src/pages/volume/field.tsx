// SPDX-License-Identifier: Apache-2.0
// The error of the tool point over the volume: slices and arrows to move through, of one result or of two beside each other.
import { useMemo, useState } from 'preact/hooks';
import { ApiError, as_error, query, send } from '../../api/client';
import { as_json, use_posted } from '../../api/posted';
import type { VolumetricAssembly, VolumetricDifference, VolumetricField, VolumetricResult } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { FileDrop } from '../../components/file_drop';
import { Scene, use_shared_view, type SharedView } from '../../components/scene/scene';
import { decimals_for, fixed, shortest } from '../../numbers';
import { decimal, language } from '../../settings';
import { axes } from './error_names';
import { field_scene, grid_of, largest_of, place_of, slice_range, usual_enlargement, type FieldLook, type Grid, type ToolField } from './field_model';
import { VolumeFindings } from './findings';
import { given_model, type Modelled } from './model_parts';
import { t } from './result_texts';
import { colon } from '../../i18n/colon';

const most_bytes = 30_000_000;  // as the server takes
const nodes = 11;

interface Named { name: string; result: Modelled }

/** One field, or with an earlier result both of them over the same part of the volume. */
export function FieldPanel({ result }: { result: Modelled }) {
  const [before, set_before] = useState<Named | null>(null);
  const look = query({ decimal: decimal.value });
  const own = useMemo(() => ({ ...given_model(result), nodes }), [result]);
  const both = useMemo(() => before && {
    before: before.result.model, findings_before: before.result.findings, remarks_before: before.result.remarks,
    after: result.model, findings_after: result.findings, remarks_after: result.remarks, nodes,
  }, [before, result]);
  const field = use_posted<VolumetricField>(`/api/volumetric/field${look}`, both ? null : own, as_json);
  const difference = use_posted<VolumetricDifference>(`/api/volumetric/difference${look}`, both, as_json);
  const compared = both !== null && difference.is_current ? difference.data : null;
  const error = both ? difference.error : field.error;
  const shown = both ? compared && { after: compared.after, before: compared.before, difference: compared } : field.data && { after: field.data };
  const told = shown ? [...shown.after.findings, ...('before' in shown ? shown.before.findings : [])] : [];
  return (
    <section class="panel" aria-labelledby="volume-field">
      <header><h2 id="volume-field">{t('field')}</h2></header>
      <p class="quiet">{t('field_how')}</p>
      {error && <FailureNotice error={error} retry={both ? difference.again : field.again} />}
      {!error && !shown && <p class="quiet">{t('computing')}</p>}
      {shown && <FieldView {...shown} />}
      {shown && told.length > 0 && <VolumeFindings findings={told} />}
      <Earlier before={before?.name ?? null} take={set_before} />
    </section>
  );
}

/** Takes the file of an earlier result; the server looks whether it is one. */
function Earlier({ before, take }: { before: string | null; take: (before: Named | null) => void }) {
  const [error, set_error] = useState<ApiError | null>(null);
  const read = async (file: File) => {
    set_error(null);
    try {
      take({ name: file.name, result: await read_result(file) });
    } catch (thrown) {
      set_error(as_error(thrown));
    }
  };
  return (
    <div class="earlier no-print">
      <h3>{t('before_after')}</h3>
      <p class="quiet small">{t('before_after_how')}</p>
      <FileDrop label={t('choose_before')} hint={t('drop_before')} accept=".json,application/json" take={(file) => void read(file)}>
        {before && <span class="mono small">{before}</span>}
        {before && <button type="button" class="plain small" onClick={() => take(null)}>{t('remove')}</button>}
      </FileDrop>
      {error && <FailureNotice error={error} />}
    </div>
  );
}

/** A result of a file, its texts in the reader's language. */
export async function read_result(file: File): Promise<VolumetricResult | VolumetricAssembly> {
  if (file.size > most_bytes) throw new ApiError('refused', t('too_large', { n: fixed(file.size / 1e6, 1), most: most_bytes / 1e6 }), 0);
  let result: unknown;
  try {
    result = JSON.parse(await file.text());
  } catch {
    throw new ApiError('refused', t('not_result'), 0);
  }
  return send<VolumetricResult | VolumetricAssembly>('POST', `/api/volumetric/result${query({ decimal: decimal.value })}`, { result });
}

interface Shown { after: VolumetricField; before?: VolumetricField; difference?: VolumetricDifference }

function FieldView({ after, before, difference }: Shown) {
  const [tool, set_tool] = useState(after.tools[0]?.tool ?? '');
  const [axis, set_axis] = useState(2);
  const [slice, set_slice] = useState((after.nodes - 1) / 2);
  const [rigid, set_rigid] = useState(false);
  const [all, set_all] = useState(false);
  const [enlarged, set_enlarged] = useState<number | null>(null);
  const view = use_shared_view();
  const now = after.tools.find((one) => one.tool === tool) ?? (after.tools[0] as ToolField);
  const then = before?.tools.find((one) => one.tool === now.tool) ?? null;
  const grid = useMemo(() => grid_of(after, now, rigid), [after, now, rigid]);
  const grid_before = useMemo(() => (before && then ? grid_of(before, then, rigid) : null), [before, then, rigid]);
  const most = largest_of(grid, ...(grid_before ? [grid_before] : []));
  const usual = usual_enlargement(grid, most);
  const times = enlarged ?? usual;
  const look: FieldLook = { axis, slice, enlarged: times, all, scale: { label: '|δ|', unit: 'µm', low: 0, high: most, decimals: decimals_for(most, 3) } };
  const place = fixed(place_of(grid, [slice, slice, slice])[axis], 0);
  const letter = axes[axis] as string;
  const kind = rigid ? 'without_rigid_motion' : 'as_found';
  const pictures: [string | null, Grid, ToolField][] = grid_before && then ? [[t('before'), grid_before, then], [t('after'), grid, now]] : [[null, grid, now]];
  return (
    <>
      <div class="field-controls no-print">
        {after.tools.length > 1 && (
          <Field label={t('tool')}>
            {(ids) => <select {...ids} value={now.tool} onChange={(event) => set_tool(event.currentTarget.value)}>{after.tools.map((one) => <option key={one.tool} value={one.tool}>{one.tool}</option>)}</select>}
          </Field>
        )}
        <Field label={t('across')}>
          {(ids) => <select {...ids} value={axis} onChange={(event) => set_axis(Number(event.currentTarget.value))}>{axes.map((one, k) => <option key={one} value={k}>{one}</option>)}</select>}
        </Field>
        <Field label={t('at', { axis: letter })}>
          {(ids) => (
            <span class="slider">
              <input {...ids} type="range" min={0} max={after.nodes - 1} step={1} value={slice} aria-valuetext={`${place} mm`} onInput={(event) => set_slice(Number(event.currentTarget.value))} />
              <output class="number" for={ids.id}>{t('slice_at', { axis: letter, place })}</output>
            </span>
          )}
        </Field>
        <Field label={t('exaggeration')}>
          {(ids) => (
            <select {...ids} value={times} onChange={(event) => set_enlarged(Number(event.currentTarget.value))}>
              {choices_about(usual, times).map((n) => <option key={n} value={n}>{t('times', { n: shortest(n) })}</option>)}
            </select>
          )}
        </Field>
        <Field label={t('rigid')}>
          {(ids) => (
            <select {...ids} value={kind} onChange={(event) => set_rigid(event.currentTarget.value === 'without_rigid_motion')}>
              {(['as_found', 'without_rigid_motion'] as const).map((one) => <option key={one} value={one} disabled={now[one] === null}>{t(one)}</option>)}
            </select>
          )}
        </Field>
        <label class="all-arrows"><input type="checkbox" checked={all} onChange={(event) => set_all(event.currentTarget.checked)} />{t('all_arrows')}</label>
      </div>
      <div class={`fields ${pictures.length > 1 ? 'two' : ''}`}>
        {pictures.map(([name, of, field]) => (
          <FieldPicture key={name ?? 'one'} {...{ name, look, place, view }} grid={of} field={field} tool={now.tool} kind={kind} most={most} />
        ))}
      </div>
      {before && !then && <p class="notice caution">{t('not_shared')}</p>}
      {difference && then && <DifferenceTold {...{ kind, now, then }} of={difference.tools.find((one) => one.tool === now.tool) ?? null} />}
    </>
  );
}

/** The usual one and its neighbours in steps of 1, 2 and 5. */
function choices_about(usual: number, chosen: number): number[] {
  const all = [1, 2, 3, 4, 5, 6, 7].flatMap((power) => [1, 2, 5].map((n) => n * 10 ** (power - 1)));
  const at = all.indexOf(usual);
  const near = at < 0 ? [usual] : all.slice(Math.max(0, at - 4), at + 5);
  return near.includes(chosen) ? near : [...near, chosen].sort((a, b) => a - b);
}

type SizeKind = 'as_found' | 'without_rigid_motion';
interface PictureProps { name: string | null; grid: Grid; field: ToolField; look: FieldLook; place: string; tool: string; kind: SizeKind; most: number; view: SharedView }

function FieldPicture({ name, grid, field, look, place, tool, kind, most, view }: PictureProps) {
  const scene = useMemo(() => field_scene(grid, look), [grid, look.axis, look.slice, look.enlarged, look.all, look.scale.high, language.value, decimal.value]);
  const range = slice_range(grid, look.axis, look.slice);
  const letter = axes[look.axis] as string;
  const told = range === null ? t('no_field')
    : t('field_told', { axis: letter, place, tool, low: fixed(range[0], 1), high: fixed(range[1], 1), most: fixed(most, 1), n: shortest(look.enlarged) });
  const sizes = field[kind];
  return (
    <div class="field-picture">
      {name && <h3>{name}</h3>}
      {field.error_um.every((error) => error === null) ? <p class="notice caution">{t('no_field')}</p>
        : <Scene model={scene} name={name ? `${t('field_name')}${colon()} ${name}` : t('field_name')} description={told} height={name ? 380 : 460} shared={view} />}
      <p class="small quiet" aria-live="polite">{told}</p>
      {sizes && (
        <dl class="figures">
          <div>
            <dt>{t('size_most')}</dt>
            <dd class="number">{fixed(sizes.largest_um, 1)} <span class="unit">± {fixed(2 * sizes.largest_u_um, 1)} µm (k = 2) {t('size_at', places(sizes.largest_at_mm))}</span></dd>
          </div>
          <div><dt>{t('size_mean')}</dt><dd class="number">{fixed(sizes.mean_um, 1)} <span class="unit">µm</span></dd></div>
          <div><dt>{t('size_95')}</dt><dd class="number">{fixed(sizes.percent_95_um, 1)} <span class="unit">µm</span></dd></div>
        </dl>
      )}
    </div>
  );
}

const places = ([x, y, z]: readonly number[]) => ({ x: fixed(x, 0), y: fixed(y, 0), z: fixed(z, 0) });

/** In words and numbers what the two pictures differ by. */
function DifferenceTold({ kind, now, then, of }: { kind: SizeKind; now: ToolField; then: ToolField; of: VolumetricDifference['tools'][number] | null }) {
  const sizes = of?.[kind] ?? null;
  const [a, b] = [then[kind], now[kind]];
  if (!sizes || !a || !b) return <p class="notice caution">{t('not_told_difference')}</p>;
  const expanded = 2 * sizes.largest_u_um;
  return (
    <div class="notice difference">
      <p class="heading">{t('difference')}</p>
      <p>
        {t('difference_told', { before: fixed(a.largest_um, 1), after: fixed(b.largest_um, 1), most: fixed(sizes.largest_um, 1), mean: fixed(sizes.mean_um, 1) })}
        {expanded > 0 && ` ${sizes.largest_um > expanded
          ? t('difference_sure', { n: fixed(sizes.largest_um / expanded, 1), u: fixed(expanded, decimals_for(expanded, 2)) })
          : t('difference_unsure', { u: fixed(expanded, decimals_for(expanded, 2)) })}`}
      </p>
    </div>
  );
}
