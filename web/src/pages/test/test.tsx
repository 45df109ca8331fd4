// SPDX-License-Identifier: Apache-2.0
// The page of one test: what the axis does, how sure that is, and what may be changed about it.
import { useSignalEffect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Test, Vocabulary } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { texts } from '../../i18n/texts';
import { place, unsaved } from '../../router';
import '../compensations/compensations.css';
import { TablesOfTest } from '../compensations/of_test';
import { Budget } from './budget';
import { Documents } from './documents';
import { keep_draft } from './draft_store';
import { EditPanel } from './edit_panel';
import { Findings } from './findings';
import { Head } from './head';
import { Headline } from './headline';
import { LibraryFigures } from './library_figures';
import { Parameters } from './parameters';
import { PositionChart } from './position_chart';
import { Positions } from './positions';
import { TestState, test_path } from './state';
import { Surroundings } from './surroundings';
import { OldVersionBanner, Versions } from './versions';
import './test.css';

const t = texts({
  loading: 'The test is loading …',
  title: 'Test',
  leave: 'The changes of this test are not saved. Leave anyway? This tab keeps them until it is closed.',
});

/** One state for each version that is looked at; the same version again, as in another language, only refreshes it. */
function use_state(test: Test | null): TestState | null {
  const kept = useRef<TestState | null>(null);
  const seen = useRef<Test | null>(null);
  const before = kept.current;
  if (test !== null && (before === null || before.test.peek().id !== test.id || before.test.peek().version !== test.version)) {
    before?.stop();
    kept.current = new TestState(test);
    seen.current = test;
  }
  useEffect(() => {
    if (test === null || test === seen.current) return;
    seen.current = test;
    kept.current?.refresh(test);
  }, [test]);
  useEffect(() => () => kept.current?.stop(), []);
  return kept.current;
}

export function OneTestPage({ parts }: { parts: Record<string, string> }) {
  const version = place.value.query.get('version');
  const loaded = use_get<Test>(test_path(parts['id'] ?? '', '', { version }));
  const vocabulary = use_get<Vocabulary>('/api/vocabulary').data;
  // After the address has changed, nothing of the former test is shown as if it were this one.
  const fits = loaded.data !== null && String(loaded.data.id) === parts['id'];
  const state = use_state(fits ? loaded.data : null);
  if (loaded.error && (!fits || loaded.error.kind === 'not_found')) {
    return <><h1 tabIndex={-1}>{t('title')}</h1><FailureNotice error={loaded.error} retry={loaded.reload} /></>;
  }
  if (!fits || state === null) return <><h1 tabIndex={-1} class="visually-hidden">{t('title')}</h1><p class="slow quiet" role="status">{t('loading')}</p></>;
  const adopt = (saved: Test) => {
    keep_draft(saved.id, null);
    state.take(saved);
    loaded.set(saved);
  };
  return (
    <>
      {loaded.error && <FailureNotice error={loaded.error} retry={loaded.reload} />}
      <Whole key={`${state.test.value.id}`} state={state} vocabulary={vocabulary} adopt={adopt} />
    </>
  );
}

function Whole({ state, vocabulary, adopt }: { state: TestState; vocabulary: Vocabulary | null; adopt: (saved: Test) => void }) {
  useSignalEffect(() => { unsaved.value = state.dirty.value ? t('leave') : null; });
  useEffect(() => () => { unsaved.value = null; }, []);
  const editing = state.editing.value && vocabulary !== null;
  return (
    <article class={`test-page ${editing ? 'editing' : ''}`}>
      <Head state={state} />
      <OldVersionBanner test={state.test.value} />
      <div class="test-body">
        <div class="test-main">
          <Headline state={state} vocabulary={vocabulary} />
          <div class="test-columns">
            <div class="stack">
              <PositionChart state={state} height={380} />
              <Surroundings state={state} />
              <Positions state={state} />
              <LibraryFigures state={state} />
            </div>
            <div class="stack">
              <Findings state={state} vocabulary={vocabulary} />
              <Parameters state={state} vocabulary={vocabulary} />
              <Budget state={state} />
              <TablesOfTest test={state.test.value.id} />
              <Versions state={state} vocabulary={vocabulary} />
              <Documents state={state} />
            </div>
          </div>
        </div>
        {editing && <EditPanel state={state} vocabulary={vocabulary} adopt={adopt} />}
      </div>
    </article>
  );
}
