// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { get, send } from '../../api/client';
import type { Changes, Revision, Test, Vocabulary } from '../../api/types';
import { Dialog } from '../../components/dialog';
import { Field } from '../../components/field';
import { keep_focus } from '../../focus';
import { texts } from '../../i18n/texts';
import { when } from '../../numbers';
import { Differences, different_keys } from './differences';
import { LimitChanges } from './limit_changes';
import { ReasonDialog } from './reason_dialog';
import { test_path, type TestState } from './state';

const t = texts({
  title: 'Save as version {version}',
  save: 'Save',
  name: 'Title of the test',
  raw: 'The measured data stay as they are; version {version} stays readable.',
  awaited: 'Limits and verdicts of this edit are being evaluated …',
  unknown: 'This edit could not be evaluated as a whole: whether a limit changes or a verdict turns is not known.',
  again: 'Try again',
  base: 'Version {version}',
  mine: 'This edit',
  conflict: 'Somebody else saved first',
  who: 'Version {version} was saved by {actor}, {at}.',
  unnamed: 'somebody unnamed',
  why: 'Reason: {reason}',
  both: 'Changed in both: {count}. This edit wins where it is re-applied.',
  theirs: 'Version {version}',
  reapply: 'Re-apply my changes to version {version}',
  later: 'Not now',
  drop: 'Discard my changes',
});

/** What was changed since `base`, put onto `other`. */
function rebased(base: Changes, mine: Changes, other: Changes): Changes {
  const next = { ...other };
  for (const key of different_keys(base, mine)) {
    const value = mine[key];
    if (value === undefined) delete next[key];
    else next[key] = value;
  }
  return next;
}

interface Props { state: TestState; vocabulary: Vocabulary; close: () => void; adopt: (saved: Test) => void }

/** Keeps the draft as a new version; where somebody was faster, shows what they did and moves the edits on top of it. */
export function SaveDialog({ state, vocabulary, close, adopt }: Props) {
  const test = state.test.value;
  const [newer, set_newer] = useState<Test | null>(null);
  if (newer !== null) return <Conflict state={state} newer={newer} vocabulary={vocabulary} close={close} adopt={adopt} />;
  const save = async (reason: string) => {
    const revision: Revision = { base_version: test.version, title: state.title.value.trim(), reason, changes: state.changes.value, options: state.options.value };
    adopt(await send<Test>('POST', test_path(test.id, '/versions'), revision));
    keep_focus();
  };
  const look = () => void get<Test>(test_path(test.id)).then(set_newer, () => undefined);
  return (
    <ReasonDialog title={t('title', { version: test.latest + 1 })} action={t('save')} close={close} act={save}
      caught={(failure) => { if (failure.kind === 'conflict') look(); if (failure.kind === 'kept') state.discard(); return false; }} disabled={state.title.value.trim() === ''}>
      <p class="small quiet">{t('raw', { version: test.version })}</p>
      <Field label={t('name')}>{(ids) => <input {...ids} type="text" value={state.title.value} onInput={(event) => state.rename(event.currentTarget.value)} />}</Field>
      <Differences vocabulary={vocabulary} of={test} stated={state.stated.value} states={[
        { title: t('base', { version: test.version }), state: test },
        { title: t('mine'), state: { changes: state.changes.value, options: state.options.value } },
      ]} />
      <div aria-live="polite">
        <Consequence state={state} before={test} />
      </div>
    </ReasonDialog>
  );
}

/** What the edit changes of limits and verdicts; never of an edit that could not be evaluated. */
function Consequence({ state, before }: { state: TestState; before: Test }) {
  if (!state.edited.value) return null;
  if (state.busy.value !== 'no') return <p class="quiet">{t('awaited')}</p>;
  if (state.failure.value === null && Object.keys(state.faults.value).length === 0) return <LimitChanges before={before} after={state.evaluated.value} />;
  return (
    <p class="notice caution">
      {t('unknown')}{' '}
      {state.failure.value !== null && <button type="button" class="link" onClick={() => state.evaluate_again()}>{t('again')}</button>}
    </p>
  );
}

function Conflict({ state, newer, vocabulary, close, adopt }: Props & { newer: Test }) {
  const test = state.test.value;
  const mine = { changes: state.changes.value, options: state.options.value };
  const [kept_options] = useState(mine.options);
  const both = different_keys(test.changes, mine.changes).filter((key) => different_keys(test.changes, newer.changes).includes(key));
  const reapply = () => {
    const changes = rebased(test.changes, mine.changes, newer.changes);
    const options = JSON.stringify(kept_options) === JSON.stringify(test.options) ? newer.options : kept_options;
    const title = state.title.value === test.title ? newer.title : state.title.value;
    adopt(newer);
    state.rename(title);
    state.replace(changes, options);
    state.editing.value = true;
    close();
  };
  return (
    <Dialog
      wide title={t('conflict')} on_close={close}
      actions={
        <>
          <button type="button" onClick={() => { state.discard(); adopt(newer); close(); }}>{t('drop')}</button>
          <button type="button" onClick={close}>{t('later')}</button>
          <button type="button" class="primary" onClick={reapply}>{t('reapply', { version: newer.version })}</button>
        </>
      }
    >
      {newer.versions.filter((version) => version.version > test.version).map((version) => (
        <p key={version.version}>
          {t('who', { version: version.version, actor: version.actor || t('unnamed'), at: when(version.at) })}
          {version.reason !== '' && <> {t('why', { reason: version.reason })}</>}
        </p>
      ))}
      <Differences vocabulary={vocabulary} of={test} stated={state.stated.value} states={[
        { title: t('base', { version: test.version }), state: test },
        { title: t('theirs', { version: newer.version }), state: newer },
        { title: t('mine'), state: mine },
      ]} />
      {both.length > 0 && <p class="notice caution">{t('both', { count: both.length })}</p>}
    </Dialog>
  );
}
