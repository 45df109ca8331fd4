// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { use_get } from '../../api/use';
import type { Test, Vocabulary } from '../../api/types';
import { FailureNotice } from '../../components/failure';
import { texts } from '../../i18n/texts';
import { when } from '../../numbers';
import { go } from '../../router';
import { Differences } from './differences';
import { keep_draft } from './draft_store';
import { test_path, type TestState } from './state';

const t = texts({
  title: 'Versions',
  version: 'Version',
  made: 'Saved',
  by: 'By',
  reason: 'Reason',
  shown: 'shown',
  received: 'received',
  compare: 'What changed since version {version}',
  old: 'This is version {version} of {latest}.',
  to_latest: 'Show version {latest}',
  take_up: 'Edit from this version',
});

/** An older version is never taken for the last one. */
export function OldVersionBanner({ test }: { test: Test }) {
  if (test.version === test.latest) return null;
  const take_up = () => {
    keep_draft(test.id, { base_version: test.latest, changes: test.changes, options: test.options, title: test.title });
    go(`/tests/${test.id}`);
  };
  return (
    <div class="notice caution row spread" role="status">
      <span>{t('old', { version: test.version, latest: test.latest })}</span>
      <span class="row no-print">
        <a class="button" href={`/tests/${test.id}`}>{t('to_latest', { latest: test.latest })}</a>
        <button type="button" onClick={take_up}>{t('take_up')}</button>
      </span>
    </div>
  );
}

const reason_of = (version: Test['versions'][number]): string => version.reason || (version.version === 1 ? t('received') : '');

/** Who saved what, when and why. */
export function Versions({ state, vocabulary }: { state: TestState; vocabulary: Vocabulary | null }) {
  const test = state.test.value;
  const [against, set_against] = useState<number | null>(null);
  return (
    <section class="panel flush archive-panel">
      <header><h2>{t('title')}</h2></header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('title')}>
        <table>
          <thead>
            <tr><th scope="col" class="number">{t('version')}</th><th scope="col">{t('made')}</th><th scope="col" class="wide-only">{t('by')}</th><th scope="col" class="wide-only">{t('reason')}</th></tr>
          </thead>
          <tbody>
            {[...test.versions].sort((a, b) => b.version - a.version).map((version) => (
              <tr key={version.version}>
                <th scope="row" class="number">
                  {version.version === test.version ? <>{version.version} <span class="small quiet">{t('shown')}</span></>
                    : <a href={version.version === test.latest ? `/tests/${test.id}` : `/tests/${test.id}?version=${version.version}`}>{version.version}</a>}
                </th>
                <td>
                  <span class="when">{when(version.at)}</span>
                  <span class="only-narrow quiet small">{[version.actor, reason_of(version)].filter((part) => part !== '').join(': ')}</span>
                </td>
                <td class="wide-only">{version.actor}</td>
                <td class="wide-only">{reason_of(version)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {test.version > 1 && (
        <div class="foot">
          <button type="button" class="small no-print" aria-expanded={against !== null} onClick={() => set_against(against === null ? test.version - 1 : null)}>
            {t('compare', { version: against ?? test.version - 1 })}
          </button>
          {against !== null && vocabulary !== null && <Against state={state} version={against} choose={set_against} vocabulary={vocabulary} />}
        </div>
      )}
    </section>
  );
}

function Against({ state, version, choose, vocabulary }: { state: TestState; version: number; choose: (version: number) => void; vocabulary: Vocabulary }) {
  const test = state.test.value;
  const older = use_get<Test>(test_path(test.id, '', { version }));
  return (
    <div class="stack tight">
      {test.version > 2 && (
        <label class="small">{t('version')}
          <select value={version} onChange={(event) => choose(Number(event.currentTarget.value))}>
            {test.versions.filter((one) => one.version < test.version).map((one) => <option key={one.version} value={one.version}>{one.version}</option>)}
          </select>
        </label>
      )}
      {older.error && <FailureNotice error={older.error} retry={older.reload} />}
      {older.data && <Differences vocabulary={vocabulary} of={test} stated={state.stated.value} states={[
        { title: `${t('version')} ${older.data.version}`, state: older.data }, { title: `${t('version')} ${test.version}`, state: test },
      ]} />}
    </div>
  );
}
