// SPDX-License-Identifier: Apache-2.0
// The periodic error of a kept test (Annex C): period, amplitude, phase, as the report tells them. Nothing is kept.
import { useEffect, useState } from 'preact/hooks';
import type { PeriodicShown, Test } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { Field } from '../../components/field';
import { ReportPanel, ReportStatus } from '../../components/report_parts';
import { use_settled } from '../../components/settled';
import { parsed, position_unit, typed } from '../../numbers';
import { place, set_query } from '../../router';
import { language, screen_theme } from '../../settings';
import { test_path } from '../test/state';
import { ViewHead } from '../test/view_head';
import { t } from './texts';
import './periodic.css';

const names = ['period', 'min_period', 'max_period'] as const;
type Name = (typeof names)[number];
type Typed = Record<Name, string>;

const is_wrong = (text: string): boolean => text.trim() !== '' && !((parsed(text) ?? 0) > 0);
const of_address = (): Record<Name, string | null> =>
  ({ period: place.value.query.get('period'), min_period: place.value.query.get('min_period'), max_period: place.value.query.get('max_period') });

/** Sections of the report that say who tested what stand on the page of the test. */
const is_shown = (id: string): boolean => id.startsWith('results') || ['figures', 'findings', 'method'].includes(id);

export function PeriodicPage({ parts }: { parts: Record<string, string> }) {
  const id = parts['id'] ?? '';
  const version = place.value.query.get('version');
  const asked = { version, ...of_address() };
  const test = use_get<Test>(test_path(id, '', { version }));
  const theme = screen_theme.value;
  const found = use_get<PeriodicShown>(test_path(id, '/periodic', { ...asked, theme }));
  const on_paper = use_get<PeriodicShown>(theme === 'light' ? null : test_path(id, '/periodic', { ...asked, theme: 'light' }));
  if (!test.data || String(test.data.id) !== id) {
    if (test.error) return <><h1 tabIndex={-1}>{t('title')}</h1><FailureNotice error={test.error} retry={test.reload} /></>;
    return <><h1 tabIndex={-1} class="visually-hidden">{t('title')}</h1><p class="slow quiet" role="status">{t('loading')}</p></>;
  }
  const shown = found.data;
  const axis = test.data.axis?.name || test.data.result.metadata.axis?.name;
  const sections = (shown?.document.sections ?? []).filter((section) => is_shown(section.id));
  const paper = theme === 'light' ? null : on_paper.data;
  return (
    <>
      <ViewHead test={test.data} title={axis ? t('title_axis', { axis }) : t('title')} view="periodic" report={found.error || !shown ? null : (extension, download) =>
        test_path(id, `/periodic/report.${extension}`, { ...asked, language: language.value, download })} />
      <div class="stack periodic-page">
        <Periods test={test.data} waits={found.loading} />
        {found.error && <FailureNotice error={found.error} {...(found.error.kind === 'bad_input' ? {} : { retry: found.reload })} />}
        {shown && !found.error && (
          <div class={`stack ${found.loading ? 'stale' : ''}`} aria-busy={found.loading}>
            <ReportStatus document={shown.document} />
            <div class="periodic-results">
              {sections.filter(({ id: name }) => name.startsWith('results')).map((section) => <ReportPanel key={section.id} section={section} />)}
            </div>
            {sections.filter(({ id: name }) => !name.startsWith('results')).map((section) =>
              <ReportPanel key={section.id} section={section} on_paper={paper?.document.sections.find(({ id: name }) => name === section.id) ?? null} />)}
          </div>
        )}
      </div>
    </>
  );
}

/** The address says which period is asked for, so that what is found can be sent to somebody. */
function Periods({ test, waits }: { test: Test; waits: boolean }) {
  const unit = position_unit(test.result.axis.kind);
  const at = of_address();
  const told = (text: string | null): string => (text === null ? '' : typed(Number(text)));
  const [form, set_form] = useState<Typed>({ period: told(at.period), min_period: told(at.min_period), max_period: told(at.max_period) });
  const settled = use_settled(form);
  useEffect(() => {
    if (names.some((name) => is_wrong(settled[name]))) return;
    set_query(Object.fromEntries(names.map((name) => [name, settled[name].trim() === '' ? null : String(parsed(settled[name]))])));
  }, [settled]);
  const expected = test.result.metadata.axis?.expected_period;
  const number = (name: Name, hint?: string) => (
    <Field label={t(name, { unit })} hint={hint} fault={is_wrong(form[name]) ? t('above_zero') : null}>
      {(ids) => <input {...ids} class="number" inputMode="decimal" autocomplete="off" value={form[name]} onInput={(event) => set_form({ ...form, [name]: event.currentTarget.value })} />}
    </Field>
  );
  return (
    <section class="panel no-print" aria-labelledby="periods">
      <header><h2 id="periods">{t('sought')}</h2>{waits && <span class="quiet small" role="status">{t('loading')}</span>}</header>
      <div class="periods">
        {number('period', t('period_hint'))}
        {number('min_period')}
        {number('max_period')}
      </div>
      {expected !== undefined && expected !== null && form.period.trim() === '' && (
        <p class="small">{t('expected', { period: typed(expected), unit })} <button type="button" class="link small" onClick={() => set_form({ period: typed(expected), min_period: '', max_period: '' })}>{t('take')}</button></p>
      )}
    </section>
  );
}
