// SPDX-License-Identifier: Apache-2.0
import { useState } from 'preact/hooks';
import { query } from '../../api/client';
import type { FigureList } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { texts } from '../../i18n/texts';
import { decimal, language, screen_theme } from '../../settings';
import type { TestState } from './state';

const t = texts({
  title: 'Figures of the report',
  choose: ['Figure', 'picture'],
  save: 'Save as SVG',
  kept: 'Of version {version}, without the unsaved changes.',
});

/** The figures as the library draws them, which reports hold and exports are. */
export function LibraryFigures({ state }: { state: TestState }) {
  const test = state.test.value;
  const list = use_get<FigureList>(`/api/tests/${test.id}/figures${query({ version: test.version })}`);
  const [at, set_at] = useState(0);
  const figures = list.data?.figures ?? [];
  const n = at < figures.length ? at : 0;
  const path = (theme: string) =>
    `/api/tests/${test.id}/figures/${figures[n]?.id}.svg${query({ version: test.version, theme, language: language.value, decimal: decimal.value })}`;
  const dark = screen_theme.value === 'dark';
  if (list.data !== null && figures.length === 0) return null;
  return (
    <section class="panel figures-panel">
      <header>
        <h2>{t('title')}</h2>
        {figures.length > 0 && <a class="button small no-print" href={path('light')} download={`${test.title} ${figures[n]?.id ?? ''}.svg`}>{t('save')}</a>}
      </header>
      {list.error && <FailureNotice error={list.error} retry={list.reload} />}
      {figures.length > 1 && (
        <select class="figure-choice no-print" aria-label={t('choose')} value={n} onChange={(event) => set_at(Number(event.currentTarget.value))}>
          {figures.map((figure, i) => <option key={figure.id} value={i}>{figure.title}</option>)}
        </select>
      )}
      {figures.length > 0 && (
        <div class="figure-frame" tabIndex={0} role="region" aria-label={t('choose')}>
          <img class={`library-figure ${dark ? 'no-print' : ''}`} src={path(screen_theme.value)} alt={figures[n]?.title ?? ''} />
          {dark && <img class="library-figure only-print" src={path('light')} alt={figures[n]?.title ?? ''} />}
        </div>
      )}
      {state.edited.value && <p class="small quiet">{t('kept', { version: test.version })}</p>}
    </section>
  );
}
