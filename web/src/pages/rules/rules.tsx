// SPDX-License-Identifier: Apache-2.0
// A kept test by other rules than ISO 230-2:2014, side by side, so that specifications are not compared wrongly.
import type { ApiError } from '../../api/client';
import type { ComparedRule, RulesCompared, Test } from '../../api/types';
import { use_get } from '../../api/use';
import { FailureNotice } from '../../components/failure';
import { go, place } from '../../router';
import { decimal, language } from '../../settings';
import { Evidence, PlacedFindings } from './evidence';
import { SideBySide } from './side_by_side';
import { t } from './texts';
import './rules.css';
import '../test/test.css';
import { test_path } from '../test/state';
import { ViewHead } from '../test/view_head';

/** What specification sheets name most. */
const usual = ['vdi-dgq-3441', 'jis-b-0182-1993', 'iso-230-2-2006'];

function chosen_of(rules: readonly ComparedRule[], named: string | null): readonly ComparedRule[] {
  const ids = named === null ? usual : named.split(',');
  return rules.filter(({ id }) => ids.includes(id));
}

export function RulesPage({ parts }: { parts: Record<string, string> }) {
  const id = parts['id'] ?? '';
  const version = place.value.query.get('version');
  const test = use_get<Test>(test_path(id, '', { version }));
  const uncertainty = place.value.query.get('uncertainty');
  const compared = use_get<RulesCompared>(test_path(id, '/rules', { version, uncertainty, decimal: decimal.value }));
  const failed = [test, compared].find(({ error, data }) => error !== null && data === null);
  if (failed?.error) return <><h1 tabIndex={-1}>{t('title')}</h1><FailureNotice error={failed.error} retry={failed.reload} /></>;
  if (!test.data || !compared.data || String(test.data.id) !== id) {
    return <><h1 tabIndex={-1} class="visually-hidden">{t('title')}</h1><p class="slow quiet" role="status">{t('loading')}</p></>;
  }
  return <Compared test={test.data} compared={compared.data} waits={compared.loading} failed={compared.error} />;
}

function Compared({ test, compared, waits, failed }: { test: Test; compared: RulesCompared; waits: boolean; failed: ApiError | null }) {
  const rules = chosen_of(compared.rules, place.value.query.get('rules'));
  const names = compared.rules.filter((rule) => !rules.includes(rule)).map(({ name }) => name);
  const of_chosen = ({ clause }: { clause: string }) => !names.includes(clause);
  const warnings = compared.warnings.filter(of_chosen);
  const findings = compared.findings.filter(of_chosen);
  const axis = test.axis?.name || compared.axis.name;
  const version = test.version === test.latest ? null : test.version;
  const standards = rules.map((rule) => rule.id).join(',');
  const report = (extension: string, download: number | null) => test_path(test.id, `/rules/report.${extension}`,
    { version, standards, uncertainty: place.value.query.get('uncertainty'), language: language.value, decimal: decimal.value, download });
  return (
    <>
      <ViewHead test={test} title={axis ? t('title_axis', { axis }) : t('title')} view="rules" report={rules.length === 0 ? null : report} />
      {!compared.conforming && <p class="notice bad">{t('departs', { standard: compared.standard })}</p>}
      {compared.label && <p class="notice caution">{compared.label}</p>}
      <div class="stack rules-page">
        <Choice all={compared.rules} chosen={rules} waits={waits} />
        {failed && <FailureNotice error={failed} />}
        {rules.length === 0 ? <p class="quiet">{t('none')}</p> : <SideBySide compared={compared} rules={rules} />}
        {warnings.length > 0 && <section class="panel"><header><h2>{t('warnings')}</h2></header><div class="notice caution"><PlacedFindings findings={warnings} /></div></section>}
        {rules.length > 0 && <Evidence rules={rules} />}
        {findings.length > 0 && <section class="panel"><header><h2>{t('findings')}</h2></header><PlacedFindings findings={findings} /></section>}
      </div>
    </>
  );
}

/** The address says which rules are chosen, so that a table can be sent to somebody. */
function Choice({ all, chosen, waits }: { all: readonly ComparedRule[]; chosen: readonly ComparedRule[]; waits: boolean }) {
  const asked = new URLSearchParams(place.value.query);
  const is_sampled = asked.has('uncertainty');
  const put = (rules: readonly ComparedRule[]) => {
    asked.set('rules', rules.map(({ id }) => id).join(','));
    go(`${place.value.path}?${asked}`, 'replace');
  };
  const sample = () => {
    if (is_sampled) asked.delete('uncertainty'); else asked.set('uncertainty', 'monte-carlo');
    go(`${place.value.path}?${asked}`, 'replace');
  };
  const toggled = (rule: ComparedRule) => all.filter((one) => (one === rule) !== chosen.includes(one));
  return (
    <section class="panel no-print" aria-labelledby="rules-chosen">
      <header><h2 id="rules-chosen">{t('rules')}</h2>{chosen.length < all.length && <button type="button" class="link small" onClick={() => put(all)}>{t('all')}</button>}</header>
      <div class="rule-choice">
        {all.map((rule) => (
          <label key={rule.id} title={rule.remark}><input type="checkbox" checked={chosen.includes(rule)} onChange={() => put(toggled(rule))} />{rule.name}</label>
        ))}
      </div>
      <p class="rule-trials">
        <label><input type="checkbox" checked={is_sampled} onChange={sample} />{t('intervals')}</label>
        {waits && <span class="quiet small" role="status">{t('loading')}</span>}
      </p>
    </section>
  );
}
