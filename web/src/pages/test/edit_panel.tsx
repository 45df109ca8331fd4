// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import type { Field, Test, Vocabulary } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { Field as FormField } from '../../components/field';
import { texts } from '../../i18n/texts';
import { EditField } from './edit_field';
import { EditOptions } from './edit_options';
import { group_of, group_title } from './field_groups';
import { stated_text } from './field_value';
import { SaveDialog } from './save_dialog';
import { method_field, type TestState } from './state';

const t = texts({
  title: 'Edit',
  name: 'Title of the test',
  search: 'Search the fields',
  only_changed: 'Changed',
  only_missing: ['Missing', 'fields'],
  none: 'No field fits.',
  unchanged: 'Nothing changed yet. Every change shows in all numbers at once; nothing is kept until it is saved as a new version.',
  changes: '{count} changed, not saved',
  faults: '{count} cannot be used',
  restored: 'These unsaved changes were restored.',
  save: 'Save as version {version}',
  discard: 'Discard',
  given: '{given} of {all}',
});

/** What is worked on most often comes first. */
const first = ['tolerance', 'uncertainty', 'drift'];

function grouped(fields: readonly Field[]): [string, Field[]][] {
  const groups = new Map<string, Field[]>();
  for (const field of fields) {
    const group = group_of(field);
    groups.set(group, [...(groups.get(group) ?? []), field]);
  }
  const rank = (group: string): number => (first.includes(group) ? first.indexOf(group) : first.length);
  return [...groups].sort(([a], [b]) => rank(a) - rank(b));
}

type Only = 'all' | 'changed' | 'missing';

/** Metadata and inputs of a test: every change is evaluated at once, and kept only as a new version. */
export function EditPanel({ state, vocabulary, adopt }: { state: TestState; vocabulary: Vocabulary; adopt: (saved: Test) => void }) {
  const [text, set_text] = useState('');
  const [only, set_only] = useState<Only>('all');
  const [saving, set_saving] = useState(false);
  const wanted = state.wanted_field.value;
  // A field that is asked for is shown whatever was searched for.
  const words = wanted === null ? text.toLowerCase().split(/\s+/).filter((word) => word !== '') : [];
  const metadata = state.evaluated.value.result.metadata;
  const fits = (field: Field): boolean => {
    if (wanted === null && only === 'changed' && state.changes.value[field.key] === undefined) return false;
    if (wanted === null && only === 'missing' && (!field.wanted || stated_text(field, metadata) !== '')) return false;
    const all = `${field.title} ${field.key} ${field.clause} ${field.description}`.toLowerCase();
    return words.every((word) => all.includes(word));
  };
  const filtered = words.length > 0 || only !== 'all';
  // The method of record stands with the options of the evaluation, unless these are searched away.
  const groups = grouped(vocabulary.fields.filter((field) => fits(field) && (filtered || field.key !== method_field)));
  const shown = (some: readonly [string, Field[]][]) => some.map(([group, fields]) => (
    <Group key={group} state={state} vocabulary={vocabulary} group={group} fields={fields} open={filtered} />
  ));
  const count = Object.keys(state.faults.value).length;
  return (
    <section class="panel edit-panel no-print" id="edit-panel" aria-label={t('title')}>
      <Bar state={state} faults={count} save={() => set_saving(true)} />
      {state.failure.value && <FailureNotice error={state.failure.value} retry={() => state.retry()} />}
      <FormField label={t('name')}>
        {(ids) => <input {...ids} type="text" value={state.title.value} onInput={(event) => state.rename(event.currentTarget.value)} />}
      </FormField>
      <div class="row">
        <input type="search" class="grow" aria-label={t('search')} placeholder={t('search')} value={text} onInput={(event) => set_text(event.currentTarget.value)} />
        <div class="segments">
          <button type="button" class="small" aria-pressed={only === 'changed'} onClick={() => set_only(only === 'changed' ? 'all' : 'changed')}>{t('only_changed')}</button>
          <button type="button" class="small" aria-pressed={only === 'missing'} onClick={() => set_only(only === 'missing' ? 'all' : 'missing')}>{t('only_missing')}</button>
        </div>
      </div>
      {groups.length === 0 && <p class="quiet">{t('none')}</p>}
      {shown(groups.filter(([group]) => group === 'tolerance'))}
      {!filtered && <EditOptions state={state} vocabulary={vocabulary} />}
      {shown(groups.filter(([group]) => group !== 'tolerance'))}
      {saving && <SaveDialog state={state} vocabulary={vocabulary} close={() => set_saving(false)} adopt={adopt} />}
    </section>
  );
}

/** What is changed, and the way to keep it or not; always in sight. */
function Bar({ state, faults, save }: { state: TestState; faults: number; save: () => void }) {
  const changed = Object.keys(state.changes.value).filter((key) => state.changes.value[key] !== state.test.value.changes[key]).length
    + Object.keys(state.test.value.changes).filter((key) => state.changes.value[key] === undefined).length;
  const dirty = state.dirty.value;
  return (
    <div class="edit-bar">
      <div class="row spread">
        <h2>{t('title')}</h2>
        <div class="row">
          <button type="button" disabled={!dirty} onClick={() => state.discard()}>{t('discard')}</button>
          <button type="button" class="primary" disabled={!dirty || faults > 0 || state.title.value.trim() === ''} onClick={save}>{t('save', { version: state.test.value.latest + 1 })}</button>
        </div>
      </div>
      <p class="small quiet" role="status">
        {state.restored.value && `${t('restored')} `}
        {dirty ? t('changes', { count: Math.max(changed, 1) }) : t('unchanged')}
        {faults > 0 && <span class="fault"> · {t('faults', { count: faults })}</span>}
      </p>
    </div>
  );
}

function Group({ state, vocabulary, group, fields, open }: {
  state: TestState; vocabulary: Vocabulary; group: string; fields: readonly Field[]; open: boolean;
}) {
  const metadata = state.evaluated.value.result.metadata;
  const given = fields.filter((field) => stated_text(field, metadata) !== '').length;
  const wanted = state.wanted_field.value;
  const asked = wanted !== null && fields.some((field) => field.key === wanted);
  const [unfolded, set_unfolded] = useState(group === 'uncertainty' || group === 'drift');
  if (asked && !unfolded) set_unfolded(true);
  return (
    <details class="edit-group" open={open || unfolded || asked} onToggle={(event) => { if (!open) set_unfolded(event.currentTarget.open); }}>
      <summary>{group_title(group)} <span class="small quiet">{t('given', { given, all: fields.length })}</span></summary>
      <div class="edit-fields">
        {(open || unfolded || asked) && fields.map((field) => <EditField key={field.key} state={state} field={field} vocabulary={vocabulary} />)}
      </div>
    </details>
  );
}
