// SPDX-License-Identifier: Apache-2.0
import type { ComparedRule, Finding } from '../../api/types';
import { sentence } from '../../components/findings';
import { Formula } from '../../components/formula';
import { absent } from '../../numbers';
import { RuleSymbol } from './symbol';
import { t } from './texts';

/** What each figure is called, where it stands, on what our knowledge of it rests, and in what its formula differs. */
export function Evidence({ rules }: { rules: readonly ComparedRule[] }) {
  return (
    <section class="panel flush">
      <header><h2>{t('known')}</h2></header>
      <div class="table-frame" tabIndex={0} role="region" aria-label={t('known')}>
        <table class="rule-evidence">
          <thead>
            <tr>{(['figure', 'symbol', 'clause', 'evidence', 'differs'] as const).map((key) => <th key={key} scope="col">{t(key)}</th>)}</tr>
          </thead>
          {rules.map((rule) => (
            <tbody key={rule.id}>
              <tr><th scope="rowgroup" colSpan={5}>{rule.name} <span class="small quiet">{rule.remark}</span></th></tr>
              {rule.figures.map((figure) => (
                <tr key={figure.key}>
                  <td>{figure.title}</td>
                  <td>{figure.symbol === null ? absent : <RuleSymbol symbol={figure.symbol} />}</td>
                  <td>{figure.clause ?? absent}</td>
                  <td class={figure.checked_against_text ? '' : 'caution-words'}>{figure.evidence_text}</td>
                  <td>{figure.departs_by ?? absent}</td>
                </tr>
              ))}
            </tbody>
          ))}
        </table>
      </div>
    </section>
  );
}

/** Findings whose place is a rule, or a clause of the standard. */
export function PlacedFindings({ findings }: { findings: readonly Finding[] }) {
  return (
    <ul class="findings">
      {findings.map(({ id, message, clause }, i) => (
        <li key={i}><p><Formula text={sentence(message)} /> <span class="quiet small">{clause}</span> <span class="quiet mono small">{id}</span></p></li>
      ))}
    </ul>
  );
}
